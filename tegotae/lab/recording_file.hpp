// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/runtime/recorder.hpp>
#include <tegotae/runtime/tick_record.hpp>
#include <tegotae/stream/mcap_writer.hpp>

#include <cstdint>
#include <filesystem>
#include <iosfwd>
#include <string>
#include <vector>

namespace tegotae {

/// A recording of a run: an MCAP file with the topic /tegotae/session (schema tegotae.Session.v1: notes, a line each)
/// once, then /tegotae/tick (schema tegotae.Tick.v1) once a haptic tick, both JSON. A tick has the fields that a
/// samples file has columns, with the same names and units. Whatever cuts the file, what was complete before can be
/// read. A full disk ends the recording and nothing else: see `error`.
class RecordingFile {
 public:
  /// Creates or replaces `file`. `notes`: lines that say what the run was. `start` (s): see `sample_columns`.
  RecordingFile(const std::filesystem::path& file, const std::vector<std::string>& notes, double start);

  void write(const TickRecord& record);
  void close() { writer_.close(); }

  /// Empty, or one sentence for the user: file, cause, mend.
  std::string error() const { return writer_.error(); }

 private:
  McapWriter writer_;
  std::vector<CsvColumn<TickRecord>> columns_;
  int tick_channel_ = 0;
  std::string json_;
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
