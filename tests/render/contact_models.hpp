// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/math/rotation.hpp>
#include <tegotae/render/render_types.hpp>
#include <tegotae/shape/mass_properties.hpp>

#include <cmath>
#include <initializer_list>
#include <memory>

// Models that the tests of the methods render from.
namespace tegotae::test {

inline constexpr double kHalfEdge = 0.1;  // m, of the paper's cube
inline constexpr double kTick = 1e-3;     // s
inline const double kGyration = 2.0 * kHalfEdge / std::sqrt(6.0);

/// The given points of the tool against the floor y = 0.
inline std::unique_ptr<IntermediateRepresentation> points_on_floor(std::initializer_list<Vector3> points) {
  auto model = std::make_unique<IntermediateRepresentation>();
  model->sequence = 1;
  model->plane_count = 1;
  model->planes[0].n_W = Vector3(0.0, 1.0, 0.0);
  for (const Vector3& p_T : points) {
    const auto i = static_cast<std::size_t>(model->point_count++);
    model->points[i] = {p_T, i + 1};
  }
  model->planes[0].point_count = model->point_count;
  return model;
}

/// All corners of the cube against the floor y = 0.
inline std::unique_ptr<IntermediateRepresentation> cube_on_floor() {
  const double a = kHalfEdge;
  return points_on_floor(
      {{-a, -a, -a}, {a, -a, -a}, {-a, a, -a}, {a, a, -a}, {-a, -a, a}, {a, -a, a}, {-a, a, a}, {a, a, a}});
}

/// The cube's corners against the floor y = 0 and against a wall x = -0.1 m that it stands flush with.
inline std::unique_ptr<IntermediateRepresentation> cube_in_a_corner() {
  auto model = cube_on_floor();
  model->plane_count = 2;
  model->planes[1].n_W = Vector3(1.0, 0.0, 0.0);
  model->planes[1].p_W = Vector3(-kHalfEdge, 0.0, 0.0);
  model->planes[1].body = 1;
  model->planes[1].first_point = 8;
  model->planes[1].point_count = 8;
  for (std::size_t i = 0; i < 8; ++i) model->points[8 + i] = model->points[i];
  model->point_count = 16;
  return model;
}

/// The cube, 1000 kg/m^3.
inline MassProperties cube_mass() { return mass_properties(make_box(Vector3::Constant(kHalfEdge)), 1000.0); }

inline Pose cube_pose(double angle, double height) {
  return {{0.0, height, 0.0}, rotation_from_vector({0.0, 0.0, angle})};
}

/// Height of the centre at which the lowest edge of the cube turned by `angle` is `depth` below the floor.
inline double height_for(double angle, double depth) {
  return kHalfEdge * (std::abs(std::cos(angle)) + std::abs(std::sin(angle))) - depth;
}

/// What the bodies were given in all, about the world point `centre_W`.
inline Wrench sum_on_bodies(const RenderOutput& output, const Vector3& centre_W) {
  Wrench sum;
  for (const BodyWrench& body : output.bodies.moving()) sum = sum + body.on_body.shifted(body.p_WC - centre_W);
  return sum;
}

}  // namespace tegotae::test
