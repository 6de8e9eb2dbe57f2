// SPDX-License-Identifier: Apache-2.0
#include <apps/progress_line.hpp>

#include <unistd.h>

#include <cstdio>
#include <utility>

namespace tegotae {

ProgressLine::ProgressLine(std::string what) : what_(std::move(what)), on_terminal_(isatty(STDERR_FILENO) != 0) {}

// Leaves the terminal's line empty.
ProgressLine::~ProgressLine() {
  if (on_terminal_ && shown_) std::fputs("\r\033[K", stderr);
}

void ProgressLine::show(double part) {
  const auto interval = on_terminal_ ? std::chrono::milliseconds(100) : std::chrono::milliseconds(5000);
  const Clock::time_point now = Clock::now();
  if (now - last_ < interval) return;
  last_ = now;
  shown_ = true;
  std::fprintf(stderr, on_terminal_ ? "\r\033[K%s: %.0f %%" : "%s: %.0f %%\n", what_.c_str(), 100.0 * part);
}

}  // namespace tegotae
