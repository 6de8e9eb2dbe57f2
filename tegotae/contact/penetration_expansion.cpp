// SPDX-License-Identifier: Apache-2.0
#include <tegotae/contact/penetration_expansion.hpp>

#include <tegotae/contact/penetration_polytope.hpp>
#include <tegotae/contact/tolerances.hpp>
#include <tegotae/math/rotation.hpp>

namespace tegotae::gjk {
namespace {

// The support point of object - tool along n.
Vector3 furthest(Pair& pair, const Vector3& n) noexcept { return -pair.support(n).w; }

struct Span {
  Vector3 upper;  // furthest along a direction
  Vector3 lower;  // furthest against it
};

Span span_along(Pair& pair, const Vector3& n) noexcept { return {furthest(pair, n), furthest(pair, -n)}; }

// Where the difference is a point or a segment, a direction normal to it, towards the origin's side of it.
Vector3 normal_of_flat(const Vector3& on_flat, const Vector3& edge) noexcept {
  const double length2 = edge.squaredNorm();
  Vector3 away = -on_flat;
  if (length2 > 0.0) away -= edge * (edge.dot(away) / length2);
  if (away.norm() > tolerances::kRounding) return away.normalized();
  return length2 > 0.0 ? any_perpendicular(edge.normalized()) : Vector3::UnitZ();
}

// Four points of the difference that span a volume. Where it has none, says so and leaves the normal in `flat_normal`.
bool spanning_tetrahedron(Pair& pair, std::array<Vector3, 4>& corner, Vector3& flat_normal) noexcept {
  const double thin = tolerances::kLeastDistance * pair.extent;
  Span longest = span_along(pair, Vector3::UnitX());
  for (int axis = 1; axis < 3; ++axis) {
    const Span span = span_along(pair, Vector3::Unit(axis));
    if ((span.upper - span.lower).squaredNorm() > (longest.upper - longest.lower).squaredNorm()) longest = span;
  }
  const Vector3 edge = longest.upper - longest.lower;
  flat_normal = normal_of_flat(longest.upper, edge);
  if (edge.norm() <= thin) return false;
  const Vector3 along = edge.normalized();

  const Vector3 side = any_perpendicular(along);
  const Vector3 other_side = along.cross(side);
  Vector3 third = longest.upper;
  double width = 0.0;
  for (const Vector3& n : {side, Vector3(-side), other_side, Vector3(-other_side)}) {
    const Vector3 p = furthest(pair, n);
    const double distance = (p - longest.upper).cross(along).norm();
    if (distance > width) {
      width = distance;
      third = p;
    }
  }
  if (width <= thin) return false;
  flat_normal = (third - longest.upper).cross(along).normalized();

  const Span height = span_along(pair, flat_normal);
  const double over = flat_normal.dot(height.upper - third);
  const double under = flat_normal.dot(third - height.lower);
  corner = {longest.upper, longest.lower, third, over > under ? height.upper : height.lower};
  return std::max(over, under) > thin;
}

void keep_lesser(CoreDepth& best, const Vector3& n, double depth) noexcept {
  if (depth < best.depth) {
    best.depth = depth;
    best.n = n;
  }
}

}  // namespace

CoreDepth least_depth(Pair& pair) noexcept {
  CoreDepth best;
  std::array<Vector3, 4> corner;
  Vector3 flat_normal;
  if (!spanning_tetrahedron(pair, corner, flat_normal)) {
    for (const double sign : {1.0, -1.0}) {
      const Vector3 n = sign * flat_normal;
      keep_lesser(best, n, n.dot(furthest(pair, n)));
    }
    return best;
  }
  const double tolerance = (pair.has_vertices() ? tolerances::kRounding : tolerances::kCurvedDepth) * pair.extent;
  GrowingPolytope polytope(tolerances::kRounding * pair.extent);
  if (!polytope.start(corner)) return best;
  while (best.iterations < GrowingPolytope::kMaxPoints) {
    ++best.iterations;
    const GrowingPolytope::Face& face = polytope.nearest_face();
    const Vector3 p = furthest(pair, face.n);
    const double depth = face.n.dot(p);
    keep_lesser(best, face.n, depth);
    if (best.depth - face.d <= tolerance || depth - face.d <= tolerance) break;
    if (!polytope.grow(face, p)) break;
  }
  return best;
}

}  // namespace tegotae::gjk
