// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/math/pose.hpp>
#include <tegotae/shape/colour.hpp>
#include <tegotae/shape/convex_hull.hpp>

#include <memory>
#include <span>
#include <string_view>

namespace tegotae {

enum class ShapeKind { kBox, kSphere, kCapsule, kCylinder, kEllipsoid, kHull, kPlane };

/// The name of a kind: "box", "sphere", ...
std::string_view name_of(ShapeKind kind) noexcept;

/// One convex shape and where it sits on its body. A value: the polytope is shared and immutable.
///
/// | kind      | size (m)                         | axis |
/// |-----------|----------------------------------|------|
/// | box       | half edges x, y, z               |      |
/// | sphere    | radius, -, -                     |      |
/// | capsule   | radius, half length of axis, -   | z    |
/// | cylinder  | radius, half height, -           | z    |
/// | ellipsoid | semi-axes x, y, z                |      |
/// | hull      | -                                |      |
/// | plane     | - (the half-space z <= 0)        | z    |
struct Shape {
  ShapeKind kind = ShapeKind::kSphere;
  Vector3 size = Vector3::Zero();
  Pose X_BS;                  ///< the shape's frame on its body
  double friction = 1.0;      ///< Coulomb coefficient of sliding, dimensionless
  bool frictionless = false;  ///< the scene asks for frictionless contact (MJCF condim 1)
  int priority = 0;           ///< of unequal ones the greater says how the pair rubs (MJCF priority)
  int contact_type = 1;       ///< bit masks of the scene's contact filter (MJCF contype, conaffinity)
  int contact_affinity = 1;

  /// Where face planes or overlay vertices are needed: the shape itself (box, hull), a polytope inscribed in it
  /// (curved kinds) or null (plane).
  std::shared_ptr<const Polytope> polytope;
  double polytope_error = 0.0;  ///< greatest distance of the shape's surface from the polytope's, m; 0 when exact

  Colour colour;  ///< for pictures of it; nothing that is felt depends on it

  bool is_polytope() const noexcept { return kind == ShapeKind::kBox || kind == ShapeKind::kHull; }
  bool is_bounded() const noexcept { return kind != ShapeKind::kPlane; }
};

/// Whether the scene's filter lets the two shapes touch: one's type shares a bit with the other's affinity.
inline bool may_touch(const Shape& a, const Shape& b) noexcept {
  return ((a.contact_type & b.contact_affinity) | (b.contact_type & a.contact_affinity)) != 0;
}

// Makers. All throw std::invalid_argument when a length is not finite and positive, and allocate.

Shape make_box(const Vector3& half_edges, const Pose& X_BS = {});
Shape make_sphere(double radius, const Pose& X_BS = {});
Shape make_capsule(double radius, double half_length, const Pose& X_BS = {});
Shape make_cylinder(double radius, double half_height, const Pose& X_BS = {});
Shape make_ellipsoid(const Vector3& semi_axes, const Pose& X_BS = {});
/// Hull of `points`, in the shape's frame (m); errors as `convex_hull`.
Shape make_hull(std::span<const Vector3> points, const Pose& X_BS = {}, double coplanarity = kExactCoplanarity);
/// The half-space below the plane through the shape frame's origin with outward normal z.
Shape make_plane(const Pose& X_BS = {});

}  // namespace tegotae
