// SPDX-License-Identifier: GPL-3.0-or-later
// One task a row, on all cores.
#pragma once

#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

namespace psm {

/// Calls f(row) once for each row in [0, rows), from several threads.
template <class F>
void for_each_row(int rows, const F& f) {
  std::atomic<int> next = 0;
  const auto work = [&] {
    for (int row = next++; row < rows; row = next++) f(row);
  };
  std::vector<std::thread> others(std::size_t(std::clamp(int(std::thread::hardware_concurrency()), 1, std::max(rows, 1)) - 1));
  for (std::thread& thread : others) thread = std::thread(work);
  work();
  for (std::thread& thread : others) thread.join();
}

}  // namespace psm
