// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/lab/live_run.hpp>

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tegotae {

/// The `scene` message for a run, with all that a page may choose.
std::string live_scene_message(const LiveRun& run, std::span<const LiveScene> scenes);

/// The `settings` message: the values that hold, with the bounds of each.
std::string live_settings_message(const LiveRun& run);

/// The scenes that come with tegotae, by name; none where they are not found.
std::vector<LiveScene> shipped_scenes();

/// Throws InputError, with the names, where there is none called `name`.
const LiveScene& find_live_scene(std::span<const LiveScene> scenes, std::string_view name);

/// The scene of an experiment. Throws InputError where its file is not found.
LiveScene live_scene_of(const Experiment& experiment);

}  // namespace tegotae
