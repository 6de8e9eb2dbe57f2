// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace tegotae {

/// A file that grows by complete units (rows, records), handed to the operating system in blocks. For threads that may
/// wait for the disk.
///
/// Never throws on a full disk or a bad path: what is on disk stays and is cut back to its last complete unit, and
/// further units are counted as lost.
class BlockFile {
 public:
  /// Creates or overwrites the file and writes `head`, which is no unit, at once.
  BlockFile(std::string path, std::string head);
  BlockFile(const BlockFile&) = delete;
  BlockFile& operator=(const BlockFile&) = delete;
  ~BlockFile();

  /// Adds one unit.
  void append(std::string_view unit);

  /// Hands all units to the operating system.
  void flush();

  /// Flushes and closes; what is appended after it is lost.
  void close();

  bool is_open() const noexcept { return file_ >= 0; }
  bool ok() const noexcept { return error_number_ == 0; }
  /// What went wrong, in the system's words; empty: nothing.
  std::string cause() const;
  const std::string& path() const noexcept { return path_; }
  std::uint64_t written() const noexcept { return written_; }  ///< complete units handed over to the system
  std::uint64_t lost() const noexcept { return lost_; }

 private:
  void fail(int error_number, std::size_t written);

  std::string path_;
  std::string block_;              // complete units that are not written yet
  std::vector<std::size_t> ends_;  // of the units in the block
  std::uint64_t bytes_written_ = 0;
  std::uint64_t written_ = 0;
  std::uint64_t lost_ = 0;
  int file_ = -1;
  int error_number_ = 0;
};

}  // namespace tegotae
