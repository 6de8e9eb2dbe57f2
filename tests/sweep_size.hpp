// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

namespace tegotae::test {

// Sanitizers slow a sweep ten to thirty times and find their faults in the first few thousand cases.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr int kSweepDivisor = 50;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer) || __has_feature(undefined_behavior_sanitizer)
inline constexpr int kSweepDivisor = 50;
#else
inline constexpr int kSweepDivisor = 1;
#endif
#else
inline constexpr int kSweepDivisor = 1;
#endif

/// How many cases of a random sweep to run: `full` in an ordinary build, a fiftieth under a sanitizer, but four at
/// least (cases may be long runs of their own).
constexpr int sweep_size(int full) { return std::max(full / kSweepDivisor, std::min(full, 4)); }

}  // namespace tegotae::test
