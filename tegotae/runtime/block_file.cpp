// SPDX-License-Identifier: Apache-2.0
#include <tegotae/runtime/block_file.hpp>

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>
#include <utility>

namespace tegotae {
namespace {

// Bytes gathered before they are written: a tenth of a second of a wide table at 1 kHz, and a size that disks like.
constexpr std::size_t kBlockBytes = 64 * 1024;

constexpr mode_t kFileMode = 0666;  // as the user's umask allows

// An error of its own for units that come after `close`.
constexpr int kClosed = -1;

}  // namespace

BlockFile::BlockFile(std::string path, std::string head) : path_(std::move(path)), block_(std::move(head)) {
  file_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, kFileMode);
  if (file_ < 0) {
    fail(errno, 0);
  } else {
    flush();
  }
  block_.reserve(2 * kBlockBytes);
}

BlockFile::~BlockFile() { close(); }

void BlockFile::append(std::string_view unit) {
  if (file_ < 0) {
    if (error_number_ == 0) error_number_ = kClosed;
    ++lost_;
    return;
  }
  block_ += unit;
  ends_.push_back(block_.size());
  if (block_.size() >= kBlockBytes) flush();
}

void BlockFile::flush() {
  if (file_ < 0) return;
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
  written_ += ends_.size();
  ends_.clear();
  block_.clear();
}

// Ends the writing after `written` bytes of the block: cuts the file after the last complete unit.
void BlockFile::fail(int error_number, std::size_t written) {
  error_number_ = error_number;
  const auto first_cut = std::upper_bound(ends_.begin(), ends_.end(), written);
  const std::size_t kept = first_cut == ends_.begin() ? 0 : *(first_cut - 1);
  written_ += static_cast<std::uint64_t>(first_cut - ends_.begin());
  lost_ += static_cast<std::uint64_t>(ends_.end() - first_cut);
  ends_.clear();
  block_.clear();
  if (file_ < 0) return;
  // Where the file is no regular one there is nothing to cut, and nothing that could be done about it.
  [[maybe_unused]] const int cut = ::ftruncate(file_, static_cast<off_t>(bytes_written_ + kept));
  ::close(file_);
  file_ = -1;
}

void BlockFile::close() {
  if (file_ < 0) return;
  flush();
  if (file_ < 0) return;
  const int result = ::close(file_);
  file_ = -1;
  if (result != 0 && errno != EINTR) error_number_ = errno;
}

std::string BlockFile::cause() const {
  if (ok()) return {};
  return error_number_ == kClosed ? "it was closed before" : std::generic_category().message(error_number_);
}

}  // namespace tegotae
