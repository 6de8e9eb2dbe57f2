// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/device/connection.hpp>
#include <tegotae/device/interface_remarks.hpp>
#include <tegotae/device/open_device.hpp>
#include <tegotae/runtime/haptic_interface.hpp>

#include <cstdint>
#include <string>

namespace tegotae {

/// A device that may be unplugged and come back, as an interface. A call that the maker's library refuses is kLost for
/// this tick. After `kPatience` ticks with refusals on end the device is given up: closed and opened again on another
/// thread, once a second, kLost meanwhile.
class ReconnectingInterface final : public HapticInterface, public InterfaceRemarks {
 public:
  /// Ticks. Libraries refuse a single call now and then (a packet was lost); a device that is gone refuses all.
  static constexpr int kPatience = 10;

  /// `first` is open; `reopen` opens the same device again, and must not move it. A device with another name or other
  /// limits is not taken: whoever runs has set himself up for the first.
  ReconnectingInterface(std::unique_ptr<OpenDevice> first, DeviceOpener reopen,
                        const Connection::Pace& pace = Connection::Pace{});

  InterfaceCapability capability() const override { return capability_; }
  InterfaceStatus read(double time, InterfaceState& state) noexcept override;
  InterfaceStatus write(const InterfaceCommand& command) noexcept override;

  /// How often it was lost, and what the device that is open now has to say.
  std::string remarks() override;

  std::uint64_t reconnections() const noexcept { return connection_.reconnections(); }

 private:
  InterfaceStatus answered(DeviceAnswer answer) noexcept;

  InterfaceCapability capability_;
  Connection connection_;
  bool refused_ = false;  ///< a call since the last reading
  int refusals_ = 0;      ///< ticks on end
};

}  // namespace tegotae
