// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/smooth_path.hpp>

#include <tegotae/lab/motion.hpp>

#include <algorithm>
#include <iterator>
#include <stdexcept>

namespace tegotae {

SmoothPath::SmoothPath(std::initializer_list<Key> keys) : keys_(keys) {
  const auto not_later = [](const Key& a, const Key& b) { return b.time <= a.time; };
  if (keys_.empty() || std::adjacent_find(keys_.begin(), keys_.end(), not_later) != keys_.end()) {
    throw std::invalid_argument("a path needs keys at times that ascend");
  }
}

double SmoothPath::at(double time) const noexcept {
  const auto next = std::find_if(keys_.begin(), keys_.end(), [time](const Key& key) { return key.time > time; });
  if (next == keys_.begin()) return keys_.front().value;
  if (next == keys_.end()) return keys_.back().value;
  const Key& last = *std::prev(next);
  return SmoothStep{last.time, next->time, last.value, next->value}.at(time);
}

}  // namespace tegotae
