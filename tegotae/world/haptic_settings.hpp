// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

struct mjModel_;

namespace tegotae {

/// Haptic settings that a scene may hold, as `<custom><numeric name="tegotae_stiffness" data="9000"/></custom>`. A
/// command line that names one wins over the scene; what neither names has its own default.
struct HapticSettingsInScene {
  std::optional<double> stiffness;      ///< tegotae_stiffness, N/m, positive
  std::optional<double> damping;        ///< tegotae_damping, N s/m, not negative
  std::optional<double> metric_length;  ///< tegotae_metric_length, m, not negative; 0: the tool's gyration length
  std::optional<double> margin;         ///< tegotae_margin, m, positive
  std::optional<double> physics_rate;   ///< tegotae_physics_rate, Hz, positive
  std::optional<double> haptic_rate;    ///< tegotae_haptic_rate, Hz, positive
};

/// Reads the settings of a compiled scene. Throws SceneError for a `tegotae_` numeric that is unknown (listing those
/// that are known), is not one number, or is out of range. `file` is for the message.
HapticSettingsInScene read_haptic_settings(const mjModel_& model, const std::string& file);

}  // namespace tegotae
