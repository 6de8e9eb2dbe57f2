// SPDX-License-Identifier: Apache-2.0
#include <tegotae/stream/mcap_writer.hpp>

#include <algorithm>
#include <utility>

namespace tegotae {
namespace {

using mcap::Opcode;

/// Puts one record together.
class RecordText {
 public:
  explicit RecordText(Opcode opcode) {
    text_ += static_cast<char>(opcode);
    number<std::uint64_t>(0);
  }

  template <class Number>
  RecordText& number(Number value) {
    for (std::size_t i = 0; i < sizeof value; ++i) text_ += static_cast<char>(value >> (8 * i) & 0xff);
    return *this;
  }
  RecordText& text(std::string_view value) {
    number(static_cast<std::uint32_t>(value.size()));
    return bytes(value);
  }
  RecordText& bytes(std::string_view value) {
    text_ += value;
    return *this;
  }

  /// With the length of the content in its place.
  std::string take() {
    const std::uint64_t length = text_.size() - kContent;
    for (std::size_t i = 0; i < sizeof length; ++i) text_[1 + i] = static_cast<char>(length >> (8 * i) & 0xff);
    return std::move(text_);
  }

 private:
  static constexpr std::size_t kContent = 1 + sizeof(std::uint64_t);
  std::string text_;
};

std::string head_of(std::string_view library) {
  return std::string(mcap::kMagic) + RecordText(Opcode::kHeader).text("").text(library).take();
}

}  // namespace

McapWriter::McapWriter(std::string path, std::string_view library)
    : file_(std::move(path), head_of(library)), bytes_(head_of(library).size()) {}

McapWriter::~McapWriter() { close(); }

int McapWriter::add_channel(std::string_view topic, std::string_view schema_name, std::string_view json_schema) {
  const int channel = static_cast<int>(channels_.size());
  channels_.emplace_back();
  const auto id = static_cast<std::uint16_t>(channel + 1);  // schema 0 is reserved
  std::string records =
      RecordText(Opcode::kSchema).number(id).text(schema_name).text("jsonschema").text(json_schema).take();
  records +=
      RecordText(Opcode::kChannel).number(id).number(id).text(topic).text("json").number<std::uint32_t>(0).take();
  file_.append(records);
  bytes_ += records.size();
  definitions_ += records;
  return channel;
}

void McapWriter::write(int channel, std::uint64_t time, std::string_view json) {
  Channel& of_message = channels_[static_cast<std::size_t>(channel)];
  const auto id = static_cast<std::uint16_t>(channel + 1);
  const auto sequence = static_cast<std::uint32_t>(of_message.count++);
  record_ = RecordText(Opcode::kMessage).number(id).number(sequence).number(time).number(time).bytes(json).take();
  first_time_ = message_count_ == 0 ? time : std::min(first_time_, time);
  last_time_ = std::max(last_time_, time);
  ++message_count_;
  bytes_ += record_.size();
  file_.append(record_);
}

void McapWriter::close() {
  if (!file_.is_open()) return;
  // No checksums: 0 says that there is none.
  std::string end = RecordText(Opcode::kDataEnd).number<std::uint32_t>(0).take();
  const std::uint64_t summary = bytes_ + end.size();
  end += definitions_;
  RecordText statistics(Opcode::kStatistics);
  const auto kinds = static_cast<std::uint16_t>(channels_.size());
  statistics.number(message_count_).number(kinds).number<std::uint32_t>(kinds);
  statistics.number<std::uint32_t>(0).number<std::uint32_t>(0).number<std::uint32_t>(0);
  statistics.number(first_time_).number(last_time_);
  statistics.number(static_cast<std::uint32_t>(channels_.size() * (sizeof(std::uint16_t) + sizeof(std::uint64_t))));
  for (std::size_t i = 0; i < channels_.size(); ++i) {
    statistics.number(static_cast<std::uint16_t>(i + 1)).number(channels_[i].count);
  }
  end += statistics.take();
  end += RecordText(Opcode::kFooter).number(summary).number<std::uint64_t>(0).number<std::uint32_t>(0).take();
  end += mcap::kMagic;
  file_.append(end);
  file_.close();
}

std::string McapWriter::error() const {
  if (ok()) return {};
  return "Cannot write the recording '" + file_.path() + "': " + file_.cause() + "; it ends with its last complete " +
         "record, " + std::to_string(file_.lost()) + " are lost. Free space or name a folder that can be written.";
}

}  // namespace tegotae
