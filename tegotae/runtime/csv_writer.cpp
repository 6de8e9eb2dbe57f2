// SPDX-License-Identifier: Apache-2.0
#include <tegotae/runtime/csv_writer.hpp>

#include <charconv>
#include <cmath>
#include <cstdint>
#include <utility>

namespace tegotae {
namespace {

void append_comment(std::string& text, const std::string& comment) {
  text += "# ";
  for (const char c : comment) {
    text += c;
    if (c == '\n') text += "# ";
  }
  text += '\n';
}

std::string head_text(const CsvHead& head) {
  std::string text, units = "units:", names;
  for (std::size_t i = 0; i < head.names.size(); ++i) {
    names += (i == 0 ? "" : ",") + head.names[i];
    if (i < head.units.size() && !head.units[i].empty()) units += " " + head.names[i] + "[" + head.units[i] + "]";
  }
  append_comment(text, head.format);
  for (const auto& comment : head.comments) append_comment(text, comment);
  append_comment(text, units);
  return text + names + '\n';
}

}  // namespace

void append_number(std::string& text, double value) {
  constexpr double kWhole = 0x1p53;  // below it every whole number is a double
  char digits[32];
  std::to_chars_result end{};
  if (std::abs(value) < kWhole && value == std::trunc(value) && !(value == 0.0 && std::signbit(value))) {
    end = std::to_chars(digits, digits + sizeof digits, static_cast<std::int64_t>(value));
  } else {
    end = std::to_chars(digits, digits + sizeof digits, value);
  }
  text.append(digits, end.ptr);
}

CsvWriter::CsvWriter(std::string path, const CsvHead& head) : file_(std::move(path), head_text(head)) {}

void CsvWriter::write_row(std::span<const double> values) {
  row_.clear();
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (i > 0) row_ += ',';
    append_number(row_, values[i]);
  }
  row_ += '\n';
  file_.append(row_);
}

std::string CsvWriter::error() const {
  if (ok()) return {};
  return "Cannot write '" + file_.path() + "': " + file_.cause() + "; it holds " + std::to_string(rows_written()) +
         " complete rows, " + std::to_string(rows_lost()) +
         " are lost. Free space or name a folder that can be written, and run again.";
}

}  // namespace tegotae
