// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/math/plain.hpp>
#include <tegotae/runtime/world.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <type_traits>

namespace tegotae {

/// Moving bodies of one world that the tool can push. A world that moves more is refused.
inline constexpr int kMaxMovingBodies = 256;

/// Impulse given to one body since the start of the run.
struct ImpulseSum {
  PlainVector3 linear;   ///< N s, world axes
  PlainVector3 angular;  ///< N m s about the world's origin, world axes: where the body is by then, physics knows
};

/// Message of the haptic loop to the physics loop. It travels in a latest-value slot, where messages are skipped: so
/// impulses travel as running sums since the start, of which the receiver applies differences.
struct ImpulseSums {
  std::uint64_t sequence = 0;   ///< 0: nothing yet; then rising with each tick
  double time = 0.0;            ///< of the tick, s
  PlainPose X_WT;               ///< pose of the tool
  PlainTwist V_WT;              ///< of the tool frame's origin, world axes
  PlainPose X_WP;               ///< where the world lets the tool be
  std::int32_t body_count = 0;  ///< bodies[0 .. body_count), by moving_index
  std::array<ImpulseSum, kMaxMovingBodies> bodies;
};
static_assert(std::is_trivially_copyable_v<ImpulseSums>);

/// Haptic side: sums up the impulses that were displayed.
///
/// Rounding: the sums are compensated (Knuth's exact two-sum, the error carried along), so a sum is the exact one
/// rounded once, however many ticks it has. A message's sum S is then off by at most half a unit in the last place,
/// |S| 2^-53, and does not drift: after an hour of a steady 10 N S is 3.6e4 N s and any difference of two messages is
/// right within 7.3e-12 N s (for a body of 1 kg 7.3e-12 m/s), after ten hours within 5.8e-11 N s. Plain summation
/// drifts by 1.7e-6 N s in an hour and by 1.8e-4 N s in ten.
class ImpulseAccumulator {
 public:
  /// Gives the body `wrench` (on the body, about the world's origin, world axes) for `dt` (s). A body out of range or a
  /// wrench that is not finite is not summed up but counted in `dropped`. Does not allocate.
  void add(int moving_index, const Wrench& wrench, double dt) noexcept;

  /// Writes the sums of the first `body_count` bodies (clamped to the capacity); leaves the other fields as they are.
  void fill(ImpulseSums& message, int body_count) const noexcept;

  std::uint64_t dropped() const noexcept { return dropped_; }

 private:
  struct CompensatedSum {
    Vector3 sum = Vector3::Zero();
    Vector3 error = Vector3::Zero();  // what `sum` lacks
  };
  struct BodySum {
    CompensatedSum linear, angular;
  };
  static void add(CompensatedSum& sum, const Vector3& term) noexcept;

  std::array<BodySum, kMaxMovingBodies> bodies_;
  std::uint64_t dropped_ = 0;
};

/// Physics side: turns successive messages into the impulses that are still to be applied.
class ImpulseDifferences {
 public:
  /// impulses[i] = impulse given to moving body i since the message taken last (since the start, for the first one),
  /// its angular part about the world's origin like the sums; zero for bodies that the message does not hold. A message
  /// that is not newer than the last one gives zero and false. So over any pattern of skipped and repeated messages
  /// each impulse is applied once. Does not allocate.
  bool take(const ImpulseSums& message, std::span<BodyImpulse> impulses) noexcept;

 private:
  std::uint64_t last_sequence_ = 0;
  std::array<ImpulseSum, kMaxMovingBodies> last_;
};

}  // namespace tegotae
