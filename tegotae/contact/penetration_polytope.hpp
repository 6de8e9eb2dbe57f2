// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/math/types.hpp>

#include <array>

namespace tegotae::gjk {

/// A triangulated convex polytope that grows point by point, in fixed arrays.
class GrowingPolytope {
 public:
  static constexpr int kMaxPoints = 256;
  static constexpr int kMaxFaces = 2 * kMaxPoints;

  struct Face {
    std::array<int, 3> vertex{};  ///< counter-clockwise seen from outside
    std::array<int, 3> across{};  ///< the face on the other side of the edge vertex[k] -> vertex[k + 1]
    Vector3 n = Vector3::Zero();  ///< unit, outward
    double d = 0.0;               ///< m: n.p == d on the face; negative when the origin lies outside of it
    bool alive = false;
    bool visible = false;
  };

  /// Points nearer to a face's plane than `coplanar` (m) count as lying on it.
  explicit GrowingPolytope(double coplanar) noexcept : coplanar_(coplanar) {}

  /// Begins with a tetrahedron; false if it is flat.
  bool start(const std::array<Vector3, 4>& corner) noexcept;
  /// The face whose plane has the least d.
  const Face& nearest_face() const noexcept;
  /// Adds the point `p`, which lies outside of `face`. False, with the polytope no longer usable, when the capacity is
  /// full or rounding left no simple horizon.
  bool grow(const Face& face, const Vector3& p) noexcept;

 private:
  struct HorizonEdge {
    int from = 0;
    int to = 0;
    int outer_face = 0;
  };

  bool add_face(int a, int b, int c, int& index) noexcept;
  void link(int inner, int from, int to, int outer) noexcept;
  void collect_visible(int first, const Vector3& p) noexcept;
  bool collect_horizon() noexcept;
  bool fan(int apex) noexcept;

  double coplanar_;
  int point_count_ = 0;
  int face_count_ = 0;  // slots in use, dead ones included
  int free_count_ = 0;
  int visible_count_ = 0;
  int horizon_count_ = 0;
  std::array<Vector3, kMaxPoints> point_;
  std::array<Face, kMaxFaces> face_;
  std::array<int, kMaxFaces> free_;
  std::array<int, kMaxFaces> visible_;
  std::array<HorizonEdge, kMaxFaces> horizon_;
  std::array<int, kMaxPoints> fan_from_;  // the fan's face whose horizon edge begins at a point, -1 none
};

}  // namespace tegotae::gjk
