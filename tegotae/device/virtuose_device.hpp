// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/device/axis_map.hpp>
#include <tegotae/device/open_device.hpp>
#include <tegotae/device/pose_age.hpp>
#include <tegotae/device/virtuose_library.hpp>

#include <array>
#include <string>
#include <string_view>

namespace tegotae {

/// What `--interface virtuose:...` says.
struct VirtuoseOptions {
  std::string address;                        ///< of the controller: HOST, or HOST#PORT
  AxisMap axes;                               ///< from the controller's base frame
  double period = 1e-3;                       ///< s, time step that the controller is told, 1 to 10 ms
  double max_force = 15.0, max_torque = 1.0;  ///< N, N m, that the controller is told to clip to

  /// Throws InterfaceError.
  static VirtuoseOptions parse(std::string_view text);
};

/// A Virtuose of Haption under impedance control: pose in, wrench out. Position, speed and force stand in one frame,
/// the observation frame, put on the base frame; the device's own offset button ("indexing") holds the pose still and
/// the force at zero while it is pressed. While the device has no power (its switch, its dead-man's sensor) it answers
/// kNotReady; with the emergency-stop chain open kFailed, so that it is opened anew when the chain closes.
class VirtuoseDevice final : public OpenDevice {
 public:
  static constexpr int kMostButtons = 8;

  /// Opens and switches power on. Throws InterfaceError.
  VirtuoseDevice(const VirtuoseLibrary& library, const VirtuoseOptions& options);
  ~VirtuoseDevice() override;

  /// The limits are those of the options: what programs clamp to, as models differ.
  InterfaceCapability capability() const override;
  DeviceAnswer read(double time, InterfaceState& state) noexcept override;
  DeviceAnswer write(const InterfaceCommand& command) noexcept override;

  /// Commands zero to a device that somebody else left, switches its power off and lets go of it. False where the
  /// device cannot be opened or zero did not reach it.
  static bool silence(const VirtuoseLibrary& library, const VirtuoseOptions& options) noexcept;

 private:
  void prepare() const;
  void find_buttons() noexcept;
  std::uint32_t buttons() const noexcept;

  VirtuoseLibrary library_;
  VirtuoseOptions options_;
  void* context_;
  std::array<int, kMostButtons> numbers_{};  ///< of the buttons that there are
  int button_count_ = 0;
  PoseAge age_;
};

}  // namespace tegotae
