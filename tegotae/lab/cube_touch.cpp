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

Trajectory CubeTouch::motion(const Tool& tool, const TouchedFeature& feature) {
  const double touching = -lowest_height(tool, feature.q_WT, Vector3::UnitZ());
  const Vector3 turn = kTurning * 0.5 * kEnd * Vector3(0.8, 0.6, 0.0);  // of no symmetry of the cube
  const double middle = touching + 0.5 * (kGap - kPress);
  return Trajectory({{0.0, {{0.0, 0.0, touching + kGap}, feature.q_WT}},
                     {0.5 * kEnd, {{0.0, 0.0, middle}, rotation_from_vector(turn) * feature.q_WT}},
                     {kEnd, {{0.0, 0.0, touching - kPress}, feature.q_WT}}});
}

}  // namespace tegotae
