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
/// kNotSeparated. Does not allocate; bounded iterations; NaN poses give kNotSeparated.
ClosestPoints closest_points(const PlacedShape& tool, const PlacedShape& object, ClosestPointsCache& cache) noexcept;

/// How to part two shapes that are not separated.
struct Penetration {
  bool valid = false;              ///< false: neither expansion nor search gave a bounded answer (NaN, degenerate)
  double depth = 0.0;              ///< m, >= 0: translating the tool by depth * n_W parts the shapes
  Vector3 p_WA = Vector3::Zero();  ///< deepest tool point along -n_W, m
  Vector3 p_WB = Vector3::Zero();  ///< object point that it must come back to: p_WA + depth * n_W, m
  Vector3 n_W = Vector3::UnitZ();  ///< unit, out of the object
  int iterations = 0;
};

/// Least translation that parts the shapes (global minimum over directions). Does not allocate; bounded.
/// Works for separated shapes too close for `closest_points`; if the shapes are clearly separated the answer is
/// invalid.
Penetration penetration(const PlacedShape& tool, const PlacedShape& object, ClosestPointsCache& cache) noexcept;

/// The local minimum of the parting translation reached by descent from the direction `n_start_W` (unit, out of the
/// object): coherent from step to step as long as that minimum exists. Does not allocate; bounded.
Penetration penetration_from(const PlacedShape& tool, const PlacedShape& object, const Vector3& n_start_W,
                             ClosestPointsCache& cache) noexcept;

}  // namespace tegotae
