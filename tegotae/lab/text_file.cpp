// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/text_file.hpp>

#include <tegotae/lab/input_error.hpp>

#include <fmt/format.h>

#include <cerrno>
#include <fstream>
#include <string>
#include <system_error>

namespace tegotae {
namespace {

std::string mend_for(const std::error_code& reason) {
  if (reason == std::errc::no_space_on_device) return "free some space";
  if (reason == std::errc::permission_denied) return "allow writing there, or choose another folder";
  return "choose another folder";
}

}  // namespace

void check_writable_place(const std::filesystem::path& file) {
  std::error_code error;
  if (std::filesystem::is_directory(file, error)) {
    throw InputError(fmt::format("{}: this is a folder; name a file in it.", file.string()));
  }
  const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
  if (std::filesystem::is_directory(folder, error)) return;
  const bool is_there = std::filesystem::exists(folder, error);
  throw InputError(
      fmt::format("{}: {} {}.", file.string(), folder.string(),
                  is_there ? "is not a folder; choose another place" : "is no folder that is there; make it first"));
}

void write_text(const std::filesystem::path& file, std::string_view text) {
  check_writable_place(file);
  errno = 0;
  std::ofstream stream(file, std::ios::binary);
  stream.write(text.data(), static_cast<std::streamsize>(text.size()));
  stream.close();
  if (stream) return;
  const std::error_code reason(errno, std::generic_category());
  throw InputError(
      fmt::format("{}: the file cannot be written ({}); {}.", file.string(), reason.message(), mend_for(reason)));
}

void make_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (!error && std::filesystem::is_directory(folder, error)) return;
  if (!error) error = std::make_error_code(std::errc::not_a_directory);
  throw InputError(
      fmt::format("{}: the folder cannot be made ({}); choose another with --out.", folder.string(), error.message()));
}

}  // namespace tegotae
