// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace tegotae::bench {

/// What viewers got while they were measured.
struct ViewerFigures {
  std::vector<double> ages;     ///< ms, of each state when it had been read
  std::uint64_t bytes = 0;      ///< of all frames to all viewers, their heads included
  std::uint64_t left_out = 0;   ///< states that a viewer did not get, as it took a newer one
  double seconds = 0.0;         ///< that were measured
  double processor_time = 0.0;  ///< s, of this process in that time

  void add(const ViewerFigures& other);
};

/// Viewers of the live view, each with a WebSocket of its own, that read whatever they get on one thread of theirs.
class Viewers {
 public:
  /// They are connected when this returns. Throws boost::system::system_error where they are refused.
  Viewers(std::uint16_t port, int count);
  /// They leave.
  ~Viewers();
  Viewers(const Viewers&) = delete;
  Viewers& operator=(const Viewers&) = delete;

  void begin_measuring();
  ViewerFigures end_measuring();

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

/// Lets the hand of the program at `port` play a scripted motion, as a viewer that leaves as soon as a state says that
/// it plays.
void play_motion(std::uint16_t port, const std::string& name);

}  // namespace tegotae::bench
