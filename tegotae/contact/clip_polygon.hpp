// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/math/types.hpp>

#include <vector>

namespace tegotae {

/// A convex polygon in a plane in space, cut by one half-space after another; every side remembers which half-space
/// it comes from. Fixed memory.
class ClipPolygon {
 public:
  struct Corner {
    Vector3 p = Vector3::Zero();  ///< m
    int side = 0;                 ///< label of the side from here to the next corner
  };
  static constexpr int kNoLabel = -1;  ///< of the sides of the first square

  /// Allocates; nothing else does. A polygon gains at most one corner a cut.
  explicit ClipPolygon(int capacity);

  /// The square of half edge `half_edge` (m) about `centre` in the plane of normal `n` (unit).
  void start(const Vector3& centre, const Vector3& n, double half_edge) noexcept;
  /// Keeps what lies in n.p <= d, to kOnPlane; the new side is labelled `label`.
  void cut(const Vector3& n, double d, int label) noexcept;
  /// Whether a corner lies outside n.p <= d by more than kOnPlane.
  bool reaches_beyond(const Vector3& n, double d) const noexcept;

  int size() const noexcept { return size_; }
  const Corner& operator[](int i) const noexcept { return corners_[static_cast<size_t>(i)]; }
  /// Label of the side that ends in corner i.
  int side_before(int i) const noexcept { return corners_[static_cast<size_t>(i == 0 ? size_ - 1 : i - 1)].side; }

 private:
  void push(const Vector3& p, int side) noexcept;

  std::vector<Corner> corners_, next_;
  int size_ = 0, next_size_ = 0;
};

}  // namespace tegotae
