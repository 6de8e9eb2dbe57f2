// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/trajectory_file.hpp>

#include <tegotae/lab/input_error.hpp>
#include <tegotae/lab/recording_file.hpp>
#include <tegotae/lab/tolerances.hpp>

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <fstream>
#include <optional>
#include <sstream>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

namespace tegotae {
namespace {

constexpr std::array<std::string_view, 8> kColumns = {"t", "x", "y", "z", "qw", "qx", "qy", "qz"};

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kBlank = " \t\r\n";
  const size_t first = text.find_first_not_of(kBlank);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlank) - first + 1);
}

std::vector<std::string_view> split(std::string_view line) {
  std::vector<std::string_view> fields;
  for (size_t begin = 0; begin <= line.size();) {
    const size_t end = std::min(line.find(',', begin), line.size());
    fields.push_back(trimmed(line.substr(begin, end - begin)));
    begin = end + 1;
  }
  return fields;
}

std::optional<double> parse_number(std::string_view text) {
  if (text.size() > 1 && text.front() == '+' && text[1] != '-') text.remove_prefix(1);
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

class TrajectoryReader {
 public:
  TrajectoryReader(std::istream& text, const std::string& name) : text_(text), name_(name) {}

  Trajectory read() {
    while (next_line()) {
      if (header_.empty()) {
        read_header();
      } else {
        read_sample();
      }
    }
    if (text_.bad()) throw InputError(fmt::format("{}: reading broke off after line {}.", name_, line_number_));
    if (header_.empty()) fail("the file is empty; its first line must name the columns t,x,y,z,qw,qx,qy,qz.");
    if (samples_.empty()) fail("there is no sample below the header; add a line with at least one pose.");
    return Trajectory(std::move(samples_));
  }

 private:
  bool next_line() {
    while (std::getline(text_, buffer_)) {
      ++line_number_;
      line_ = buffer_;
      constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
      if (line_number_ == 1 && line_.substr(0, 3) == kByteOrderMark) line_.remove_prefix(3);
      line_ = trimmed(line_);
      if (!line_.empty() && line_.front() != '#') return true;
    }
    return false;
  }

  void read_header() {
    for (const std::string_view field : split(line_)) header_.emplace_back(field);
    for (size_t i = 0; i < kColumns.size(); ++i) {
      int found = 0;
      for (size_t column = 0; column < header_.size(); ++column) {
        if (header_[column] != kColumns[i]) continue;
        places_[i] = column;
        ++found;
      }
      if (found == 1) continue;
      fail(fmt::format("the header has {} column '{}'; it must name each of t,x,y,z,qw,qx,qy,qz once.",
                       found == 0 ? "no" : "more than one", kColumns[i]));
    }
  }

  void read_sample() {
    const std::vector<std::string_view> fields = split(line_);
    std::array<double, 8> values{};
    for (size_t i = 0; i < kColumns.size(); ++i) {
      if (places_[i] >= fields.size()) {
        fail_at(i, fmt::format("is missing; the header names {} columns and this line has {}.", header_.size(),
                               fields.size()));
      }
      values[i] = finite_number(i, fields[places_[i]]);
    }
    samples_.push_back({ascending(values[0]), {{values[1], values[2], values[3]}, unit(&values[4])}});
  }

  double finite_number(size_t column, std::string_view field) const {
    const std::optional<double> value = parse_number(field);
    if (!value) fail_at(column, fmt::format("'{}' is not a number; write one such as 0.125.", field));
    if (!std::isfinite(*value)) fail_at(column, fmt::format("'{}' is not finite; remove or repair the sample.", field));
    return *value;
  }

  double ascending(double time) const {
    if (samples_.empty() || time > samples_.back().time) return time;
    fail_at(0, fmt::format("{} s is not later than the {} s before; put the samples in order of time, none twice.",
                           time, samples_.back().time));
  }

  Quaternion unit(const double* wxyz) const {
    const Quaternion q(wxyz[0], wxyz[1], wxyz[2], wxyz[3]);
    const double norm = q.norm();
    if (std::abs(norm - 1.0) <= tolerance::kQuaternionNorm) return q.normalized();
    fail_at(4, fmt::format("the quaternion has norm {:.6g}, not 1; write a unit quaternion, real part in qw.", norm));
  }

  [[noreturn]] void fail(const std::string& what) const {
    throw InputError(line_number_ == 0 ? fmt::format("{}: {}", name_, what)
                                       : fmt::format("{}, line {}: {}", name_, line_number_, what));
  }
  [[noreturn]] void fail_at(size_t column, const std::string& what) const {
    throw InputError(fmt::format("{}, line {}, column {}: {}", name_, line_number_, kColumns[column], what));
  }

  std::istream& text_;
  const std::string& name_;
  std::string buffer_;
  std::string_view line_;
  long line_number_ = 0;
  std::vector<std::string> header_;
  std::array<size_t, 8> places_{};
  std::vector<Trajectory::Sample> samples_;
};

}  // namespace

Trajectory read_trajectory(std::istream& text, const std::string& name) { return TrajectoryReader(text, name).read(); }

Trajectory read_trajectory(const std::filesystem::path& file) {
  std::error_code error;
  if (std::filesystem::is_directory(file, error)) {
    throw InputError(fmt::format("{}: this is a folder, not a trajectory file.", file.string()));
  }
  if (is_recording(file)) {
    std::stringstream rows;
    export_csv(file, rows);
    return read_trajectory(rows, file.string());
  }
  std::ifstream text(file);
  if (!text) {
    const std::error_code reason(errno, std::generic_category());
    throw InputError(fmt::format("{}: the trajectory cannot be read ({}); check the path and its permissions.",
                                 file.string(), reason.message()));
  }
  return read_trajectory(text, file.string());
}

}  // namespace tegotae
