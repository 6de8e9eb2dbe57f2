// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/lab/frame_maker.hpp>
#include <tegotae/lab/recording_file.hpp>
#include <tegotae/lab/session.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace tegotae {

/// Records a run from its beginning: the scene, the settings, every tick, and what a page would have shown of it, 60
/// states a second of the run's time. For one thread, that of the run's observer.
class RunRecording {
 public:
  /// Creates or replaces `file`. `session` outlives this; one in real time must be watched. `scene`: its name for
  /// people; `motion`: that of the experiment, or empty.
  RunRecording(const std::filesystem::path& file, Session& session, const std::vector<std::string>& notes,
               const std::string& scene, std::string motion);

  void write(const TickRecord& record);

  /// With a state of the last tick.
  void close();

  const RecordingFile& file() const noexcept { return file_; }
  /// Empty, or one sentence for the user: file, cause, mend.
  std::string error() const { return file_.error(); }

 private:
  void write_state();

  RecordingFile file_;
  Session& session_;
  FrameMaker frames_;
  std::string motion_;
  double time_ = 0.0;        ///< s, of the last tick
  double next_state_ = 0.0;  ///< periods of states since the start
  bool is_current_ = true;   ///< the last state is of the last tick
};

}  // namespace tegotae
