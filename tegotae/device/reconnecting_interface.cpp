// SPDX-License-Identifier: Apache-2.0
#include <tegotae/device/reconnecting_interface.hpp>

#include <tegotae/device/interface_driver.hpp>

#include <utility>

namespace tegotae {
namespace {

DeviceOpener same_device(DeviceOpener reopen, const InterfaceCapability& expected) {
  return [reopen = std::move(reopen), expected]() -> std::unique_ptr<OpenDevice> {
    std::unique_ptr<OpenDevice> device = reopen();
    if (device == nullptr) return nullptr;
    const InterfaceCapability found = device->capability();
    const bool same =
        found.name == expected.name && found.max_force == expected.max_force && found.max_torque == expected.max_torque;
    if (!same) throw InterfaceError("another device, " + found.name + ", came in the place of " + expected.name + ".");
    return device;
  };
}

}  // namespace

ReconnectingInterface::ReconnectingInterface(std::unique_ptr<OpenDevice> first, DeviceOpener reopen,
                                             const Connection::Pace& pace)
    : capability_(first->capability()),
      connection_(std::move(first), same_device(std::move(reopen), capability_), pace) {}

InterfaceStatus ReconnectingInterface::read(double time, InterfaceState& state) noexcept {
  refusals_ = refused_ ? refusals_ + 1 : 0;
  refused_ = false;
  if (refusals_ >= kPatience) {
    refusals_ = 0;
    connection_.give_up();
  }
  OpenDevice* device = connection_.device();
  return device == nullptr ? InterfaceStatus::kLost : answered(device->read(time, state));
}

InterfaceStatus ReconnectingInterface::write(const InterfaceCommand& command) noexcept {
  OpenDevice* device = connection_.device();
  return device == nullptr ? InterfaceStatus::kLost : answered(device->write(command));
}

std::string ReconnectingInterface::remarks() {
  std::string text;
  if (reconnections() > 0) {
    text = capability_.name + " was lost and opened again, times: " + std::to_string(reconnections()) + ".";
  }
  OpenDevice* device = connection_.device();
  const std::string of_device = device == nullptr ? capability_.name + " is lost." : device->remarks();
  if (text.empty() || of_device.empty()) return text + of_device;
  return text + " " + of_device;
}

InterfaceStatus ReconnectingInterface::answered(DeviceAnswer answer) noexcept {
  refused_ = refused_ || answer == DeviceAnswer::kFailed;
  return answer == DeviceAnswer::kOk ? InterfaceStatus::kOk : InterfaceStatus::kLost;
}

}  // namespace tegotae
