// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/lab/recorded_states.hpp>
#include <tegotae/stream/viewer_command.hpp>

#include <cstdint>
#include <filesystem>
#include <string>

namespace tegotae {

/// A recording that is shown as if it happened now: what is sent to the pages, and what their commands do to it. Its
/// time runs from 0, the first state of the recording, to `duration`. Knows no sockets and no clock. For one thread.
class ReplaySession {
 public:
  /// Plays from the beginning. Throws RecordingError where the file cannot be read or holds nothing to show.
  explicit ReplaySession(const std::filesystem::path& file);

  double duration() const noexcept { return states_.end() - states_.start(); }  ///< s
  double time() const noexcept { return time_; }                                ///< s
  bool is_paused() const noexcept { return paused_; }
  bool is_complete() const noexcept { return states_.is_complete(); }

  /// `scene` and `settings` as they hold now, for who joins; settings: empty where the recording has none.
  std::string scene_message();
  std::string settings_message();

  /// Obeys a page's command: play, pause, resume, seek, reset (to the beginning). Returns an empty text, or one
  /// sentence for the page on why not.
  std::string obey(const ViewerCommand& command);

  /// Lets `elapsed` (s, of the clock on the wall) go by. At the end it pauses.
  void advance(double elapsed) noexcept;

  /// Which scene and settings of the recording those are: they change where these do.
  int scene_number() const noexcept { return states_.scene_at(state()); }
  int settings_number() const noexcept { return states_.settings_at(state()); }

  /// The state to show now: as recorded, but for its number, its times, and what is said of pause, recording, hand and
  /// viewers. `made_ms`: see ViewFrame. Throws RecordingError where the file can no longer be read.
  std::string state_message(int viewers, double made_ms);

 private:
  std::size_t state() const noexcept { return states_.at(states_.start() + time_); }

  std::string file_;
  RecordedStates states_;
  double time_ = 0.0;   ///< s
  double speed_ = 1.0;  ///< seconds of the recording a second
  bool paused_ = false;
  std::uint64_t sent_ = 0;
};

}  // namespace tegotae
