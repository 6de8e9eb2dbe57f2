// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/contact/placed_shape.hpp>

#include <array>
#include <cstdint>

namespace tegotae {

/// Warm start of one pair, owned by the caller and handed to each query of that pair. A default cache is a cold start.
/// Stale or foreign contents cost time, never correctness. Trivially destructible, no heap.
struct ClosestPointsCache {
  Vector3 direction = Vector3::Zero();  ///< last separating direction from object to tool, in the OBJECT shape's frame
  int vertex_count = 0;                 ///< last simplex: vertices of the two polytopes
  std::array<int, 4> vertex_tool{};
  std::array<int, 4> vertex_object{};
  int hint_tool = 0;  ///< where hill climbing starts
  int hint_object = 0;
};

enum class Separation : std::uint8_t {
  kSeparated,     ///< distance > 0 and certified
  kNotSeparated,  ///< touching, overlapping, or no distance could be certified: ask `penetration`
};

/// Closest points of a tool shape A and an object shape B.
struct ClosestPoints {
  Separation separation = Separation::kNotSeparated;
  double distance = 0.0;           ///< |p_WA - p_WB|, m; meaningful only if separated
  double lower_bound = 0.0;        ///< what the support planes along n_W prove, m; >= kCertificate * distance
  Vector3 p_WA = Vector3::Zero();  ///< on the tool, m
  Vector3 p_WB = Vector3::Zero();  ///< on the object, m
  Vector3 n_W = Vector3::UnitZ();  ///< unit, from the object to the tool
  int iterations = 0;
};

/// GJK closest points (Gilbert, Johnson and Keerthi 1988) of two shapes, at most one of them a plane (closed form),
/// with a certificate: the distance is reported only if the support values along the witness direction prove at least
/// `tolerances::kCertificate` of it; else the query is retried cold from other directions, else the pair is
/// kNotSeparated. Polytopes, spheres and capsules are right to rounding; for cylinders and ellipsoids distance and
/// lower bound meet to 1e-9 of the extent of the pair (to 1e-13 nearly always). Where faces meet faces any pair of
/// facing points is returned; the normal is the face's own, however small the gap. No distance below
/// `tolerances::kLeastDistance` of the extent is reported. Does not allocate; bounded iterations; NaN poses give
/// kNotSeparated, and so do two planes.
ClosestPoints closest_points(const PlacedShape& tool, const PlacedShape& object, ClosestPointsCache& cache) noexcept;

}  // namespace tegotae
