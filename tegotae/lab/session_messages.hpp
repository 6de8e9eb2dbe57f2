// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/lab/session_settings.hpp>
#include <tegotae/stream/scene_message.hpp>

#include <string>
#include <vector>

namespace tegotae {

/// Every numeric setting with its present value, in the order of `numeric_settings`; one that the method does not have
/// is not available.
std::vector<ShownSetting> shown_settings(const SessionSettings& settings);

/// The names that every scene message says: program, experiments, methods, and the axis against gravity. `scene`: name
/// of the scene.
SceneNames session_names(std::string scene, const SessionSettings& settings);

}  // namespace tegotae
