// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/math/wrench.hpp>
#include <tegotae/model/intermediate_representation.hpp>

#include <array>

namespace tegotae {

/// What the tool does to one moving body.
struct BodyWrench {
  int moving_index = -1;
  Vector3 p_WC = Vector3::Zero();  ///< the body's centre of mass, m
  Wrench on_body;                  ///< about p_WC, world axes
};

/// The tool's push on the moving bodies, and on all static ones together: its sum is the opposite of the wrench on the
/// tool. Fixed capacity; no allocation.
class BodyWrenches {
 public:
  void clear() noexcept;

  /// Adds `force` (N, on the body) at the world point `p_W`, for the body of `plane`.
  void add(const ContactPlane& plane, const Vector3& p_W, const Vector3& force) noexcept;

  /// The same for the body `moving_index` (-1: static) with centre of mass `p_WC` (m), and a torque (N m).
  void add(int moving_index, const Vector3& p_WC, const Vector3& p_W, const Vector3& force,
           const Vector3& torque) noexcept;

  /// The bodies receive what was displayed, not what was computed: all pushes times the one factor that brings the
  /// opposite of their sum nearest to the displayed wrench on the tool (about `centre_W`), torques compared with forces
  /// at `length` (m). Nothing displayed: nothing received. A body is pushed with no more than
  /// `kGreatestAmplification` times what the hand feels, force and torque over `length` together: bodies that squeeze
  /// the tool between them are not driven apart by forces of which the hand knows nothing.
  ///
  /// Of a body whose mass `near` tells, what goes beyond what the hand feels is also held to what gives it
  /// `kFastestThrow` in a physics period of `period` (s), and the torque to that force at an arm of `kLongestArm`
  /// gyration lengths: before the period is over nobody knows where the body has gone, and a light one would be thrown
  /// away.
  void share(const Wrench& displayed, const Vector3& centre_W, double length, std::span<const NearBody> near = {},
             double period = 0.0) noexcept;

  /// A wedge of 6 degrees multiplies the force on the tool by about ten.
  static constexpr double kGreatestAmplification = 10.0;

  /// m/s: half the speed of a brisk hand.
  static constexpr double kFastestThrow = 0.5;

  /// No corner of a uniform body is further from its centre of mass: a thin rod's ends are at 2.1, a cube's corners
  /// too.
  static constexpr double kLongestArm = 3.0;

  std::span<const BodyWrench> moving() const noexcept { return {bodies_.data(), static_cast<std::size_t>(count_)}; }
  std::span<BodyWrench> moving() noexcept { return {bodies_.data(), static_cast<std::size_t>(count_)}; }

 private:
  BodyWrench* find_or_add(int moving_index, const Vector3& p_WC) noexcept;

  std::array<BodyWrench, kMaxPlanes> bodies_;
  int count_ = 0;
  BodyWrench static_bodies_;  ///< about the world's origin
};

}  // namespace tegotae
