// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/progress.h"

#include <unistd.h>

#include <csignal>
#include <cstdio>

namespace psm {
namespace {

volatile std::sig_atomic_t g_asked = 0;

extern "C" void ask(int signal) {
  g_asked = 1;
  std::signal(signal, SIG_DFL);  // the next one ends the program
}

}  // namespace

Progress::Progress(std::size_t total)
    : terminal_(isatty(STDERR_FILENO) == 1), total_(total), start_(Clock::now()), last_(start_) {}

Progress::~Progress() {
  if (terminal_ && shown_) std::fprintf(stderr, "\r%40s\r", "");
}

void Progress::finished_one() {
  ++finished_;
  const auto now = Clock::now();
  if (now - last_ < (terminal_ ? std::chrono::milliseconds(300) : std::chrono::milliseconds(30000))) return;
  last_ = now;
  shown_ = true;
  const double spent = std::chrono::duration<double>(now - start_).count();
  const int left = int(spent / double(finished_) * double(total_ - finished_));
  std::fprintf(stderr, "%s%zu of %zu runs, about %d:%02d to go%s", terminal_ ? "\r" : "", finished_, total_, left / 60, left % 60,
               terminal_ ? "   " : "\n");
  std::fflush(stderr);
}

Interruptible::Interruptible() {
  g_asked = 0;
  std::signal(SIGINT, ask);
  std::signal(SIGTERM, ask);
}

Interruptible::~Interruptible() {
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
}

bool Interruptible::asked() { return g_asked != 0; }

}  // namespace psm
