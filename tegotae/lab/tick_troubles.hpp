// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/runtime/tick_record.hpp>

#include <cstdint>
#include <map>
#include <string>

namespace tegotae {

/// What went wrong in the ticks of a run, counted.
class TickTroubles {
 public:
  void add(const TickRecord& record);

  /// A sentence with the counts of what happened; empty: nothing.
  std::string sentence() const;

 private:
  std::uint64_t ticks_ = 0;
  std::map<std::string, std::uint64_t> statuses_;  // of the method, but ok
  std::uint64_t dropped_ = 0;                      // planes and points beyond the model's capacity
  std::uint64_t saturated_ = 0;                    // ticks in which the safety stage cut force or torque to its limit
};

}  // namespace tegotae
