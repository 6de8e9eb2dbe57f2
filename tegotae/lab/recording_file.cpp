// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/recording_file.hpp>

#include <tegotae/stream/json_text.hpp>
#include <tegotae/stream/mcap_reader.hpp>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <ostream>
#include <sstream>

namespace tegotae {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kRecordingFormat = 1;

std::uint64_t nanoseconds(double time) { return static_cast<std::uint64_t>(std::llround(std::max(time, 0.0) * 1e9)); }

/// Turns messages into the rows of a samples file.
class CsvExport {
 public:
  CsvExport(std::string file, std::ostream& csv) : file_(std::move(file)), csv_(csv) {}

  void take(const McapMessage& message) {
    if (message.topic == kSessionTopic.topic) {
      for (const auto& note : parsed(message).value("notes", Json::array())) {
        if (note.is_string()) notes_.push_back(note.get<std::string>());
      }
    }
    if (message.topic == kTickTopic.topic) write_row(parsed(message));
  }
  std::uint64_t rows() const noexcept { return rows_; }

 private:
  Json parsed(const McapMessage& message) const {
    Json json = Json::parse(message.data, nullptr, false);
    if (!json.is_object()) {
      throw RecordingError(
          fmt::format("{}: a message of {} is no JSON object; the file is damaged.", file_, message.topic));
    }
    return json;
  }

  void write_head(const Json& tick) {
    csv_ << "# tegotae samples, format 1\n";
    for (const std::string& note : notes_) csv_ << "# " << note << '\n';
    std::string names;
    for (const auto& item : tick.items()) names += (names.empty() ? "" : ",") + item.key();
    csv_ << names << '\n';
  }

  void write_row(const Json& tick) {
    if (rows_++ == 0) write_head(tick);
    std::string row;
    for (const auto& item : tick.items()) {
      if (!row.empty()) row += ',';
      if (item.value().is_number()) {
        append_number(row, item.value().get<double>());
      } else {
        row += "nan";
      }
    }
    csv_ << row << '\n';
  }

  std::string file_;
  std::ostream& csv_;
  std::vector<std::string> notes_;
  std::uint64_t rows_ = 0;
};

}  // namespace

RecordingFile::RecordingFile(const std::filesystem::path& file, const std::vector<std::string>& notes, double start,
                             SampleKind kind)
    : writer_(file.string(), "tegotae " TEGOTAE_VERSION), columns_(sample_columns(start, kind)) {
  const int session = add(kSessionTopic, schema_of_session());
  scene_channel_ = add(kSceneTopic, schema_of_scene());
  settings_channel_ = add(kSettingsTopic, schema_of_settings());
  state_channel_ = add(kStateTopic, schema_of_state());
  tick_channel_ = add(kTickTopic, schema_of_tick(kind));
  writer_.write(session, nanoseconds(start), Json{{"format", kRecordingFormat}, {"notes", notes}}.dump());
}

int RecordingFile::add(const RecordingTopic& kind, std::string_view schema) {
  return writer_.add_channel(kind.topic, kind.schema, schema);
}

void RecordingFile::write(const TickRecord& record) {
  JsonText json;
  json.reserve(longest_tick_);
  json.open_object();
  for (const auto& column : columns_) json.key(column.name).number(column.value(record));
  const std::string text = json.close_object().take();
  longest_tick_ = std::max(longest_tick_, text.size());
  writer_.write(tick_channel_, nanoseconds(columns_.front().value(record)), text);
  ++ticks_;
}

void RecordingFile::write_scene(double time, std::string_view message) {
  writer_.write(scene_channel_, nanoseconds(time), message);
}

void RecordingFile::write_settings(double time, std::string_view message) {
  writer_.write(settings_channel_, nanoseconds(time), message);
}

void RecordingFile::write_state(double time, std::string_view message) {
  writer_.write(state_channel_, nanoseconds(time), message);
}

RecordingExport export_csv(const std::filesystem::path& recording, std::ostream& csv) {
  CsvExport rows(recording.string(), csv);
  const McapEnd end = read_mcap(recording, [&](const McapMessage& message) { rows.take(message); });
  if (rows.rows() == 0) {
    throw RecordingError(
        fmt::format("{}: the recording holds no ticks (topic {}).", recording.string(), kTickTopic.topic));
  }
  return {rows.rows(), end.complete};
}

bool is_recording(const std::filesystem::path& file) {
  std::string magic(mcap::kMagic.size(), '\0');
  std::ifstream stream(file, std::ios::binary);
  stream.read(magic.data(), static_cast<std::streamsize>(magic.size()));
  return magic == mcap::kMagic;
}

}  // namespace tegotae
