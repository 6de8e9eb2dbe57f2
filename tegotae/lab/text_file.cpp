// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/input_error.hpp>
#include <tegotae/lab/text_file.hpp>

#include <fmt/format.h>

#include <cerrno>
#include <fstream>
#include <string>
#include <system_error>

namespace tegotae {

void write_text(const std::filesystem::path& file, std::string_view text) {
  errno = 0;
  std::ofstream stream(file, std::ios::binary);
  stream.write(text.data(), static_cast<std::streamsize>(text.size()));
  stream.close();
  if (stream) return;
  const std::error_code reason(errno, std::generic_category());
  throw InputError(
      fmt::format("{}: the file cannot be written ({}); check that the folder may be written to and has "
                  "room.",
                  file.string(), reason.message()));
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
