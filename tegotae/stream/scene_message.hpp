// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/model/scene_geometry.hpp>

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tegotae {

/// A name that a page may send, and a sentence on it.
struct NamedChoice {
  std::string name, summary;
};

/// What a `scene` message says beside the shapes.
struct SceneNames {
  std::string mode = "live";      ///< or "replay"
  std::string name;               ///< of the scene
  std::string program;            ///< with its version
  Vector3 up = Vector3::UnitZ();  ///< unit, see `up_axis`
  std::vector<std::string> scenes;
  std::vector<NamedChoice> experiments, motions, methods;
  std::string interface = "page";
  std::optional<double> duration;  ///< s, of a recording
};

/// The axis that points up where gravity (m/s^2) pulls so: y where it is mostly along -y, else z.
Vector3 up_axis(const Vector3& gravity) noexcept;

/// The `scene` message of the live view (docs/live-view.md): shapes with colours, hulls with vertices and triangles.
std::string encode_scene(const SceneGeometry& geometry, const SceneNames& names);

/// One setting, for a page to show and to change.
struct ShownSetting {
  std::string name, label, unit;
  std::optional<double> value;  ///< not set: the scene's own
  double least = 0.0, most = 0.0;
  bool zero_too = false;   ///< 0 is permitted, though below `least`
  bool is_switch = false;  ///< 0 or 1, nothing between
  bool available = true;   ///< the present method has it
};

/// The `settings` message.
std::string encode_settings(std::string_view method, std::span<const ShownSetting> settings);

}  // namespace tegotae
