// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/device/open_device.hpp>
#include <tegotae/device/openhaptics_servo.hpp>

#include <memory>
#include <string>
#include <string_view>

namespace tegotae {

/// What `--interface openhaptics:...` says.
struct OpenHapticsOptions {
  std::string name;     ///< of the device in the maker's configuration; empty: the default device
  AxisMap axes{"zxy"};  ///< from the HD API's (x to the right, y up, z towards the person)

  /// Throws InterfaceError.
  static OpenHapticsOptions parse(std::string_view text);
};

/// An open device of 3D Systems, its servo loop running. One at a time in a process, as the scheduler is one.
///
/// What is not certain about the library is checked when it is opened, and refused with a sentence: the transform's
/// layout and unit, the degrees of freedom, the greatest force. A rated stiffness or torque that is out of all reason
/// is not believed; the weakest device's stands in. Where the library refuses Cartesian torque, none is displayed.
class OpenHapticsDevice final : public OpenDevice {
 public:
  enum class Calibrate { kYes, kNo };

  /// Opens, starts the servo loop at zero, waits for its first frames, calibrates. Throws InterfaceError.
  OpenHapticsDevice(const OpenHapticsLibrary& library, const OpenHapticsOptions& options, Calibrate calibrate);
  ~OpenHapticsDevice() override;

  /// The rate is that of the servo loop, measured; the delay one of its periods.
  InterfaceCapability capability() const override { return capability_; }
  /// kNotReady where the transform is not plausible or a command was withheld; kFailed where the device was given up or
  /// no callback came for 0.1 s. The state's time is that of the callback that read it.
  DeviceAnswer read(double time, InterfaceState& state) noexcept override;
  DeviceAnswer write(const InterfaceCommand& command) noexcept override;

  /// The counts that are not zero.
  std::string remarks() override;

  /// As of the last reading.
  const OpenHapticsCounts& counts() noexcept { return servo_->samples().get().counts; }

  /// Model of the device that `options` names, without starting its servo loop. Throws InterfaceError.
  static std::string model(const OpenHapticsLibrary& library, const OpenHapticsOptions& options);
  /// Commands zero for some frames to a device that somebody else left, and lets go of it. False where that failed.
  static bool silence(const OpenHapticsLibrary& library, const OpenHapticsOptions& options) noexcept;

 private:
  struct Claim;     // on the one scheduler
  struct Handle;    // an initialised device
  struct Schedule;  // a callback in a running scheduler

  void await_frames(std::uint64_t count);
  void calibrate() const;

  OpenHapticsLibrary library_;
  OpenHapticsOptions options_;
  InterfaceCapability capability_;
  std::unique_ptr<Claim> claim_;
  std::unique_ptr<Handle> handle_;
  std::unique_ptr<OpenHapticsServo> servo_;
  std::unique_ptr<Schedule> schedule_;
};

}  // namespace tegotae
