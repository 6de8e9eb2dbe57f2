// SPDX-License-Identifier: Apache-2.0
#include <tegotae/world/loaded_model.hpp>

#include <tegotae/world/engine_guard.hpp>
#include <tegotae/world/load_failure.hpp>
#include <tegotae/world/scene_error.hpp>

#include <fmt/format.h>
#include <mujoco/mujoco.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <mutex>
#include <system_error>

namespace tegotae {
namespace {

void require_readable(const std::filesystem::path& file) {
  std::error_code ignored;
  if (std::filesystem::is_directory(file, ignored)) {
    throw SceneError(fmt::format("{}: is a folder; name the scene file in it", file.string()));
  }
  if (!std::filesystem::is_regular_file(file) || !std::ifstream(file)) {
    throw SceneError(fmt::format("{}: no such scene file, or it may not be read; check the path", file.string()));
  }
}

void refuse_nan(const std::string& file, const std::vector<std::string>& warnings) {
  for (const std::string& warning : warnings) {
    if (warning.find("NaN") != std::string::npos) {
      throw SceneError(fmt::format("{}: the scene holds a number that is NaN; replace it", file));
    }
  }
}

}  // namespace

void ModelDeleter::operator()(mjModel_* model) const noexcept { mj_deleteModel(model); }

LoadedModel load_model(const std::filesystem::path& file) {
  require_readable(file);
  static std::mutex turn;
  const std::lock_guard<std::mutex> lock(turn);
  const std::string name = file.string();
  std::array<char, 2048> text{};
  EngineMessages messages;
  mjModel* compiled = nullptr;
  const bool finished = run_guarded(
      messages, [&] { compiled = mj_loadXML(name.c_str(), nullptr, text.data(), static_cast<int>(text.size())); });
  if (!finished) throw SceneError(describe_load_failure(name, messages.error));
  LoadedModel loaded{ModelPointer(compiled), std::move(messages.warnings)};
  if (loaded.model == nullptr) throw SceneError(describe_load_failure(name, text.data()));
  refuse_nan(name, loaded.warnings);
  if (text.front() != '\0') loaded.warnings.emplace_back(text.data());
  if (!(compiled->opt.timestep > 0.0)) {
    throw SceneError(
        fmt::format("{}: the time step of the scene must be positive; correct timestep in <option>", name));
  }
  return loaded;
}

}  // namespace tegotae
