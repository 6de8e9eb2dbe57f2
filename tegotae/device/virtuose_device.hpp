// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/device/axis_map.hpp>
#include <tegotae/device/open_device.hpp>
#include <tegotae/device/pose_age.hpp>
#include <tegotae/device/virtuose_library.hpp>

#include <atomic>
#include <cstdint>
#include <memory>
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

/// Whether power waits for a person: one for all openings of a device, so that no opening forgets it.
using EmergencyStopMemory = std::shared_ptr<std::atomic<bool>>;

/// A Virtuose of Haption under impedance control: pose in, wrench out. Position, speed and force stand in one frame,
/// the observation frame, put on the base frame. The device's own offset ("indexing") is switched off. kNotReady while
/// the device has no power (its switch, its dead-man's sensor) or says that its offset button is pressed.
///
/// With the emergency-stop chain open power is switched off, and stays off when the chain closes: kNotReady until a
/// person switches it on at the device, or presses a button of the grip after the chain closed (which switches it on),
/// also where the device was lost and opened again meanwhile.
class VirtuoseDevice final : public OpenDevice {
 public:
  static constexpr int kMostButtons = 8;
  static constexpr int kReleased = 50;  ///< readings without a button, before one that is pressed is a person's

  /// Opens; switches power on where `stopped` does not forbid it. Throws InterfaceError.
  VirtuoseDevice(const VirtuoseLibrary& library, const VirtuoseOptions& options, EmergencyStopMemory stopped);
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
  bool is_shifting() const noexcept;
  void stop() noexcept;
  bool waits_for_a_person(bool has_power, std::uint32_t buttons) noexcept;

  VirtuoseLibrary library_;
  VirtuoseOptions options_;
  EmergencyStopMemory stopped_;
  void* context_;
  std::uint32_t existing_buttons_ = 0;  ///< a bit each that answers
  PoseAge age_;

  // Since the chain was open, or since the device was opened.
  bool had_no_power_ = false;
  int released_readings_ = 0;  ///< on end without a button, up to kReleased
};

}  // namespace tegotae
