// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <initializer_list>
#include <vector>

namespace tegotae {

/// A value that passes through keys and rests at each: from one to the next it goes as a SmoothStep, and it is held
/// before the first and after the last.
class SmoothPath {
 public:
  struct Key {
    double time = 0.0;  ///< s
    double value = 0.0;
  };

  /// Throws std::invalid_argument unless there is a key and the times ascend strictly. Allocates.
  SmoothPath(std::initializer_list<Key> keys);

  double at(double time) const noexcept;

 private:
  std::vector<Key> keys_;
};

}  // namespace tegotae
