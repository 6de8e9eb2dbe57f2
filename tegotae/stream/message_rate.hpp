// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>

namespace tegotae {

/// Counts what comes in windows of one second.
class MessageRate {
 public:
  using Time = std::chrono::steady_clock::time_point;

  explicit MessageRate(int most_per_second) : most_(most_per_second) {}

  /// One more, at `now`, which never goes back. False: more than allowed within this window.
  bool count(Time now) noexcept {
    if (count_ == 0 || now - window_ >= std::chrono::seconds(1)) {
      window_ = now;
      count_ = 0;
    }
    return ++count_ <= most_;
  }

 private:
  int most_;
  int count_ = 0;
  Time window_{};
};

}  // namespace tegotae
