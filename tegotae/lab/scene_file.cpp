// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/input_error.hpp>
#include <tegotae/lab/scene_file.hpp>

#include <fmt/format.h>

#include <cstdlib>
#include <string>
#include <system_error>
#include <vector>

namespace tegotae {
namespace {

// The source tree comes first: a library that is being worked on must not read the scenes of an older installed one.
std::vector<std::filesystem::path> scene_folders() {
  const char* const chosen = std::getenv("TEGOTAE_SCENES");  // NOLINT(concurrency-mt-unsafe)
  if (chosen != nullptr && *chosen != '\0') return {chosen};
  return {TEGOTAE_SOURCE_SCENES, TEGOTAE_INSTALLED_SCENES};
}

}  // namespace

std::filesystem::path find_scene(std::string_view name) {
  std::string searched;
  for (const std::filesystem::path& folder : scene_folders()) {
    std::error_code error;
    const std::filesystem::path file = folder / name;
    if (std::filesystem::is_regular_file(file, error)) return file;
    searched.append(searched.empty() ? "" : " nor in ").append(folder.string());
  }
  throw InputError(
      fmt::format("there is no scene file {} in {}; set the environment variable TEGOTAE_SCENES to the "
                  "folder that holds it.",
                  name, searched));
}

}  // namespace tegotae
