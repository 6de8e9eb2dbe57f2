// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string_view>

namespace tegotae {

/// Where the scene file `name` that comes with tegotae lies: in the folder that the environment variable TEGOTAE_SCENES
/// names; without it, in the share of the prefix that the running program is installed in, else in the source tree that
/// the library was built from, else where the library was to be installed. Throws InputError that says where it looked.
std::filesystem::path find_scene(std::string_view name);

}  // namespace tegotae
