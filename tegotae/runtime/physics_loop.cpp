// SPDX-License-Identifier: Apache-2.0
#include <tegotae/runtime/physics_loop.hpp>

#include <tegotae/model/near_pieces.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace tegotae {
namespace {

double radius_of(const Tool& tool) {
  double radius = 0.0;
  for (const Shape& piece : tool.pieces) {
    const double own = piece.polytope ? piece.polytope->radius + piece.polytope_error : 0.0;
    radius = std::max(radius, piece.X_BS.p.norm() + own);
  }
  return radius;
}

void require_positive_setting(const char* what, double value) {
  if (std::isfinite(value) && value > 0.0) return;
  throw std::invalid_argument("the " + std::string(what) + " must be positive, not " + std::to_string(value));
}

// Indices 0 to moving_count - 1, each once: else a body would be read or pushed as another, or beyond the arrays.
const SceneGeometry& checked(const SceneGeometry& geometry) {
  const auto refuse = [](const std::string& what) {
    throw std::invalid_argument("the world's geometry is not consistent: " + what +
                                "; give the moving bodies the indices 0 to moving_count - 1, each once");
  };
  const int count = geometry.moving_count;
  if (count < 0) refuse("moving_count is " + std::to_string(count));
  std::vector<bool> taken(static_cast<size_t>(count));
  for (const Body& body : geometry.bodies) {
    const int index = body.moving_index;
    if (index < 0) continue;
    const std::string who = "body '" + body.name + "' has the moving_index " + std::to_string(index);
    if (index >= count) refuse(who + ", but moving_count is " + std::to_string(count));
    if (taken[static_cast<size_t>(index)]) refuse(who + ", which another body has too");
    taken[static_cast<size_t>(index)] = true;
  }
  const auto missing = std::find(taken.begin(), taken.end(), false);
  if (missing != taken.end()) {
    refuse("no body has the moving_index " + std::to_string(missing - taken.begin()) + ", but moving_count is " +
           std::to_string(count));
  }
  return geometry;
}

}  // namespace

PhysicsLoop::PhysicsLoop(World& world, const Settings& settings, const ModelNeeds& needs)
    : world_(world),
      settings_(settings),
      needs_(needs),
      tool_radius_(radius_of(world.geometry().tool)),
      search_(checked(world.geometry())),
      builder_(world.geometry()),
      bodies_(static_cast<size_t>(world.geometry().moving_count)),
      impulses_(bodies_.size()) {
  change(settings, needs);
  if (world.geometry().moving_count > kMaxMovingBodies) {
    throw std::invalid_argument("the world moves " + std::to_string(world.geometry().moving_count) +
                                " bodies; at most " + std::to_string(kMaxMovingBodies) + " can be pushed");
  }
}

void PhysicsLoop::change(const Settings& settings, const ModelNeeds& needs) {
  require_positive_setting("physics period (s)", settings.period);
  require_positive_setting("margin (m)", settings.margin);
  settings_ = settings;
  needs_ = needs;
}

// A model appears one period after the state that it was made from and is interpolated towards for another, and then
// serves until the next: two periods of motion. A method that follows pairs itself is told of those, too, that a hand
// may come to by speeding up meanwhile; to the others more reach means more points, which bend what they render.
Reach PhysicsLoop::reach(const ToolState& tool) const {
  constexpr double kHandAcceleration = 10.0;  // m/s^2, of a brisk hand
  const double speed = tool.V_WT.linear.norm() + tool.V_WT.angular.norm() * tool_radius_;
  const double horizon = 2.0 * settings_.period;
  const double speeding_up = needs_.about_proxy ? 0.5 * kHandAcceleration * horizon * horizon : 0.0;
  return {settings_.margin + stretch(tool) + speeding_up, horizon, std::isfinite(speed) ? speed : 0.0};
}

// A proxy may come to the interface's pose at once, where what holds it ends.
double PhysicsLoop::stretch(const ToolState& tool) const {
  if (!needs_.about_proxy) return 0.0;
  const Vector6 way = displacement(tool.X_WP, tool.X_WT, Vector3::Zero());
  const double stretch = way.head<3>().norm() + way.tail<3>().norm() * tool_radius_;
  return std::isfinite(stretch) ? stretch : 0.0;
}

void PhysicsLoop::build(double time, const ToolState& tool, IntermediateRepresentation& model) {
  world_.read_bodies(bodies_);
  const Pose& X_WT = needs_.about_proxy ? tool.X_WP : tool.X_WT;
  const auto pairs = search_.find(X_WT, bodies_, reach(tool));
  name_near_pieces(world_.geometry(), pairs, bodies_, model);
  builder_.build(needs_.planes_and_points ? pairs : pairs.first(0), X_WT, bodies_, model);
  model.near_object_count = static_cast<std::int32_t>(pairs.size());
  model.sequence = ++sequence_;
  model.time = time;
  model.period = settings_.period;
}

// Angular impulses come about the world's origin; the world takes them about the centres of mass as they are now.
void PhysicsLoop::refer_impulses_to_bodies() {
  for (const Body& body : world_.geometry().bodies) {
    if (body.moving_index < 0) continue;
    const auto i = static_cast<size_t>(body.moving_index);
    impulses_[i].angular -= (bodies_[i].X_WB * body.p_BC).cross(impulses_[i].linear);
  }
}

void PhysicsLoop::step(double time, const ImpulseSums& haptics, IntermediateRepresentation& model) {
  const ToolState tool{haptics.X_WT, haptics.V_WT, haptics.X_WP};
  differences_.take(haptics, impulses_);
  build(time, tool, model);
  refer_impulses_to_bodies();
  world_.advance(settings_.period, tool, impulses_);
}

}  // namespace tegotae
