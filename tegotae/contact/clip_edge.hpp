// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/contact/clip_locator.hpp>

namespace tegotae {

/// Where a segment enters a convex body.
struct ClipEntry {
  bool found = false;
  double t = 0.0;  ///< from `from` (0) to `to` (1)
  int face = 0;    ///< that is entered
};

/// The point where the segment from `from` crosses `plane`, the only one that excludes `from`, to `to` in the body.
/// Not found if that is `to` itself.
template <class Locator>
ClipEntry clip_entry_through(const Locator& body, const Vector3& from, const Vector3& to, int plane) noexcept {
  const double start = body.slack(plane, from), end = body.slack(plane, to);
  if (end >= -tolerances::kOnPlane || start <= 0.0) return {};
  return {true, start / (start - end), body.face(plane)};
}

/// The first point of the segment from `from`, which lies outside `plane`, to `to` that lies in the body: moves to
/// the plane that is violated, again and again, until none is (Cyrus and Beck 1978, with the planes looked up rather
/// than listed). Not found if the segment passes by, or if it enters only at `to`. Bounded, does not allocate.
template <class Locator>
ClipEntry clip_entry(const Locator& body, const Vector3& from, const Vector3& to, int plane) noexcept {
  // Each round advances along the segment to another face; few edges pass over more than three.
  constexpr int kMaxRounds = 200;
  for (int round = 0; round < kMaxRounds; ++round) {
    const double start = body.slack(plane, from), end = body.slack(plane, to);
    if (end >= -tolerances::kOnPlane || start <= 0.0) return {};
    const double t = start / (start - end);
    const Vector3 p = from + t * (to - from);
    const Located worst = body.locate(p, plane);
    if (worst.slack <= tolerances::kOnPlane || worst.plane == plane) {
      return {true, t, body.face(body.lowest_entered(p, from, plane))};
    }
    plane = worst.plane;
  }
  return {};
}

}  // namespace tegotae
