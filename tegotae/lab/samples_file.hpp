// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/runtime/recorder.hpp>
#include <tegotae/runtime/tick_record.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace tegotae {

/// Whether a run has the columns of a simulated interface in closed loop.
enum class SampleKind : bool { kPlayed, kClosedLoop };

/// The columns of a samples file, in their order: time and pose, the method's wrench, then what else is useful;
/// `tick_us`, the one that does not repeat, is the last. `start` (s) is added to the time of each record, to the
/// nanosecond.
std::vector<CsvColumn<TickRecord>> sample_columns(double start, SampleKind kind = SampleKind::kPlayed);

/// Writes one row a haptic tick. The head, in comments, holds the format's version, the notes, what the columns mean
/// and their units. All members throw InputError if the file cannot be written.
class SamplesFile {
 public:
  /// Creates or replaces `file`. `notes`: lines for the head.
  SamplesFile(const std::filesystem::path& file, std::vector<std::string> notes, double start,
              SampleKind kind = SampleKind::kPlayed);

  void write(const TickRecord& record);

  /// Writes what is still held back. Without it a full disk would go unnoticed.
  void close();

 private:
  void check() const;

  CsvRecorder<TickRecord> recorder_;
};

}  // namespace tegotae
