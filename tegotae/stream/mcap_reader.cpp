// SPDX-License-Identifier: Apache-2.0
#include <tegotae/stream/mcap_reader.hpp>

#include <tegotae/stream/mcap_format.hpp>

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <map>
#include <system_error>

namespace tegotae {
namespace {

using mcap::Opcode;

constexpr std::uint8_t kChunk = 0x06;
// Longer records are taken for damage: a scene with large meshes stays far below.
constexpr std::uint64_t kLongestRecord = std::uint64_t{1} << 30;

/// The fields of one record, from its content.
class Fields {
 public:
  Fields(std::string_view content, const std::string& file) : content_(content), file_(file) {}

  template <class Number>
  Number number() {
    const std::string_view field = take(sizeof(Number));
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < field.size(); ++i) {
      value |= static_cast<std::uint64_t>(static_cast<unsigned char>(field[i])) << (8 * i);
    }
    return static_cast<Number>(value);
  }
  std::string_view text() { return take(number<std::uint32_t>()); }
  std::string_view rest() { return take(content_.size()); }

 private:
  std::string_view take(std::size_t length) {
    if (length > content_.size()) {
      throw RecordingError(
          fmt::format("{}: a record is shorter than what it says of itself; the file is damaged.", file_));
    }
    const std::string_view field = content_.substr(0, length);
    content_.remove_prefix(length);
    return field;
  }

  std::string_view content_;
  const std::string& file_;
};

struct Channel {
  std::uint16_t schema = 0;
  std::string topic, encoding;
};

/// What the records read so far have defined.
class Definitions {
 public:
  explicit Definitions(std::string file) : file_(std::move(file)) {}

  void read_schema(std::string_view content) {
    Fields fields(content, file_);
    const auto id = fields.number<std::uint16_t>();
    schemas_[id] = fields.text();
  }
  void read_channel(std::string_view content) {
    Fields fields(content, file_);
    const auto id = fields.number<std::uint16_t>();
    Channel& channel = channels_[id];
    channel.schema = fields.number<std::uint16_t>();
    channel.topic = fields.text();
    channel.encoding = fields.text();
  }
  McapMessage message(std::string_view content) const {
    Fields fields(content, file_);
    const auto channel = channels_.find(fields.number<std::uint16_t>());
    if (channel == channels_.end()) {
      throw RecordingError(fmt::format("{}: a message of a channel that is not defined; the file is damaged.", file_));
    }
    fields.number<std::uint32_t>();  // its number in the channel
    McapMessage message;
    message.time = fields.number<std::uint64_t>();
    fields.number<std::uint64_t>();  // when it was published
    message.data = fields.rest();
    message.topic = channel->second.topic;
    message.encoding = channel->second.encoding;
    const auto schema = schemas_.find(channel->second.schema);
    if (schema != schemas_.end()) message.schema_name = schema->second;
    return message;
  }
  const std::string& file() const noexcept { return file_; }

 private:
  std::string file_;
  std::map<std::uint16_t, std::string> schemas_;
  std::map<std::uint16_t, Channel> channels_;
};

std::ifstream opened(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream || std::filesystem::is_directory(file)) {
    const int cause = stream ? EISDIR : errno;
    throw RecordingError(
        fmt::format("{}: the recording cannot be read: {}.", file.string(), std::generic_category().message(cause)));
  }
  std::string magic(mcap::kMagic.size(), '\0');
  stream.read(magic.data(), static_cast<std::streamsize>(magic.size()));
  if (magic != mcap::kMagic) {
    throw RecordingError(
        fmt::format("{}: this is no MCAP recording; 'tegotae experiment' makes one with --record.", file.string()));
  }
  return stream;
}

}  // namespace

McapEnd read_mcap(const std::filesystem::path& file, const std::function<void(const McapMessage&)>& observer) {
  std::ifstream stream = opened(file);
  const std::uint64_t size = std::filesystem::file_size(file);
  Definitions definitions(file.string());
  McapEnd end;
  std::uint64_t at = mcap::kMagic.size();
  constexpr std::uint64_t kHead = 1 + sizeof(std::uint64_t);
  std::string head(kHead, '\0'), content;
  while (at + kHead <= size) {
    stream.read(head.data(), static_cast<std::streamsize>(kHead));
    const auto opcode = static_cast<std::uint8_t>(head[0]);
    const auto length = Fields(std::string_view(head).substr(1), definitions.file()).number<std::uint64_t>();
    if (length > kLongestRecord) {
      throw RecordingError(fmt::format("{}: a record at byte {} claims {} bytes; the file is damaged there.",
                                       file.string(), at, length));
    }
    if (at + kHead + length > size) break;
    content.resize(length);
    stream.read(content.data(), static_cast<std::streamsize>(length));
    at += kHead + length;
    if (opcode == static_cast<std::uint8_t>(Opcode::kSchema)) definitions.read_schema(content);
    if (opcode == static_cast<std::uint8_t>(Opcode::kChannel)) definitions.read_channel(content);
    if (opcode == static_cast<std::uint8_t>(Opcode::kMessage)) {
      McapMessage message = definitions.message(content);
      message.offset = at - message.data.size();
      observer(message);
      ++end.messages;
    }
    if (opcode == kChunk) {
      throw RecordingError(fmt::format(
          "{}: the recording holds chunks, which are not read here; take one that tegotae wrote.", file.string()));
    }
    if (opcode == static_cast<std::uint8_t>(Opcode::kDataEnd)) {
      end.complete = true;
      return end;
    }
  }
  end.bytes_left = size - at;
  return end;
}

}  // namespace tegotae
