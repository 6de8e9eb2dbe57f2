// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

struct mjModel_;

namespace tegotae {

struct ModelDeleter {
  void operator()(mjModel_* model) const noexcept;
};
using ModelPointer = std::unique_ptr<mjModel_, ModelDeleter>;

/// A compiled scene and what MuJoCo warned of while compiling it.
struct LoadedModel {
  ModelPointer model;
  std::vector<std::string> warnings;
};

/// Compiles the MJCF or URDF scene in `file`. Throws SceneError for a file that is missing, malformed, refused by
/// MuJoCo, holds NaN or has no positive time step. MuJoCo's compiler keeps global data: loads take turns.
LoadedModel load_model(const std::filesystem::path& file);

}  // namespace tegotae
