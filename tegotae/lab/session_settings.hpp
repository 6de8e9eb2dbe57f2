// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/model/scene_geometry.hpp>
#include <tegotae/render/rendering_method.hpp>
#include <tegotae/runtime/workspace_mapping.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tegotae {

/// Settings of a session as somebody asks for them: a command line, an experiment, a scene. What is not set is left to
/// whoever comes next.
struct SettingsRequest {
  std::optional<std::string> method;
  std::optional<double> stiffness;      ///< N/m
  std::optional<double> damping;        ///< N s/m
  std::optional<double> metric_length;  ///< m; 0: the tool's gyration length
  std::optional<ConstraintSet> constraint_set;
  std::optional<double> physics_rate;  ///< Hz
  std::optional<double> haptic_rate;   ///< Hz
  std::optional<double> margin;        ///< m

  std::optional<double> rotational_stiffness;  ///< N m/rad: another way to give the metric length
  std::optional<double> rotational_damping;    ///< N m s/rad

  // Of `proxy`; other methods know no friction and no tool that weighs.
  std::optional<double> friction;          ///< Coulomb coefficient of all pairs in place of the scene's
  std::optional<double> kinetic_friction;  ///< while slipping, as a part of the coefficient
  std::optional<double> viscous_friction;  ///< N s/m
  std::optional<double> contact_margin;    ///< m that one linearisation may move the tool
  std::optional<double> tool_weight;       ///< 1: the tool's own weight is felt; 0: not
  std::optional<double> tool_inertia;      ///< 1: the tool's own inertia is felt; 0: not
  std::optional<double> transient;         ///< N s/m, amplitude of the contact transient; 0: none

  // Of the interface and of who holds it: no scene sets them.
  std::optional<double> translation_scale, rotation_scale, force_scale;  ///< see WorkspaceSettings
  std::optional<double> clutch_button, dead_man_button;                  ///< from 0
  std::optional<double> energy_bound;                                    ///< 1: on; 0: off
  std::optional<double> beyond_rating;  ///< 1: the interface's ratings of stiffness and damping are not applied

  /// This request, with what it leaves open taken from `other`.
  SettingsRequest or_else(const SettingsRequest& other) const;
};

/// Settings of a session, all decided.
struct SessionSettings {
  std::string method = "proxy";
  double stiffness = 1000.0;   ///< N/m
  double damping = 0.0;        ///< N s/m
  double metric_length = 1.0;  ///< m; decided by the method where nobody sets it
  ConstraintSet constraint_set = ConstraintSet::kPenetratingPoints;
  double physics_rate = 500.0;  ///< Hz. Fixed, not measured: results repeat on any machine
  double haptic_rate = 1000.0;  ///< Hz
  double margin = 0.002;        ///< m, of the search for near objects, beyond what the speeds ask for

  std::optional<double> rotational_damping;  ///< N m s/rad; not set: damping times metric length squared
  std::optional<double> friction;            ///< of all pairs; not set: the scene's
  double kinetic_friction = 1.0;             ///< while slipping, as a part of the coefficient
  double viscous_friction = 0.0;             ///< N s/m
  double contact_margin = 1e-3;              ///< m that one linearisation may move the tool
  bool tool_weight = false;
  bool tool_inertia = false;
  double transient = 0.0;            ///< N s/m
  WorkspaceSettings workspace;       ///< how the interface's workspace lies in the world
  int dead_man_button = -1;          ///< that must be held down; negative: none
  bool energy_bound = true;          ///< where a hand holds the interface
  bool beyond_rating = false;        ///< what the interface is rated for does not bound stiffness and damping
  Vector3 gravity{0.0, 0.0, -9.81};  ///< m/s^2, of the scene: the tool's weight

  RenderingMethod make_method(const SceneGeometry& geometry) const;

  /// One "name: value unit" a setting, for people and for comments in files.
  std::vector<std::string> lines() const;
};

/// The settings that `request` asks for, the defaults above (and the method's own metric length) where it leaves them
/// open. Throws InputError, with the names or the range permitted, for a method that is not there, a value out of
/// range or a setting that the method does not have.
SessionSettings decide_settings(const SettingsRequest& request, const Tool& tool);

/// Whether the method called `name` lets one choose its set of constraints: `paper` alone does.
bool has_constraint_set(std::string_view name) noexcept;

/// Throws InputError, as `decide_settings` does, for a value out of range, before any scene is loaded.
void check_ranges(const SettingsRequest& request);

/// Throws InputError where `request` sets something that the method that it names (or the default) does not have.
void check_fits_method(const SettingsRequest& request);

/// "penetrating", "near".
std::string_view name_of(ConstraintSet set) noexcept;

}  // namespace tegotae
