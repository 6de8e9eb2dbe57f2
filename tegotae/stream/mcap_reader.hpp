// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>

namespace tegotae {

/// A recording that cannot be read, with the file and the mend.
class RecordingError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// One message of a recording. Views hold until the next message.
struct McapMessage {
  std::string_view topic;
  std::string_view schema_name;
  std::string_view encoding;  ///< of the data: "json"
  std::uint64_t time = 0;     ///< ns, when it was logged
  std::string_view data;
  std::uint64_t offset = 0;  ///< of the data in the file, bytes
};

/// How the reading of a recording ended.
struct McapEnd {
  bool complete = false;         ///< the file ends as the format asks; else it was cut
  std::uint64_t messages = 0;    ///< read
  std::uint64_t bytes_left = 0;  ///< of a record that is not whole, at the end
};

/// Reads a recording from its beginning, a message at a time, in the order of the file. Where the file was cut, every
/// record that is whole is read. Files with chunks (of other writers) are refused. Throws RecordingError for a file
/// that cannot be read, is no MCAP file or contradicts the format.
McapEnd read_mcap(const std::filesystem::path& file, const std::function<void(const McapMessage&)>& observer);

}  // namespace tegotae
