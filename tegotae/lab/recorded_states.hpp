// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace tegotae {

/// What a recording holds for a page, found in the file when it is asked for: in memory stand times and places alone,
/// 24 bytes a state, so that a run of hours can be gone through.
class RecordedStates {
 public:
  /// Reads through the file once. Throws RecordingError where it cannot be read or holds no states.
  explicit RecordedStates(const std::filesystem::path& file);

  std::size_t count() const noexcept { return states_.size(); }
  double start() const noexcept { return states_.front().time; }  ///< s, of the first state
  double end() const noexcept { return states_.back().time; }     ///< s, of the last one
  bool is_complete() const noexcept { return complete_; }  ///< else the file was cut; all before the cut is there

  /// The last state at or before `time` (s), the first one where there is none. Where the recorded time goes back, as a
  /// run was begun again, the one here goes on from the state before.
  std::size_t at(double time) const noexcept;
  double time_of(std::size_t state) const noexcept { return states_[state].time; }
  std::string message(std::size_t state);

  /// Which scene and settings hold at a state: their number, or -1 where there are none.
  int scene_at(std::size_t state) const noexcept { return before(scenes_, states_[state].offset); }
  int settings_at(std::size_t state) const noexcept { return before(settings_, states_[state].offset); }
  std::string scene(int number) { return read(scenes_[static_cast<std::size_t>(number)]); }
  std::string settings(int number) { return read(settings_[static_cast<std::size_t>(number)]); }

 private:
  struct Place {
    double time = 0.0;  ///< s
    std::uint64_t offset = 0;
    std::uint32_t length = 0;
  };

  static int before(const std::vector<Place>& places, std::uint64_t offset) noexcept;
  std::string read(const Place& place);

  std::filesystem::path path_;
  std::ifstream file_;
  std::vector<Place> states_, scenes_, settings_;
  bool complete_ = false;
};

}  // namespace tegotae
