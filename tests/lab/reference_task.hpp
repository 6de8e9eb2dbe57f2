// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/lab/offline_reference.hpp>
#include <tegotae/math/rotation.hpp>

#include <numbers>
#include <vector>

namespace tegotae {

/// rad
inline constexpr double kDegreeOfArc = std::numbers::pi / 180.0;

/// The skin of a coupling softer than 20 kN/m, m.
inline constexpr double kThinSkin = 2e-6;

inline Pose placed_at(double x, double y, double z) { return Pose{.p = {x, y, z}}; }

/// `degrees` about x, y, z, as one rotation vector.
inline Pose placed_at(double x, double y, double z, const Vector3& degrees) {
  return {{x, y, z}, rotation_from_vector(kDegreeOfArc * degrees)};
}

/// One body of `pieces`, and a tool of one piece whose centre of mass is its frame's origin.
inline SceneGeometry touching_scene(Shape tool, std::vector<Shape> pieces) {
  SceneGeometry scene;
  scene.tool.pieces = {std::move(tool)};
  scene.bodies.resize(1);
  scene.bodies[0].pieces = std::move(pieces);
  return scene;
}

/// Poses from one to the next, evenly, a tick each.
class HandPath {
 public:
  explicit HandPath(const Pose& start) : poses_{start} {}
  HandPath& to(const Pose& end, int ticks) {
    const Pose start = poses_.back();
    for (int tick = 1; tick <= ticks; ++tick)
      poses_.push_back(interpolate(start, end, static_cast<double>(tick) / ticks));
    return *this;
  }
  const std::vector<Pose>& poses() const { return poses_; }

 private:
  std::vector<Pose> poses_;
};

struct HandCoupling {
  double stiffness = 2000.0;    // N/m
  double metric_length = 0.02;  // m
};

inline std::vector<ReferenceSample> solve_offline(const SceneGeometry& scene, const HandPath& path,
                                                  const HandCoupling& coupling, double hand_step = kReferenceHandStep) {
  SessionSettings settings;
  settings.stiffness = coupling.stiffness;
  settings.metric_length = coupling.metric_length;
  return offline_reference(hand_step)({scene, path.poses(), 1e-3, settings}, {});
}

}  // namespace tegotae
