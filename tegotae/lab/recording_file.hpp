// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/lab/recording_schemas.hpp>
#include <tegotae/runtime/recorder.hpp>
#include <tegotae/runtime/tick_record.hpp>
#include <tegotae/stream/mcap_writer.hpp>

#include <cstdint>
#include <filesystem>
#include <iosfwd>
#include <string>
#include <string_view>
#include <vector>

namespace tegotae {

/// A recording of a run, an MCAP file that docs/recordings.md describes: notes on the run, then what the live view
/// showed (`scene`, `settings` and `state` messages) and every haptic tick, each kind on a topic of its own. A tick has
/// the fields that a samples file has columns, with the same names and units. Whatever cuts the file, what was complete
/// before can be read. A full disk ends the recording and nothing else: see `error`. For one thread, which may wait for
/// the disk.
class RecordingFile {
 public:
  /// Creates or replaces `file`. `notes`: lines that say what the run was. `start` (s): see `sample_columns`.
  RecordingFile(const std::filesystem::path& file, const std::vector<std::string>& notes, double start,
                SampleKind kind = SampleKind::kPlayed);

  void write(const TickRecord& record);

  // Messages of the live view as they are (docs/live-view.md), at `time` (s) on the axis that `start` begins. The scene
  // and the settings before the first state, and again where they change.

  void write_scene(double time, std::string_view message);
  void write_settings(double time, std::string_view message);
  void write_state(double time, std::string_view message);

  void close() { writer_.close(); }

  std::uint64_t ticks() const noexcept { return ticks_; }  ///< given to `write`
  bool ok() const noexcept { return writer_.ok(); }
  /// Empty, or one sentence for the user: file, cause, mend.
  std::string error() const { return writer_.error(); }

 private:
  int add(const RecordingTopic& kind, std::string_view schema);

  McapWriter writer_;
  std::vector<CsvColumn<TickRecord>> columns_;
  int scene_channel_ = 0, settings_channel_ = 0, state_channel_ = 0, tick_channel_ = 0;
  std::uint64_t ticks_ = 0;
  std::size_t longest_tick_ = 0;  ///< bytes
};

/// What an export came to.
struct RecordingExport {
  std::uint64_t ticks = 0;
  bool complete = true;  ///< else the recording was cut, and everything before the cut was exported
};

/// Writes the ticks of a recording as the samples file that the run would have written. Throws RecordingError where the
/// recording cannot be read or holds no ticks.
RecordingExport export_csv(const std::filesystem::path& recording, std::ostream& csv);

/// Whether the file begins as a recording does. False where it cannot be read.
bool is_recording(const std::filesystem::path& file);

}  // namespace tegotae
