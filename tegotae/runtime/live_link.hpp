// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/render/contact_view.hpp>
#include <tegotae/runtime/haptic_tick.hpp>
#include <tegotae/runtime/impulse_sums.hpp>
#include <tegotae/runtime/latest_value.hpp>
#include <tegotae/runtime/mailbox.hpp>
#include <tegotae/runtime/physics_loop.hpp>
#include <tegotae/runtime/realtime_thread.hpp>

#include <array>
#include <atomic>
#include <cstdint>
#include <functional>
#include <span>
#include <type_traits>

namespace tegotae {

/// What may change of the physics loop while it runs.
struct PhysicsUpdate {
  PhysicsLoop::Settings settings;
  ModelNeeds needs;
};

/// Where the moving bodies are, and how the physics step went that began there.
struct MovingBodies {
  double time = 0.0;           ///< s, of the poses
  double period = 0.0;         ///< s, of the physics
  double step_duration = 0.0;  ///< s of computation, of the step before
  std::uint64_t steps = 0;     ///< since the run began
  std::int32_t count = 0;
  std::array<PlainPose, kMaxMovingBodies> poses;

  std::span<const PlainPose> used() const noexcept { return {poses.data(), static_cast<std::size_t>(count)}; }
};
static_assert(std::is_trivially_copyable_v<MovingBodies>);

/// The link of a run in real time to somebody who watches and steers it: one thread, the one that the observer of
/// `run_realtime` is called on. All that crosses does so without a lock, and the loops never wait. For one run.
struct LiveLink {
  // From the one who steers.
  Mailbox<HapticUpdate> haptic_updates;        ///< in force from the next tick
  LatestValue<PhysicsUpdate> physics_updates;  ///< in force from the next step
  std::atomic<bool> paused{false};             ///< time stands still
  std::atomic<bool> ending{false};             ///< the run ends, though nobody looks at its ticks
  std::atomic<int> ticks_granted{0};           ///< that haptics may go on by although paused
  std::atomic<int> steps_granted{0};           ///< likewise, of the physics
  /// Whether the interface's time is that of the run, as of simulated ones, and stands still with it. The others are
  /// commanded zero, through the safety stage, as long as the run is paused.
  bool interface_waits = true;

  // To the one who watches.
  double view_period = 1.0 / 60.0;    ///< s between contact views
  LatestValue<ContactView> contacts;  ///< of the haptic thread
  LatestValue<MovingBodies> bodies;   ///< of the physics thread
  /// Called once on the observer's thread: what the system has granted to both loops.
  std::function<void(const RealtimeRights& haptics, const RealtimeRights& physics)> on_rights;
  std::function<void()> on_pass;  ///< called on the observer's thread after each look at the records, every 5 ms

  /// Stops time or lets it go on; steps that were granted and not taken are forgotten.
  void pause(bool stands_still) noexcept;

  /// One physics period of `physics_period` (s), haptics at `haptic_period` (s); what is left of the last one is not
  /// added.
  void grant_step(double physics_period, double haptic_period) noexcept;
};

}  // namespace tegotae
