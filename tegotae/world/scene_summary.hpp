// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/model/scene_geometry.hpp>

#include <string>

namespace tegotae {

/// Two lines for a person: what the tool is made of (kinds, vertices, mass, gyration length) and what it may meet.
std::string scene_summary(const SceneGeometry& scene);

}  // namespace tegotae
