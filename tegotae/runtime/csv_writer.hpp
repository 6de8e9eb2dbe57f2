// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/runtime/block_file.hpp>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace tegotae {

/// What stands above the rows of a CSV file.
struct CsvHead {
  std::string format = "tegotae samples, format 1";  ///< name and version of the format: the first line, after "# "
  std::vector<std::string> comments;                 ///< further lines beginning with "# "
  std::vector<std::string> names;                    ///< of the columns, without commas: the header row
  std::vector<std::string> units;                    ///< of the columns, empty: none; all in one comment line
};

/// Writes rows of numbers to a file, in blocks of complete rows. Numbers are printed in the shortest form that reads
/// back to the same double (whole numbers below 2^53 without exponent), independent of locale, so equal rows are equal
/// bytes.
///
/// Never throws on a full disk or a bad path: `error` then says what happened and how to mend it, what is on disk stays
/// and is cut back to its last complete row, and further rows are counted as lost.
class CsvWriter {
 public:
  /// Creates or overwrites the file and writes its head.
  CsvWriter(std::string path, const CsvHead& head);

  /// Adds one row; `values` has one number a column.
  void write_row(std::span<const double> values);

  /// Hands all rows to the operating system and closes the file; write_row after it loses the row.
  void close() { file_.close(); }

  bool ok() const noexcept { return file_.ok(); }
  /// Empty, or one sentence for the user with file, cause, and mend.
  std::string error() const;
  std::uint64_t rows_written() const noexcept { return file_.written(); }  ///< complete rows handed to the system
  std::uint64_t rows_lost() const noexcept { return file_.lost(); }

 private:
  BlockFile file_;
  std::string row_;
};

/// Appends `value` to `text` as CsvWriter prints it.
void append_number(std::string& text, double value);

}  // namespace tegotae
