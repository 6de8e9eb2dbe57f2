// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/contact/overlay.hpp>
#include <tegotae/model/intermediate_representation.hpp>
#include <tegotae/model/scene_geometry.hpp>
#include <tegotae/render/friction_rule.hpp>
#include <tegotae/render/near_contact.hpp>
#include <tegotae/render/near_pairs.hpp>

#include <span>
#include <utility>
#include <vector>

namespace tegotae {

/// Follows the near pairs of pieces at the haptic rate: which there are comes from physics, how they face each other is
/// measured here, at the proxy's pose. Only pairs that the next step could bring into contact are measured: of all
/// others a lower bound of the distance is kept (NearPairs).
///
/// Measurements have a budget, spent on the nearest first. A pair that gets none is counted, and its last plane stands
/// in: the tool's part above the plane that supports the object, normal to the last normal. It guards more than the
/// object does (a plane has no edge), never less, until the pair's turn comes.
/// Construction allocates; the rest does not. Keeps a reference to the geometry.
class ContactTracker {
 public:
  ContactTracker(const SceneGeometry& geometry, const FrictionSettings& friction);

  /// Takes the pairs of a new model and the bodies' poses of every model; the tool's proxy is at `X_WP`.
  void take(const IntermediateRepresentation& model, const Pose& X_WP) noexcept;

  /// Measures every pair that may be within `margin` of the nearest one. Returns the least gap, m (1e300 without any).
  double measure(const Pose& X_WP, double margin) noexcept;

  /// Measures at `X_WP`, `way` (m, of any tool point) from the present pose, every pair that may be nearer than `skin`
  /// there. False as soon as one is worse than it may be: nearer than a quarter of `skin`, than it is now and than the
  /// linear model says, or on another side.
  bool examine(const Pose& X_WP, double way, double skin) noexcept;

  /// The pose last examined becomes the present one.
  void accept(double way) noexcept;

  /// Contact points of one pair at the present pose with gap < `reach`. Valid until the next call.
  /// Facing `by_plane` of a contact that was measured: see `stand_in`.
  std::span<const OverlayPoint> points(const NearContact& contact, const Facing& facing, const Pose& X_WP,
                                       double reach) noexcept;

  /// How the pair faces along the normal `n_W` (unit) of another pair.
  Facing stand_in(NearContact& contact, const Vector3& n_W, const Pose& X_WP) const noexcept {
    return facing_along(placed_tool(contact, X_WP), placed_object(contact), n_W, contact.cache);
  }

  void reset() noexcept;

  /// Rubs from now on as `other` does, the pairs that touch already too.
  void adopt_friction(const ContactTracker& other) noexcept;

  /// The pairs that were within reach of late.
  std::span<NearContact> contacts() noexcept { return {contacts_.data(), static_cast<size_t>(count_)}; }
  std::span<const NearContact> contacts() const noexcept { return {contacts_.data(), static_cast<size_t>(count_)}; }
  double tool_radius() const noexcept { return tool_radius_; }        ///< from the centre of mass, m
  double bodies_way() const noexcept { return pairs_.bodies_way(); }  ///< m, of any near body's point, this tick
  int skipped() const noexcept { return skipped_; }    ///< pairs without a measurement and points left out, this tick
  int measured() const noexcept { return measured_; }  ///< distance queries for refreshing pairs, this tick

 private:
  void rename_contacts() noexcept;
  void leave_unserved() noexcept;
  void follow_objects(const Pose& X_WP) noexcept;
  int enter(int pair) noexcept;
  void enter_nearest() noexcept;
  void queue_unmeasured(double limit) noexcept;
  void serve(NearContact& contact, const Pose& X_WP) noexcept;
  void fall_back(NearContact& contact, const Pose& X_WP, Facing& facing) noexcept;
  bool may_stand(const NearContact& contact, double way, double skin) const noexcept;
  PlacedShape placed_tool(const NearContact& contact, const Pose& X_WP) const noexcept;
  PlacedShape placed_object(const NearContact& contact) const noexcept;
  const Shape& tool_shape(const NearContact& contact) const noexcept;
  const Shape& body_shape(const NearContact& contact) const noexcept;

  const SceneGeometry& geometry_;
  FrictionSettings friction_;
  double tool_radius_ = 0.0;
  Shape half_space_;  ///< stands in for objects whose plane does

  NearPairs pairs_;
  std::vector<NearContact> contacts_;
  int count_ = 0;
  std::vector<std::pair<double, int>> queue_;  ///< room and place of the contacts to measure
  OverlayWorkspace workspace_;
  std::vector<OverlayPoint> points_;
  int skipped_ = 0;
  int measured_ = 0;
  int trials_ = 0;
};

}  // namespace tegotae
