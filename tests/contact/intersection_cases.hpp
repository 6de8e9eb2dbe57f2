// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/contact/intersection.hpp>

#include <tests/random_shapes.hpp>

#include <algorithm>
#include <random>
#include <vector>

namespace tegotae::test {

/// Vertices of an intersection agree to this: m, at unit size.
inline constexpr double kSame = 1e-9;

/// A tool, an object and where they are.
struct IntersectionCase {
  Shape tool, object;
  Pose X_WT, X_WO;
  Vector3 dilation = Vector3::Zero();  ///< world frame, m

  PlacedShape placed_tool() const { return {tool, X_WT}; }
  PlacedShape placed_object() const { return {object, X_WO}; }
};

inline Shape random_polytope(std::mt19937_64& random, int most_vertices) {
  std::uniform_int_distribution<int> count(6, most_vertices);
  std::uniform_real_distribution<double> half(0.2, 1.0);
  if (random() % 3 != 0) return make_hull(random_hull_points(random, count(random), 1.0));
  const double x = half(random), y = half(random), z = half(random);
  return make_box({x, y, z});
}

/// Hulls of 6 to 60 vertices, boxes and planes of unit size; dilation 0 or up to 0.5 m; turned a little or at random.
inline IntersectionCase random_case(std::mt19937_64& random, int most_vertices = 60) {
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  IntersectionCase result{random_polytope(random, most_vertices), {}, {}, {}, Vector3::Zero()};
  result.object = random() % 6 == 0 ? make_plane() : random_polytope(random, most_vertices);
  result.X_WO = random_pose(random, 0.5);
  result.X_WT = random_pose(random, 0.9);
  if (random() % 3 == 0) {
    // Nearly aligned: tilts down to 1e-3 rad.
    const Vector3 tilt = std::pow(10.0, -3.0 * unit(random)) * random_unit(random);
    result.X_WT.q = result.X_WO.q * rotation_from_vector(tilt);
  }
  if (random() % 2 == 0) result.dilation = 0.5 * unit(random) * unit(random) * random_unit(random);
  return result;
}

inline IntersectionCase random_small_case(std::mt19937_64& random) { return random_case(random, 12); }

inline std::vector<IntersectionVertex> clip(const IntersectionCase& pair, ClipWorkspace& workspace) {
  std::vector<IntersectionVertex> vertices(8192);
  const int count =
      intersection_by_clipping(pair.placed_tool(), pair.placed_object(), pair.dilation, workspace, vertices);
  vertices.resize(static_cast<size_t>(std::max(count, 0)));
  return vertices;
}

inline std::vector<Vector3> points_of(const std::vector<IntersectionVertex>& vertices) {
  std::vector<Vector3> points;
  for (const auto& vertex : vertices) points.push_back(vertex.p_W);
  return points;
}

/// Whether every vertex has a name, and each its own.
inline bool features_differ(const std::vector<IntersectionVertex>& vertices) {
  std::vector<std::uint64_t> features;
  for (const auto& vertex : vertices) features.push_back(vertex.feature);
  std::sort(features.begin(), features.end());
  return (features.empty() || features.front() != 0) &&
         std::adjacent_find(features.begin(), features.end()) == features.end();
}

}  // namespace tegotae::test
