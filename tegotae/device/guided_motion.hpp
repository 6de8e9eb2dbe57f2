// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/device/intended_motion.hpp>
#include <tegotae/math/plain.hpp>
#include <tegotae/runtime/latest_value.hpp>
#include <tegotae/runtime/mailbox.hpp>

#include <atomic>
#include <cstdint>

namespace tegotae {

/// A motion that a person guides while it goes on, from another thread: the pose of a mouse or a key, or a scripted
/// motion. A hand neither leaps nor shakes, whatever is sent: a target is approached with a time constant of 20 ms and
/// at no more than 1 m/s and 10 rad/s (speeds of a brisk hand).
///
/// `guide`, `play` and `stop` are called from one thread, `at` from another; `intended` and `is_playing` from the
/// first.
class GuidedMotion final : public IntendedMotion {
 public:
  explicit GuidedMotion(const Pose& start);
  ~GuidedMotion() override;

  // The one who guides.

  /// The hand means to come to `X_WT`; ends a script.
  void guide(const Pose& X_WT);

  /// Plays a scripted motion from where the hand means to be: its poses are displacements from there, [offset in world
  /// axes (m); rotation about the grip, in world axes]. Allocates.
  void play(Trajectory script);

  /// Ends a script; the hand stays where it means to be.
  void stop();

  /// Where the hand meant to be at the last tick.
  Pose intended();

  /// Whether a script has not come to its end.
  bool is_playing() const noexcept { return given_ > ended_.load(std::memory_order_acquire); }

  // The hand.

  Pose start() const noexcept override { return start_; }
  Pose at(double time) noexcept override;

  /// At `time` (s) the hand is elsewhere and means to stay there (what plays ends).
  void place(double time, const Pose& X_WT) noexcept;

 private:
  struct Order {
    std::uint64_t number = 0;  ///< among orders and scripts
    bool stays = true;         ///< where it means to be, else it goes to X_WT
    PlainPose X_WT;
  };
  struct Script {
    std::uint64_t number;
    Trajectory motion;
  };
  using ScriptEnvelope = Mailbox<Script>::Envelope;

  void take_order() noexcept;
  void take_script() noexcept;
  void end_script() noexcept;
  Pose scripted(double time) const noexcept;
  Pose towards(const Pose& target, double duration) const noexcept;

  Pose start_;

  // Of the one who guides.
  std::uint64_t number_ = 0;  ///< of the last order or script
  std::uint64_t given_ = 0;   ///< of the last script

  // Between the threads.
  LatestValue<Order> orders_;
  Mailbox<Script> scripts_;
  LatestValue<PlainPose> reached_;
  std::atomic<std::uint64_t> ended_{0};  ///< number of the last script that has come to its end

  // The hand's.
  Pose X_WH_;
  Pose target_;
  double time_ = 0.0;        ///< s
  std::uint64_t taken_ = 0;  ///< number of the last order or script that came
  ScriptEnvelope* script_ = nullptr;
  double script_begin_ = 0.0;  ///< s
  Pose X_WH_script_;           ///< where the script began
};

}  // namespace tegotae
