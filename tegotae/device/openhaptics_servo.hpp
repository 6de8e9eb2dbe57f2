// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/device/axis_map.hpp>
#include <tegotae/device/openhaptics_library.hpp>
#include <tegotae/device/pose_history.hpp>
#include <tegotae/math/plain.hpp>
#include <tegotae/runtime/latest_value.hpp>

#include <array>
#include <atomic>
#include <cstdint>

namespace tegotae {

/// What went wrong on a device without ending its use, counted since it was opened.
struct OpenHapticsCounts {
  std::uint64_t frames = 0;  ///< callbacks that had their readings and sent their command
  std::uint64_t warm_motors = 0, exceeded_force = 0, exceeded_impulse = 0, exceeded_velocity = 0, force_errors = 0;
  std::uint64_t failed_frames = 0;  ///< with any other error
  std::uint64_t withheld = 0;       ///< times that a command was taken back, as no other came after it
  unsigned last_failure = 0;        ///< code of the newest of those other errors
};

/// What a callback read.
struct OpenHapticsReading {
  std::int64_t time = 0;  ///< ns of the monotonic clock, when it was read; 0: nothing was yet
  PlainPose X_WT;
  PlainTwist V_WT;
  std::uint32_t buttons = 0;
  bool is_plausible = false;  ///< the transform is a rigid motion, where the layout and the unit are those known
};

/// What a callback tells the haptic thread: the newest reading that did not fail, and how it goes.
struct OpenHapticsSample : OpenHapticsReading {
  bool is_withheld = false;  ///< a command was taken back, or its frame failed; see OpenHapticsServo
  bool has_failed = false;   ///< the device is given up: there are no more callbacks
  OpenHapticsCounts counts;
};

/// What runs in the servo loop of the maker's scheduler, on the maker's thread, once a period of its own (mostly 1 ms):
/// reads the device, commands it, and exchanges both with the haptic thread, newest against newest, wait-free. So the
/// haptic thread stays the clock of the program; a pose is up to one servo period old when it is read, and a command
/// waits up to another.
///
/// The servo's own watchdog, for a haptic thread that stands still: a command that is not zero and that no other has
/// followed for kPatience callbacks is withheld. From then on zero is displayed until a zero comes from the haptic
/// thread, which is told (so that it begins from zero as after a lost interface), and never the old command again.
///
/// The linear velocity is the maker's; the angular one is the difference quotient of the pose over 20 ms, as the
/// maker's is said not to be usable on all devices and its axes are not documented. Errors: warm motors, exceeded
/// force, impulse, velocity and force error are counted; with any other, the frame is not believed, it and the next
/// command zero (a command that is not zero is withheld from then on, as above), and kMostFailedFrames on end give the
/// device up.
class OpenHapticsServo {
 public:
  static constexpr int kPatience = 20;             ///< callbacks, 20 ms at 1 kHz
  static constexpr int kMostFailedFrames = 3;      ///< on end
  static constexpr double kVelocityWindow = 0.02;  ///< s

  /// `turns`: the device displays torque, if the library lets it.
  OpenHapticsServo(const OpenHapticsLibrary& library, hd::Handle device, const AxisMap& axes, bool turns) noexcept
      : library_(library), device_(device), axes_(axes), turns_(turns) {}

  /// For the maker's scheduler; `servo` is an OpenHapticsServo.
  static unsigned callback(void* servo) noexcept { return static_cast<OpenHapticsServo*>(servo)->frame(); }

  // For one other thread at a time.

  LatestValue<OpenHapticsSample>& samples() noexcept { return samples_; }
  /// World axes, N and N m.
  LatestValue<PlainWrench>& commands() noexcept { return commands_; }
  /// The next callback commands zero and is the last.
  void end() noexcept { ending_.store(true, std::memory_order_release); }
  bool has_ended() const noexcept { return ended_.load(std::memory_order_acquire); }
  /// Whether torque is displayed: settled by the first frame, as not every version of the library takes a Cartesian
  /// one.
  bool turns() const noexcept { return turns_.load(std::memory_order_acquire); }

 private:
  unsigned frame() noexcept;
  OpenHapticsReading read() noexcept;
  Wrench command() noexcept;
  void send(const Wrench& wrench_W) noexcept;
  void send_torque(const Vector3& torque) noexcept;
  void take_errors() noexcept;
  void account(unsigned code) noexcept;

  OpenHapticsLibrary library_;
  hd::Handle device_;
  AxisMap axes_;
  std::atomic<bool> turns_;
  LatestValue<OpenHapticsSample> samples_;
  LatestValue<PlainWrench> commands_;
  std::atomic<bool> ending_{false}, ended_{false};

  // The callback's.
  OpenHapticsSample sample_;
  PoseHistory history_;
  int silent_callbacks_ = 0, failed_frames_ = 0;
  bool frame_failed_ = false, torque_is_asked_for_ = false;
};

/// The pose of the grip in a transform of the HD API, m, device axes; false where it is no rigid motion in the known
/// layout and within 2 m.
bool rigid_motion_of(const std::array<double, 16>& transform, Vector3& p_DG, Matrix3& R_DG) noexcept;

}  // namespace tegotae
