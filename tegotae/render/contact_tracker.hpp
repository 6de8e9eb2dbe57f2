// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/contact/overlay.hpp>
#include <tegotae/model/intermediate_representation.hpp>
#include <tegotae/model/scene_geometry.hpp>
#include <tegotae/render/near_contact.hpp>

#include <optional>
#include <span>
#include <vector>

namespace tegotae {

/// How the friction of pairs is found.
struct FrictionSettings {
  std::optional<double> coefficient;  ///< of all pairs, in place of the scene's
  double scale = 1.0;                 ///< of the scene's coefficients
  double kinetic = 1.0;               ///< while slipping, as a part of the coefficient
  double viscous = 0.0;               ///< N s/m
  double compliance = 1e-9;           ///< m/N, of the bristles
};

/// Follows the near pairs of pieces at the haptic rate: which there are comes from physics, how they face each other is
/// measured here, at the proxy's pose. Only pairs that the next step could bring into contact are measured: of all
/// others a lower bound of the distance is kept, from which every motion is taken off, so a pair far off costs one
/// subtraction. Construction allocates; the rest does not. Keeps a reference to the geometry.
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
  std::span<const OverlayPoint> points(const NearContact& contact, const Pose& X_WP, double reach) noexcept;

  void reset() noexcept;

  std::span<NearContact> contacts() noexcept { return {contacts_.data(), static_cast<size_t>(count_)}; }
  double tool_radius() const noexcept { return tool_radius_; }  ///< from the centre of mass, m
  int skipped() const noexcept { return skipped_; }    ///< measurements over budget and points left out, this tick
  int measured() const noexcept { return measured_; }  ///< distance queries of this tick

 private:
  void take_pairs(const IntermediateRepresentation& model) noexcept;
  void move_objects(const IntermediateRepresentation& model, const Pose& X_WP) noexcept;
  int find(const NearContact& wanted) const noexcept;
  FrictionLaw friction_between(const Shape& a, const Shape& b) const noexcept;
  Facing face(NearContact& contact, const Pose& X_WP) noexcept;
  bool may_stand(const NearContact& contact, double way, double skin) const noexcept;
  bool spend() noexcept;
  const Shape& tool_shape(const NearContact& contact) const noexcept;
  const Shape& body_shape(const NearContact& contact) const noexcept;

  const SceneGeometry& geometry_;
  FrictionSettings friction_;
  double tool_radius_ = 0.0;

  std::vector<NearContact> contacts_, former_;
  int count_ = 0;
  int former_count_ = 0;
  std::vector<int> table_;  ///< of former_, open addressing by pieces; -1: free
  std::uint64_t sequence_ = 0;
  OverlayWorkspace workspace_;
  std::vector<OverlayPoint> points_;
  int skipped_ = 0;
  int measured_ = 0;
};

}  // namespace tegotae
