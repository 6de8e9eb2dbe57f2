// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/model/intermediate_representation.hpp>

#include <array>

namespace tegotae {

/// Brings the intermediate representation from one physics step to the next at the haptic rate: between two models the
/// contact state is taken to change linearly (paper, section 4.3). Planes are matched by the pieces that they stand
/// between, contact points by the features that they come from; what has no partner appears or leaves at once. Moving
/// bodies are matched by their index; one without partner comes from where its twist puts it a period before.
/// Large (three models): make it once. `accept` and `at` do not allocate and are linear in planes times planes and in
/// points.
class RepresentationInterpolator {
 public:
  /// A new model has come: the one before is where the interpolation starts.
  void accept(const IntermediateRepresentation& model) noexcept;

  /// Period of the newest model, s; 0 before any has come.
  double newest_period() const noexcept { return newest_.period; }

  /// The model at `fraction` of the way (0: the model before, 1: the newest; clamped). Valid until the next call.
  /// Counts, sequence, time, distances and twists are the newest model's. Before any model has come: an empty one,
  /// sequence 0.
  const IntermediateRepresentation& at(double fraction) noexcept;

 private:
  void match() noexcept;
  void match_bodies() noexcept;
  void move_bodies(double fraction) noexcept;
  void match_points(const ContactPlane& plane, const ContactPlane& before) noexcept;

  IntermediateRepresentation previous_;
  IntermediateRepresentation newest_;
  IntermediateRepresentation between_;
  std::array<int, kMaxPlanes> plane_partner_{};         ///< index in previous_, -1: none
  std::array<int, kMaxContactPoints> point_partner_{};  ///< index in previous_, -1: none
  std::array<NearBody, kMaxNearBodies> body_before_;    ///< where the interpolation of each body starts
};

}  // namespace tegotae
