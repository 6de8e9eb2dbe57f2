// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/runtime/block_file.hpp>
#include <tegotae/stream/mcap_format.hpp>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace tegotae {

/// Writes a recording in the MCAP container, which Foxglove and the tools of ROS 2 read. For threads that may wait for
/// the disk. Never throws on a full disk or a bad path: `error` then says what happened; what is on disk ends with its
/// last complete record and can be read up to there.
class McapWriter {
 public:
  /// Creates or overwrites the file. `library`: who writes, for the header.
  McapWriter(std::string path, std::string_view library);
  McapWriter(const McapWriter&) = delete;
  McapWriter& operator=(const McapWriter&) = delete;
  ~McapWriter();

  /// A kind of messages: JSON objects described by a JSON schema. Returns its channel, for `write`.
  int add_channel(std::string_view topic, std::string_view schema_name, std::string_view json_schema);

  /// Adds one message of a channel, `time` in nanoseconds.
  void write(int channel, std::uint64_t time, std::string_view json);

  /// Ends the file as the format asks and closes it; what is written after it is lost.
  void close();

  bool ok() const noexcept { return file_.ok(); }
  /// Empty, or one sentence for the user with file, cause, and mend.
  std::string error() const;

 private:
  struct Channel {
    std::uint64_t count = 0;
  };

  BlockFile file_;
  std::string record_;
  std::vector<Channel> channels_;
  std::uint64_t message_count_ = 0;
  std::uint64_t first_time_ = 0, last_time_ = 0;
  std::uint64_t bytes_ = 0;  ///< of the file so far
  std::string definitions_;  ///< schemas and channels, repeated at the end
};

}  // namespace tegotae
