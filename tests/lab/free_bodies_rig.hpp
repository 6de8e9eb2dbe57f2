// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/contact/penetration.hpp>
#include <tegotae/device/live_hand.hpp>
#include <tegotae/device/simulated_presets.hpp>
#include <tegotae/lab/free_body_stiffness.hpp>
#include <tegotae/lab/session.hpp>
#include <tegotae/runtime/simulated_session.hpp>
#include <tegotae/world/mujoco_world.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace tegotae::test {

/// A world whose work on the bodies is watched: passes everything on.
class WatchedWorld final : public World {
 public:
  explicit WatchedWorld(MujocoWorld& world) : world_(world) {
    const SceneGeometry& geometry = world.geometry();
    states_.resize(static_cast<size_t>(geometry.moving_count));
    bodies_.resize(states_.size());
    for (const Body& body : geometry.bodies) {
      if (body.moving_index < 0) continue;
      const double volume = mass_properties(body.pieces.front(), 1.0).mass;
      const MassProperties mass = mass_properties(body.pieces.front(), body.mass / volume);
      bodies_[static_cast<size_t>(body.moving_index)] = {&body, mass, body.X_WB.p.z()};
    }
    world_.read_bodies(states_);
  }

  const SceneGeometry& geometry() const override { return world_.geometry(); }
  void read_bodies(std::span<BodyState> states) const override { world_.read_bodies(states); }

  void advance(double duration, const ToolState& tool, std::span<const BodyImpulse> impulses) override {
    world_.read_bodies(states_);
    work_ += work_of(impulses);
    world_.advance(duration, tool, impulses);
    world_.read_bodies(states_);
    work_ += work_of(impulses);
  }

  /// J, that the displayed pushes have done on the bodies.
  double work() const { return work_; }

  struct BodyOfWorld {
    const Body* body = nullptr;
    MassProperties mass;
    double first_height = 0.0;  ///< m
  };
  const std::vector<BodyOfWorld>& bodies() const { return bodies_; }
  const std::vector<BodyState>& states() const { return states_; }

 private:
  // Half of it: of the velocity at one end.
  double work_of(std::span<const BodyImpulse> impulses) const {
    double work = 0.0;
    for (size_t i = 0; i < impulses.size(); ++i) {
      work += 0.5 * (impulses[i].linear.dot(states_[i].V_WB.linear) + impulses[i].angular.dot(states_[i].V_WB.angular));
    }
    return work;
  }

  MujocoWorld& world_;
  std::vector<BodyOfWorld> bodies_;
  std::vector<BodyState> states_;
  double work_ = 0.0;
};

/// What a run with the free bodies showed.
struct FreeBodiesOutcome {
  double tool_speed = 0.0;    ///< m/s, greatest of the hand's tool
  double body_speed = 0.0;    ///< m/s, greatest of a centre of mass, what falling alone gives taken off
  double excess_speed = 0.0;  ///< m/s, greatest of that beyond 1.5 times the tool's speed until then
  double injected = 0.0;      ///< J, greatest that bodies received beyond what the hand gave
  double given = 0.0;         ///< J, that bodies received in all
  double highest = 0.0;       ///< m, that a body rose above its first place
  double lowest_gap = 1e9;    ///< m, of a body's lowest point over the ground
  double deepest = 0.0;       ///< m, of the proxy in a moving body
  double force = 0.0;         ///< N, greatest displayed
  double chatter = 0.0;       ///< N a tick, mean size of the change of the displayed force over the last half second
  double last_force = 0.0;    ///< N, mean over the last half second
  int infinite = 0;           ///< records or states that are not finite
  bool healthy = true;
  std::string trouble;
};

/// One scripted contact of a guided hand with the free bodies of table.xml in simulated time, as a page sees it.
class FreeBodiesRig {
 public:
  explicit FreeBodiesRig(SessionSettings wanted)
      : settings(std::move(wanted)),
        world(load_mujoco_world(TEGOTAE_SCENES "/table.xml", "tool")),
        watched(*world),
        device(simulated_device("page")) {}

