// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace tegotae {

/// Tells from a device's ticks when a person should hear that it is silent, or back. A call that fails now and then is
/// not worth a word: both are said only of a state that has lasted.
class DeviceWatch {
 public:
  static constexpr double kLasting = 0.25;  ///< s

  enum class News { kNone, kSilent, kBack };

  /// `time` in s, rising; `silent`: this tick had no pose that could be used.
  News see(double time, bool silent) noexcept;

 private:
  bool is_silent_ = false;  ///< as it was told last
  bool differs_ = false;    ///< what is seen, from what was told
  double since_ = 0.0;      ///< s, when that began
};

}  // namespace tegotae
