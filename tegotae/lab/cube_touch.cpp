// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/cube_touch.hpp>

#include <tegotae/lab/input_error.hpp>
#include <tegotae/lab/motion.hpp>
#include <tegotae/math/rotation.hpp>

#include <fmt/format.h>

#include <array>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace tegotae {
namespace {

constexpr double kHalfEdge = 0.1;  // m

}  // namespace

std::span<const TouchedFeature> touched_features() {
  static const std::array<TouchedFeature, 3> features{
      {{"vertex", Quaternion::FromTwoVectors(Vector3(1.0, 1.0, 1.0), Vector3(0.0, 0.0, -1.0))},
       {"edge", rotation_from_vector(0.25 * std::numbers::pi * Vector3::UnitY())},
       {"face", Quaternion::Identity()}}};
  return features;
}

const TouchedFeature& touched_feature(std::string_view name) {
  std::string names;
  for (const TouchedFeature& feature : touched_features()) {
    if (feature.name == name) return feature;
    names.append(names.empty() ? "" : ", ").append(feature.name);
  }
  throw InputError(fmt::format("there is no contact '{}'; there are: {}.", name, names));
}

SceneGeometry cube_over_floor() {
  SceneGeometry scene;
  scene.tool.name = "cube";
  scene.tool.pieces = {make_box(Vector3::Constant(kHalfEdge))};
  scene.tool.mass = mass_properties(scene.tool.pieces[0], 1000.0);
  scene.tool.X_WT.p = Vector3(0.0, 0.0, 3.0 * kHalfEdge);
  Body floor;
  floor.name = "floor";
  floor.pieces = {make_box(Vector3(1.0, 1.0, 0.1))};
  floor.X_WB.p = Vector3(0.0, 0.0, -0.1);
  scene.bodies.push_back(std::move(floor));
  return scene;
}

CubeTouch::CubeTouch(const GripMechanics& mechanics, const HandImpedance& hand)
    : depth_(kPress + mechanics.friction_force / hand.stiffness) {
  if (!(hand.stiffness > 0.0)) throw InputError("a hand without stiffness cannot press on the floor.");
}

Trajectory CubeTouch::motion(const Tool& tool, const TouchedFeature& feature) const {
  const double touching = -lowest_height(tool, feature.q_WT, Vector3::UnitZ());
  const double begin = end() - (kGap + kPress) / kSpeed, middle = 0.5 * (begin + end());  // s, of the turning
  const Vector3 turn = kTurning * (middle - begin) * Vector3(0.8, 0.6, 0.0);              // of no symmetry of the cube
  const auto at = [&](double time, const Vector3& angle) {
    const double height = touching + kGap - kSpeed * time;
    return Trajectory::Sample{time, {{0.0, 0.0, height}, rotation_from_vector(angle) * feature.q_WT}};
  };
  std::vector<Trajectory::Sample> samples{at(0.0, Vector3::Zero())};
  if (begin > 0.0) samples.push_back(at(begin, Vector3::Zero()));
  samples.push_back(at(middle, turn));
  samples.push_back(at(end(), Vector3::Zero()));
  return Trajectory(std::move(samples));
}

}  // namespace tegotae
