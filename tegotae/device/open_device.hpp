// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/runtime/haptic_interface.hpp>

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

namespace tegotae {

/// How an open device answered a call.
enum class DeviceAnswer : std::uint8_t {
  kOk,
  kNotReady,  ///< it answers, but displays nothing now: a switch on the device is off
  kFailed,    ///< the maker's library refused: the device may be gone
};

/// Port to a device that a driver has opened and calibrated, with its forces enabled at zero. Used by one thread at a
/// time. The destructor commands zero, disables forces and closes it, whatever state it is in.
class OpenDevice {
 public:
  OpenDevice() = default;
  OpenDevice(const OpenDevice&) = delete;
  OpenDevice& operator=(const OpenDevice&) = delete;
  virtual ~OpenDevice() = default;

  virtual InterfaceCapability capability() const = 0;
  /// As in HapticInterface; neither allocates, nor locks but for what the maker's function does. A command that is not
  /// finite is displayed as zero.
  virtual DeviceAnswer read(double time, InterfaceState& state) noexcept = 0;
  virtual DeviceAnswer write(const InterfaceCommand& command) noexcept = 0;
  /// As in InterfaceRemarks.
  virtual std::string remarks() { return {}; }
};

/// Opens a device. Throws InterfaceError where that cannot be done. May take seconds.
using DeviceOpener = std::function<std::unique_ptr<OpenDevice>()>;

}  // namespace tegotae
