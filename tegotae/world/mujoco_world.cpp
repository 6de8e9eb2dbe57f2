// SPDX-License-Identifier: Apache-2.0
#include <tegotae/world/mujoco_world.hpp>

#include <tegotae/world/contact_rules.hpp>
#include <tegotae/world/model_poses.hpp>
#include <tegotae/world/scene_builder.hpp>
#include <tegotae/world/simulation.hpp>

#include <fmt/format.h>
#include <mujoco/mujoco.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace tegotae {

struct MujocoWorld::Implementation {
  Simulation simulation;
  SceneGeometry geometry;
  std::vector<int> moving_bodies;
  std::vector<std::string> warnings;
  std::vector<HapticSettingInScene> settings;
  int tool_body = 0;
  double max_substep = 0.0;

  void place_tool(const Pose& X_WT);
  void apply(double duration, std::span<const BodyImpulse> impulses);
  void clear_applied();
};

namespace {

int substeps_in(double duration, double max_substep) {
  return std::max(1, static_cast<int>(std::ceil(duration / max_substep - world_limits::kSubstepRounding)));
}

void require(const MujocoWorldOptions& options) {
  if (!(options.max_substep > 0.0) || options.max_contacts <= 0) {
    throw std::invalid_argument("the longest substep and the number of contacts of a world must be positive");
  }
}

}  // namespace

// A body fixed in the world is moved by the pose that it has on its parent, which the scene holds still.
void MujocoWorld::Implementation::place_tool(const Pose& X_WT) {
  mjModel& m = simulation.model();
  mjData& d = simulation.data();
  if (m.body_mocapid[tool_body] >= 0) {
    write_pose(X_WT, d.mocap_pos, d.mocap_quat, m.body_mocapid[tool_body]);
  } else {
    const Pose X_WP = pose_from(d.xpos, d.xquat, m.body_parentid[tool_body]);
    write_pose(X_WP.inverse() * X_WT, m.body_pos, m.body_quat, tool_body);
  }
}

// MuJoCo applies these at the body's centre of mass, in world axes.
void MujocoWorld::Implementation::apply(double duration, std::span<const BodyImpulse> impulses) {
  for (size_t i = 0; i < moving_bodies.size(); ++i) {
    if (!impulses[i].linear.allFinite() || !impulses[i].angular.allFinite()) {
      simulation.count_ignored_impulse();
      continue;
    }
    double* applied = simulation.data().xfrc_applied + 6 * static_cast<std::ptrdiff_t>(moving_bodies[i]);
    for (int k = 0; k < 3; ++k) {
      applied[k] = impulses[i].linear[k] / duration;
      applied[3 + k] = impulses[i].angular[k] / duration;
    }
  }
}

void MujocoWorld::Implementation::clear_applied() {
  for (const int body : moving_bodies) {
    std::fill_n(simulation.data().xfrc_applied + 6 * static_cast<std::ptrdiff_t>(body), 6, 0.0);
  }
}

MujocoWorld::MujocoWorld(std::unique_ptr<Implementation> implementation) : implementation_(std::move(implementation)) {}

MujocoWorld::~MujocoWorld() = default;

const SceneGeometry& MujocoWorld::geometry() const { return implementation_->geometry; }

void MujocoWorld::read_bodies(std::span<BodyState> states) const {
  const Simulation& simulation = implementation_->simulation;
  const mjData& d = simulation.data();
  const auto& bodies = implementation_->moving_bodies;
  if (states.size() != bodies.size()) throw std::invalid_argument("states must be as many as the moving bodies");
  for (size_t i = 0; i < bodies.size(); ++i) {
    std::array<double, 6> velocity{};  // angular, then linear of the centre of mass, world axes
    mj_objectVelocity(&simulation.model(), &d, mjOBJ_BODY, bodies[i], velocity.data(), 0);
    states[i].X_WB = pose_from(d.xpos, d.xquat, bodies[i]);
    states[i].V_WB.angular = {velocity[0], velocity[1], velocity[2]};
    states[i].V_WB.linear = {velocity[3], velocity[4], velocity[5]};
  }
}

void MujocoWorld::advance(double duration, const ToolState& tool, std::span<const BodyImpulse> impulses) {
  if (!(duration > 0.0) || !std::isfinite(duration)) {
    throw std::invalid_argument(fmt::format("a world advances by a positive number of seconds, not {}", duration));
  }
  if (impulses.size() != implementation_->moving_bodies.size()) {
    throw std::invalid_argument("impulses must be as many as the moving bodies");
  }
  Simulation& simulation = implementation_->simulation;
  if (tool.X_WT.is_finite()) implementation_->place_tool(tool.X_WT);
  implementation_->apply(duration, impulses);
  const int count = substeps_in(duration, implementation_->max_substep);
  simulation.model().opt.timestep = duration / count;
  for (int i = 0; i < count; ++i) simulation.step();
  implementation_->clear_applied();
  simulation.update_poses();
}

const std::vector<HapticSettingInScene>& MujocoWorld::haptic_settings() const noexcept {
  return implementation_->settings;
}
Vector3 MujocoWorld::gravity() const noexcept {
  return Eigen::Map<const Vector3>(implementation_->simulation.model().opt.gravity);
}
const std::vector<std::string>& MujocoWorld::warnings() const noexcept { return implementation_->warnings; }
const WorldDiagnostics& MujocoWorld::diagnostics() const noexcept { return implementation_->simulation.diagnostics(); }
Pose MujocoWorld::tool_pose() const noexcept {
  const mjData& d = implementation_->simulation.data();
  return pose_from(d.xpos, d.xquat, implementation_->tool_body);
}
double MujocoWorld::time() const noexcept { return implementation_->simulation.data().time; }
double MujocoWorld::max_substep() const noexcept { return implementation_->max_substep; }
double MujocoWorld::measure_step_time(int substeps) const {
  return implementation_->simulation.measure_step_time(implementation_->max_substep, substeps);
}

std::unique_ptr<MujocoWorld> load_mujoco_world(const std::filesystem::path& file, const std::string& tool,
                                               const MujocoWorldOptions& options) {
  require(options);
  const std::string name = file.string();
  LoadedModel loaded = load_model(file);
  std::vector<HapticSettingInScene> settings = read_haptic_settings(*loaded.model, name);
  const ToolBody tool_body = find_tool_body(*loaded.model, tool, name);
  const double max_substep = std::min(options.max_substep, loaded.model->opt.timestep);
  Simulation simulation(std::move(loaded.model), options.max_contacts);
  BuiltScene built = build_scene(simulation.model(), simulation.data(), tool_body, name);
  const int pairs = detach_from_collisions(simulation.model(), tool_body);
  std::vector<std::string> warnings = std::move(loaded.warnings);
  warnings.insert(warnings.end(), built.warnings.begin(), built.warnings.end());
  if (pairs > 0) {
    warnings.push_back(
        fmt::format("{}: {} <pair> of the tool say who may touch; their own friction, margin and "
                    "solver settings do not hold",
                    name, pairs));
  }
  return std::make_unique<MujocoWorld>(std::make_unique<MujocoWorld::Implementation>(
      MujocoWorld::Implementation{std::move(simulation), std::move(built.geometry), std::move(built.moving_bodies),
                                  std::move(warnings), std::move(settings), tool_body.id, max_substep}));
}

}  // namespace tegotae
