// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/contact/placed_shape.hpp>

#include <optional>
#include <vector>

namespace tegotae::test {

/// normal . p <= offset, world frame, m.
struct OracleHalfSpace {
  Vector3 normal;
  double offset;
};

/// The face planes of the tool and of the dilated object.
std::vector<OracleHalfSpace> half_spaces_of(const PlacedShape& tool, const PlacedShape& object,
                                            const Vector3& dilation_W);

/// Vertices of the half-spaces' intersection by Qhull's half-space mode about `inside`, a strictly inner point.
std::optional<std::vector<Vector3>> vertices_by_qhull(const std::vector<OracleHalfSpace>& half_spaces,
                                                      const Vector3& inside);

/// The same by brute force: every three planes that meet in a point which no plane excludes by more than `tolerance`.
std::vector<Vector3> vertices_by_triples(const std::vector<OracleHalfSpace>& half_spaces, double tolerance);

/// The least slack of `p`, m; negative outside.
double least_slack(const std::vector<OracleHalfSpace>& half_spaces, const Vector3& p);

/// Drops points within `distance` of an earlier one.
std::vector<Vector3> merged(const std::vector<Vector3>& points, double distance);

/// The greatest distance of a point of one set to the nearest of the other, both ways; infinite if the sets differ in
/// number.
double set_distance(const std::vector<Vector3>& a, const std::vector<Vector3>& b);

/// The least distance between two of the points.
double least_spacing(const std::vector<Vector3>& points);

}  // namespace tegotae::test
