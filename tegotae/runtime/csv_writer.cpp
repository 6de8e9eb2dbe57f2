// SPDX-License-Identifier: Apache-2.0
#include <tegotae/runtime/csv_writer.hpp>

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <system_error>
#include <utility>

namespace tegotae {
namespace {

// Bytes gathered before they are written: a tenth of a second of a wide table at 1 kHz, and a size that disks like.
constexpr std::size_t kBlockBytes = 64 * 1024;

constexpr mode_t kFileMode = 0666;  // as the user's umask allows

// An error of its own for rows that come after `close`.
constexpr int kClosed = -1;

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

CsvWriter::CsvWriter(std::string path, const CsvHead& head) : path_(std::move(path)), block_(head_text(head)) {
  file_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, kFileMode);
  if (file_ < 0) {
    fail(errno, 0);
  } else {
    flush();
  }
  block_.reserve(2 * kBlockBytes);
}

CsvWriter::~CsvWriter() { close(); }

void CsvWriter::write_row(std::span<const double> values) {
  if (file_ < 0) {
    if (error_number_ == 0) error_number_ = kClosed;
    ++rows_lost_;
    return;
  }
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (i > 0) block_ += ',';
    append_number(block_, values[i]);
  }
  block_ += '\n';
  ++rows_in_block_;
  if (block_.size() >= kBlockBytes) flush();
}

void CsvWriter::flush() {
  std::size_t written = 0;
  while (written < block_.size()) {
    const ssize_t result = ::write(file_, block_.data() + written, block_.size() - written);
    if (result < 0 && errno == EINTR) continue;
    if (result <= 0) {
      fail(result < 0 ? errno : EIO, written);
      return;
    }
    written += static_cast<std::size_t>(result);
  }
  bytes_written_ += written;
  rows_written_ += rows_in_block_;
  rows_in_block_ = 0;
  block_.clear();
}

// Ends the writing after `written` bytes of the block: cuts the file after the last complete row.
void CsvWriter::fail(int error_number, std::size_t written) {
  error_number_ = error_number;
  const std::size_t complete = block_.rfind('\n', written == 0 ? 0 : written - 1) + 1;  // npos + 1 is 0
  const std::size_t kept = written == 0 ? 0 : complete;
  const auto rows_cut =
      static_cast<std::uint64_t>(std::count(block_.begin() + static_cast<std::ptrdiff_t>(kept), block_.end(), '\n'));
  const std::uint64_t rows_lost = std::min(rows_cut, rows_in_block_);  // lines of the head are no rows
  rows_written_ += rows_in_block_ - rows_lost;
  rows_lost_ += rows_lost;
  rows_in_block_ = 0;
  block_.clear();
  if (file_ < 0) return;
  // Where the file is no regular one there is nothing to cut, and nothing that could be done about it.
  [[maybe_unused]] const int cut = ::ftruncate(file_, static_cast<off_t>(bytes_written_ + kept));
  ::close(file_);
  file_ = -1;
}

void CsvWriter::close() {
  if (file_ < 0) return;
  flush();
  if (file_ < 0) return;
  const int result = ::close(file_);
  file_ = -1;
  if (result != 0 && errno != EINTR) error_number_ = errno;
}

std::string CsvWriter::error() const {
  if (ok()) return {};
  const std::string cause =
      error_number_ == kClosed ? "it was closed before" : std::generic_category().message(error_number_);
  return "Cannot write '" + path_ + "': " + cause + "; it holds " + std::to_string(rows_written_) + " complete rows, " +
         std::to_string(rows_lost_) + " are lost. Free space or name a folder that can be written, and run again.";
}

}  // namespace tegotae
