// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/runtime/csv_writer.hpp>
#include <tegotae/runtime/spsc_ring.hpp>

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace tegotae {

/// One column of a recording, as data.
template <class Record>
struct CsvColumn {
  std::string name;
  std::string unit;  ///< empty: none
  std::function<double(const Record&)> value;
};

/// Writes records as rows of a CSV file, at once: for simulated time, where the caller may wait for the disk.
template <class Record>
class CsvRecorder {
 public:
  /// `comments`: lines for the head of the file. Errors come by `writer().error()`, never by exception.
  CsvRecorder(std::string path, std::vector<CsvColumn<Record>> columns, std::vector<std::string> comments = {})
      : columns_(std::move(columns)),
        row_(columns_.size()),
        writer_(std::move(path), head_of(columns_, std::move(comments))) {}

  void record(const Record& record) {
    for (std::size_t i = 0; i < columns_.size(); ++i) row_[i] = columns_[i].value(record);
    writer_.write_row(row_);
  }
  void close() { writer_.close(); }
  const CsvWriter& writer() const noexcept { return writer_; }

 private:
  static CsvHead head_of(const std::vector<CsvColumn<Record>>& columns, std::vector<std::string> comments) {
    CsvHead head;
    head.comments = std::move(comments);
    for (const auto& column : columns) {
      head.names.push_back(column.name);
      head.units.push_back(column.unit);
    }
    return head;
  }

  std::vector<CsvColumn<Record>> columns_;
  std::vector<double> row_;
  CsvWriter writer_;
};

/// Takes records from a real-time thread and writes them on a thread of its own. The real-time thread never waits: a
/// record that finds the ring full is dropped and counted.
template <class Record>
class RecordThread {
 public:
  /// `min_capacity`: records between the threads. 8192 bridges 8 s of a stalled disk at 1 kHz.
  explicit RecordThread(CsvRecorder<Record>& recorder, std::size_t min_capacity = 8192)
      : recorder_(recorder), ring_(min_capacity), thread_([this] { run(); }) {}
  RecordThread(const RecordThread&) = delete;
  RecordThread& operator=(const RecordThread&) = delete;
  ~RecordThread() { stop(); }

  /// The real-time thread, and no other: false if the record was dropped. Wait-free, does not allocate.
  bool push(const Record& record) noexcept { return ring_.push(record); }

  /// Writes all that was pushed and ends the thread; the recorder is the caller's again. Call it once no more is
  /// pushed.
  void stop() {
    stopping_.store(true, std::memory_order_release);
    if (thread_.joinable()) thread_.join();
  }

  std::uint64_t dropped() const noexcept { return ring_.dropped(); }

 private:
  // Between looks at the ring: the writer is not woken by the real-time thread, as that would take a system call there.
  static constexpr std::chrono::milliseconds kPause{5};

  void run() {
    for (;;) {
      const bool last = stopping_.load(std::memory_order_acquire);  // before the ring is emptied for the last time
      Record record;
      while (ring_.pop(record)) recorder_.record(record);
      if (last) return;
      std::this_thread::sleep_for(kPause);
    }
  }

  CsvRecorder<Record>& recorder_;
  SpscRing<Record> ring_;
  std::atomic<bool> stopping_{false};
  std::thread thread_;  // last, so that it starts when all else stands
};

}  // namespace tegotae
