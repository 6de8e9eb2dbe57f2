// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/contact/tolerances.hpp>
#include <tegotae/shape/polytope.hpp>

#include <cstdint>
#include <span>

namespace tegotae {

// Ways to find the face plane of a convex body that a point violates most. Each names its planes by a number of its
// own, `plane`, and knows the face that it stands for. `slack` is a point's signed distance from a plane, m, positive
// outside. All work in the body's frame and allocate nothing.

/// A half-space normal . p <= offset, and the face that it comes from.
struct ClipPlane {
  Vector3 normal = Vector3::Zero();  ///< unit
  double offset = 0.0;               ///< m
  int face = 0;
};

struct Located {
  int plane = 0;       ///< the most violated, or the nearest to being so
  double slack = 0.0;  ///< m, of that plane
};

/// Whether a segment that comes from `from` passes through `plane` at `p`.
template <class Locator>
bool is_entered(const Locator& body, int plane, const Vector3& p, const Vector3& from) noexcept {
  return body.slack(plane, p) >= -tolerances::kOnPlane && body.slack(plane, from) > tolerances::kOnPlane;
}

/// Looks at every plane: right for any set of planes.
class PlaneScan {
 public:
  explicit PlaneScan(std::span<const ClipPlane> planes) noexcept : planes_(planes) {}

  int face(int plane) const noexcept { return planes_[static_cast<size_t>(plane)].face; }
  double slack(int plane, const Vector3& p) const noexcept {
    const ClipPlane& half_space = planes_[static_cast<size_t>(plane)];
    return half_space.normal.dot(p) - half_space.offset;
  }
  Located locate(const Vector3& p, int /*hint*/) const noexcept {
    Located worst{0, slack(0, p)};
    for (int k = 1; k < static_cast<int>(planes_.size()); ++k) {
      const double s = slack(k, p);
      if (s > worst.slack) worst = {k, s};
    }
    return worst;
  }
  /// Of the planes that meet in `p`, a point of `plane`, and exclude `from`, the one of the lowest face.
  int lowest_entered(const Vector3& p, const Vector3& from, int plane) const noexcept {
    int lowest = plane;
    for (int k = 0; k < static_cast<int>(planes_.size()); ++k) {
      if (face(k) < face(lowest) && is_entered(*this, k, p, from)) lowest = k;
    }
    return lowest;
  }

 private:
  std::span<const ClipPlane> planes_;
};

/// Walks over the faces of a polytope. Seen from an inner point c, the plane n.p <= d is the vertex n / (d - n.c) of
/// the dual polytope, and the plane that the ray from c through p meets first is that polytope's support vertex along p
/// - c: hill climbing over the dual's edges, which join neighbouring faces, finds it from any start. The slack that it
/// gives is of that plane; its sign is the point's.
class FaceWalk {
 public:
  explicit FaceWalk(const Polytope& polytope) noexcept : polytope_(polytope) {}

  int face(int plane) const noexcept { return plane; }
  double slack(int plane, const Vector3& p) const noexcept {
    const Polytope::Face& f = polytope_.faces[static_cast<size_t>(plane)];
    return f.normal.dot(p) - f.offset;
  }
  Located locate(const Vector3& p, int hint) const noexcept {
    const Vector3 ray = p - polytope_.centroid;
    int best = hint;
    double best_ratio = ratio(hint, ray);
    for (size_t step = 0; step < polytope_.faces.size(); ++step) {
      const int from = best;
      for (const int neighbor : polytope_.neighbors_of(polytope_.faces[static_cast<size_t>(from)])) {
        const double r = ratio(neighbor, ray);
        if (r > best_ratio) best_ratio = r, best = neighbor;
      }
      if (best == from) break;
    }
    return {best, slack(best, p)};
  }
  int lowest_entered(const Vector3& p, const Vector3& from, int plane) const noexcept {
    int lowest = plane;
    for (const int neighbor : polytope_.neighbors_of(polytope_.faces[static_cast<size_t>(plane)])) {
      if (neighbor < lowest && is_entered(*this, neighbor, p, from)) lowest = neighbor;
    }
    return lowest;
  }

 private:
  double ratio(int plane, const Vector3& ray) const noexcept {
    const Polytope::Face& f = polytope_.faces[static_cast<size_t>(plane)];
    return f.normal.dot(ray) / (f.offset - f.normal.dot(polytope_.centroid));
  }

  const Polytope& polytope_;
};

}  // namespace tegotae
