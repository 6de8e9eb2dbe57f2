// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/runtime/csv_writer.hpp>

#include <cstddef>
#include <functional>
#include <string>
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

/// Writes records as rows of a CSV file, at once: for threads that may wait for the disk.
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

}  // namespace tegotae
