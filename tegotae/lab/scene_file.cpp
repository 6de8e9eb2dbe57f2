// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/scene_file.hpp>

#include <tegotae/lab/input_error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <string>
#include <system_error>
#include <vector>

namespace tegotae {
namespace {

// Of the prefix that the running program lies in, wherever that was moved to; empty: not known.
std::filesystem::path scenes_beside_program() {
  std::error_code error;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error);
  if (error) return {};
  return program.parent_path().parent_path() / "share" / "tegotae" / "scenes";
}

// An installed program reads the scenes installed with it. Otherwise the source tree comes before the place of
// installation: a library that is being worked on must not read the scenes of an older one.
std::vector<std::filesystem::path> scene_folders() {
  const char* const chosen = std::getenv("TEGOTAE_SCENES");  // NOLINT(concurrency-mt-unsafe)
  if (chosen != nullptr && *chosen != '\0') return {chosen};
  std::vector<std::filesystem::path> folders = {scenes_beside_program(), TEGOTAE_SOURCE_SCENES,
                                                TEGOTAE_INSTALLED_SCENES};
  folders.erase(std::remove(folders.begin(), folders.end(), std::filesystem::path()), folders.end());
  return folders;
}

}  // namespace

std::filesystem::path find_scene(std::string_view name) {
  std::string searched;
  for (const std::filesystem::path& folder : scene_folders()) {
    std::error_code error;
    std::filesystem::path file = folder / name;
    if (std::filesystem::is_regular_file(file, error)) return file;
    searched.append(searched.empty() ? "" : " nor in ").append(folder.string());
  }
  throw InputError(
      fmt::format("there is no scene file {} in {}; set the environment variable TEGOTAE_SCENES to the "
                  "folder that holds it.",
                  name, searched));
}

}  // namespace tegotae
