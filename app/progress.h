// SPDX-License-Identifier: GPL-3.0-or-later
// How far a long run has come, on standard error; and whether the user wants it to stop.
#pragma once

#include <chrono>
#include <cstddef>

namespace psm {

/// On a terminal one line that changes, a few times a second; elsewhere a line every half minute.
class Progress {
 public:
  explicit Progress(std::size_t total);
  ~Progress();
  void finished_one();

 private:
  using Clock = std::chrono::steady_clock;
  bool terminal_ = false, shown_ = false;
  std::size_t total_ = 0, finished_ = 0;
  Clock::time_point start_, last_;
};

/// While it lives, Ctrl-C (and a polite kill) asks instead of ending the program; a second one ends it.
class Interruptible {
 public:
  Interruptible();
  ~Interruptible();
  static bool asked();
};

}  // namespace psm