  /// The hand means to be at `target(t)` (m, rad); `each_tick` is called after every tick.
  FreeBodiesOutcome run(double duration, const std::function<Pose(double)>& target,
                        const std::function<void(double, HapticTick&, PhysicsLoop&)>& each_tick = {}) {
    const Tool& tool = watched.geometry().tool;
    LiveHand hand(target(0.0), device, simulated_hand("moderate"));
    PhysicsLoop physics(watched, {1.0 / settings.physics_rate, settings.margin},
                        needs_of(settings.make_method(watched.geometry())));
    HapticTick haptics(settings.make_method(watched.geometry()), tool,
                       with_short_ramp(safety_limits_of(settings, device.capability, tool)),
                       1.0 / settings.haptic_rate);
    constexpr double kToolRadius = 0.065;  // m
    FreeBodiesOutcome out;
    double given = 0.0;
    Wrench before;
    Pose X_WT_before = target(0.0);
    std::vector<double> changes, forces;
    long tick = 0;
    run_simulated(physics, haptics, hand, 1.0 / settings.haptic_rate, duration, [&](const TickRecord& record) {
      const Pose X_WT = record.X_WT;
      const Wrench displayed{record.displayed.force, record.displayed.torque};
      if (!X_WT.is_finite() || !displayed.is_finite()) {
        ++out.infinite;
        return false;
      }
      const Vector6 way = displacement(X_WT_before, X_WT, tool.mass.centre_of_mass);
      given -= before.force.dot(way.head<3>()) + before.torque.dot(way.tail<3>());
      out.tool_speed =
          std::max(out.tool_speed, (way.head<3>().norm() + way.tail<3>().norm() * kToolRadius) * settings.haptic_rate);
      out.injected = std::max(out.injected, watched.work() - given);
      out.given = watched.work();
      out.force = std::max(out.force, displayed.force.norm());
      if (record.time > duration - 0.5) {
        changes.push_back((displayed.force - before.force).norm());
        forces.push_back(displayed.force.norm());
      }
      before = displayed;
      X_WT_before = X_WT;
      if (++tick % 4 == 0) look(record.X_WP, out);
      hand.guide().guide(target(record.time));
      if (each_tick) each_tick(record.time, haptics, physics);
      return out.infinite == 0;
    });
    for (const double change : changes) out.chatter += change / static_cast<double>(changes.size());
    for (const double force : forces) out.last_force += force / static_cast<double>(forces.size());
    out.healthy = world->diagnostics().is_healthy();
    out.trouble = trouble_of(world->diagnostics());
    return out;
  }

  Vector3 place_of(int body) const { return watched.states()[static_cast<size_t>(body)].X_WB.p; }

  SessionSettings settings;
  std::unique_ptr<MujocoWorld> world;
  WatchedWorld watched;
  SimulatedDevice device;

 private:
  void look(const Pose& X_WP, FreeBodiesOutcome& out) {
    constexpr double kGravity = 9.81;
    for (size_t i = 0; i < watched.states().size(); ++i) {
      const BodyState& state = watched.states()[i];
      const auto& [body, mass, first_height] = watched.bodies()[i];
      if (!state.X_WB.is_finite() || !state.V_WB.is_finite()) {
        ++out.infinite;
        return;
      }
      const double fallen = std::max(0.0, first_height - state.X_WB.p.z());
      const double speed = std::sqrt(std::max(0.0, state.V_WB.linear.squaredNorm() - 2.0 * kGravity * fallen));
      out.body_speed = std::max(out.body_speed, speed);
      out.excess_speed = std::max(out.excess_speed, speed - 1.5 * out.tool_speed);
      out.highest = std::max(out.highest, state.X_WB.p.z() - first_height);
      const BoundingBox box = bounding_box(body->pieces.front(), state.X_WB);
      out.lowest_gap = std::min(out.lowest_gap, box.lower.z());
      out.deepest = std::max(out.deepest, depth(X_WP, *body, state.X_WB));
    }
  }

  double depth(const Pose& X_WP, const Body& body, const Pose& X_WB) const {
    const Shape& shape = watched.geometry().tool.pieces.front();
    if (!bounding_box(shape, X_WP).overlaps(bounding_box(body.pieces.front(), X_WB))) return 0.0;
    const PlacedShape tool(shape, X_WP), object(body.pieces.front(), X_WB);
    ClosestPointsCache cache;
    if (closest_points(tool, object, cache).separation == Separation::kSeparated) return 0.0;
    const Penetration found = penetration(tool, object, cache);
    return found.valid ? found.depth : 0.0;
  }
};

/// As a live run would have them.
inline SessionSettings as_live(const SessionSettings& settings, const SceneGeometry& geometry) {
  return held_to_bodies(held_to_rating(settings, simulated_device("page").capability), geometry);
}

/// Those of table.xml.
inline SessionSettings table_settings() {
  const auto world = load_mujoco_world(TEGOTAE_SCENES "/table.xml", "tool");
  SessionSettings settings =
      decide_settings(settings_of(world->haptic_settings(), "table.xml"), world->geometry().tool);
  settings.gravity = world->gravity();
  return as_live(settings, world->geometry());
}

}  // namespace tegotae::test
