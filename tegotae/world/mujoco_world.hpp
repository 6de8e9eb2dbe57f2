// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/runtime/world.hpp>
#include <tegotae/world/haptic_settings.hpp>
#include <tegotae/world/limits.hpp>
#include <tegotae/world/scene_error.hpp>
#include <tegotae/world/world_diagnostics.hpp>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace tegotae {

struct MujocoWorldOptions {
  /// s. A duration is integrated in the least number of equal substeps that are no longer than this, nor than the
  /// scene's own time step.
  double max_substep = world_limits::kMaxSubstep;
  /// Contacts that MuJoCo may hold at a time. Room for them is made as it is needed; beyond, contacts are dropped and
  /// counted. (MuJoCo 2.2.2; newer ones bound memory instead.)
  int max_contacts = 2048;
};

/// The world on MuJoCo. The tool is a body of the scene that no joint moves, a mocap body or one fixed in the world,
/// with its descendants. MuJoCo neither collides nor integrates it; its pose follows the `ToolState`, so that sensors
/// and pictures of the scene see it. Each body that joints move, and that has contact geometry, is a moving body.
class MujocoWorld final : public World {
 public:
  struct Implementation;
  explicit MujocoWorld(std::unique_ptr<Implementation> implementation);
  ~MujocoWorld() override;

  const SceneGeometry& geometry() const override;
  void read_bodies(std::span<BodyState> states) const override;
  /// Impulses act as constant forces and torques over the whole duration, and not after it. Throws
  /// std::invalid_argument for a duration that is not positive or a wrong number of impulses; an impulse that is not
  /// finite is ignored, and what goes wrong in MuJoCo is dealt with and counted: see `diagnostics`.
  void advance(double duration, const ToolState& tool, std::span<const BodyImpulse> impulses) override;

  /// What the scene says in <custom> of how to render it.
  const std::vector<HapticSettingInScene>& haptic_settings() const noexcept;
  /// m/s^2
  Vector3 gravity() const noexcept;
  /// What was found on loading that the user should know, a sentence each.
  const std::vector<std::string>& warnings() const noexcept;
  const WorldDiagnostics& diagnostics() const noexcept;
  /// Pose of the tool as MuJoCo has it.
  Pose tool_pose() const noexcept;
  /// s, of the simulation, from 0.
  double time() const noexcept;
  /// The longest substep, s.
  double max_substep() const noexcept;
  /// Median wall time of one substep from the present state, s: what the publish period is chosen by.
  double measure_step_time(int substeps = 50) const;

 private:
  std::unique_ptr<Implementation> implementation_;
};

/// Loads a scene (MJCF, or URDF where MuJoCo reads it) with the body `tool` in the hand. Throws SceneError where the
/// scene cannot be used, std::invalid_argument for options that are not positive.
///
/// - Each geom with contact bits, or paired with the tool by `<pair>`, is a piece; the others are only seen. A mesh is
///   its hull, with a warning if it is not convex.
/// - `<exclude>` and `<pair>` between the tool and other bodies hold: where there are any, the contact bits of the
///   shapes are renumbered so that `may_touch` answers for both. The friction of a `<pair>` is that of its geoms.
/// - The tool's mass is the scene's (by its geoms' density, 1000 kg/m^3 unless it says otherwise). MuJoCo 2.2.2 weighs
/// a
///   mesh as its equivalent inertia box; the gyration length of one mesh is exact all the same.
std::unique_ptr<MujocoWorld> load_mujoco_world(const std::filesystem::path& file, const std::string& tool,
                                               const MujocoWorldOptions& options = {});

}  // namespace tegotae
