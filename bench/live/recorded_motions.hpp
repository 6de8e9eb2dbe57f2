// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace tegotae::bench {

/// What a live session recorded while one motion played before an unchanging number of viewers.
struct RecordedMotion {
  int viewers = 0;
  double begin = 0.0, end = 0.0;     ///< s, of the session
  std::vector<double> tick_us;       ///< µs, of each tick in between
  std::uint64_t missed = 0;          ///< haptic periods in between
  std::uint64_t in_contact = 0;      ///< ticks with a contact point that pushes
  std::vector<double> gap_ms;        ///< ms from each tick to the next
  std::vector<double> physics_rate;  ///< Hz, as the program measured it, one a state
};

/// All motions of a recording, in their order, each without its first and its last quarter of a second: a viewer that
/// asks for a motion and leaves is no part of it. Where the number of viewers changes, another begins. Throws
/// RecordingError.
std::vector<RecordedMotion> recorded_motions(const std::filesystem::path& recording);

}  // namespace tegotae::bench
