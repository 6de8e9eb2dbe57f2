// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/recording_file.hpp>
#include <tegotae/lab/samples_file.hpp>
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

constexpr const char* kSessionTopic = "/tegotae/session";
constexpr const char* kTickTopic = "/tegotae/tick";
constexpr const char* kSessionSchema = "tegotae.Session.v1";
constexpr const char* kTickSchema = "tegotae.Tick.v1";

std::string schema_of_session() {
  return Json{{"title", kSessionSchema},
              {"type", "object"},
              {"properties",
               {{"format", {{"type", "integer"}, {"description", "version of the recording's format"}}},
                {"notes", {{"type", "array"}, {"items", {{"type", "string"}}}}}}}}
      .dump();
}

std::string schema_of_tick(const std::vector<CsvColumn<TickRecord>>& columns) {
  Json properties;
  for (const auto& column : columns) {
    properties[column.name] = {{"type", "number"}};
    if (!column.unit.empty()) properties[column.name]["description"] = "in " + column.unit;
  }
  return Json{{"title", kTickSchema}, {"type", "object"}, {"properties", properties}}.dump();
}

std::uint64_t nanoseconds(double time) { return static_cast<std::uint64_t>(std::llround(std::max(time, 0.0) * 1e9)); }

// JSON has no number that is not finite.
void append_json_number(std::string& text, double value) {
  if (std::isfinite(value)) {
    append_number(text, value);
  } else {
    text += "null";
  }
}

/// Turns messages into the rows of a samples file.
class CsvExport {
 public:
  CsvExport(std::string file, std::ostream& csv) : file_(std::move(file)), csv_(csv) {}

  void take(const McapMessage& message) {
    if (message.topic == kSessionTopic) {
      for (const auto& note : parsed(message).value("notes", Json::array())) notes_.push_back(note.get<std::string>());
    }
    if (message.topic == kTickTopic) write_row(parsed(message));
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

RecordingFile::RecordingFile(const std::filesystem::path& file, const std::vector<std::string>& notes, double start)
    : writer_(file.string(), "tegotae " TEGOTAE_VERSION), columns_(sample_columns(start)) {
  const int session = writer_.add_channel(kSessionTopic, kSessionSchema, schema_of_session());
  tick_channel_ = writer_.add_channel(kTickTopic, kTickSchema, schema_of_tick(columns_));
  writer_.write(session, nanoseconds(start), Json{{"format", 1}, {"notes", notes}}.dump());
}

void RecordingFile::write(const TickRecord& record) {
  json_.assign(1, '{');
  for (const auto& column : columns_) {
    json_ += json_.size() > 1 ? ",\"" : "\"";
    json_ += column.name;
    json_ += "\":";
    append_json_number(json_, column.value(record));
  }
  json_ += '}';
  writer_.write(tick_channel_, nanoseconds(columns_.front().value(record)), json_);
}

RecordingExport export_csv(const std::filesystem::path& recording, std::ostream& csv) {
  CsvExport rows(recording.string(), csv);
  const McapEnd end = read_mcap(recording, [&](const McapMessage& message) { rows.take(message); });
  if (rows.rows() == 0) {
    throw RecordingError(fmt::format("{}: the recording holds no ticks (topic {}).", recording.string(), kTickTopic));
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
