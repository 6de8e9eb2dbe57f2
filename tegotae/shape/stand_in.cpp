// SPDX-License-Identifier: Apache-2.0
#include <tegotae/shape/stand_in.hpp>

#include <tegotae/shape/convex_hull.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tegotae {
namespace {

// Vertices round the circle and rings from pole to pole. 32 x 16 keeps a contact within the capacity of a tick and the
// error below one percent of the radius; exact closest points come from the true shape.
constexpr int kSegments = 32;
constexpr int kRings = 16;

// Points of the unit sphere: rings of kSegments points and the two poles.
std::vector<Vector3> unit_sphere() {
  std::vector<Vector3> points{{0.0, 0.0, 1.0}, {0.0, 0.0, -1.0}};
  for (int ring = 1; ring < kRings; ++ring) {
    const double polar = std::numbers::pi * ring / kRings;
    for (int k = 0; k < kSegments; ++k) {
      const double turn = 2.0 * std::numbers::pi * k / kSegments;
      points.emplace_back(std::sin(polar) * std::cos(turn), std::sin(polar) * std::sin(turn), std::cos(polar));
    }
  }
  return points;
}

// The unit sphere stands out furthest over the face whose plane is nearest to the centre.
double unit_sphere_error(const Polytope& polytope) {
  double nearest = 1.0;
  for (const auto& face : polytope.faces) nearest = std::min(nearest, face.offset);
  return 1.0 - nearest;
}

}  // namespace

StandIn sphere_stand_in(double radius) { return ellipsoid_stand_in(Vector3::Constant(radius)); }

StandIn ellipsoid_stand_in(const Vector3& semi_axes) {
  std::vector<Vector3> points = unit_sphere();
  const double unit_error = unit_sphere_error(convex_hull(points));
  for (Vector3& p : points) p = p.cwiseProduct(semi_axes);
  // An affine image: heights over a face shrink or grow by at most the largest semi-axis.
  return {convex_hull(points), unit_error * semi_axes.maxCoeff()};
}

StandIn capsule_stand_in(double radius, double half_length) {
  std::vector<Vector3> points;
  const std::vector<Vector3> sphere = unit_sphere();
  for (const Vector3& p : sphere) {
    if (p.z() > -1e-9) points.emplace_back(radius * p + Vector3(0.0, 0.0, half_length));
    if (p.z() < 1e-9) points.emplace_back(radius * p - Vector3(0.0, 0.0, half_length));
  }
  return {convex_hull(points), unit_sphere_error(convex_hull(sphere)) * radius};
}

StandIn cylinder_stand_in(double radius, double half_height) {
  std::vector<Vector3> points;
  for (int k = 0; k < kSegments; ++k) {
    const double turn = 2.0 * std::numbers::pi * k / kSegments;
    for (const double z : {-half_height, half_height}) {
      points.emplace_back(radius * std::cos(turn), radius * std::sin(turn), z);
    }
  }
  return {convex_hull(points), radius * (1.0 - std::cos(std::numbers::pi / kSegments))};
}

}  // namespace tegotae
