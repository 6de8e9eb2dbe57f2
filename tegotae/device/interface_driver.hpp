// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/runtime/haptic_interface.hpp>

#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace tegotae {

/// An interface that cannot be opened or is not what its driver takes it for. `what()` is one sentence that names the
/// driver and the mend.
struct InterfaceError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// What a driver finds on this machine.
struct InterfacePresence {
  std::string library;                  ///< file of the maker's library that was loaded; empty: none, or none needed
  std::vector<std::string> looked_for;  ///< names of libraries that were tried, in order; empty: none needed
  std::vector<std::string> devices;     ///< a line each, with the options that open it; empty: none seen
  std::string trouble;                  ///< a sentence with its mend; empty: a device can be opened
};

/// When a process beside the one that drives a device may bring it to zero.
enum class RescueTime : std::uint8_t {
  kNever,
  kAfterDeath,  ///< of the process that drove it, as nobody else can open it before
  kAnyTime,     ///< also while that process stands still with the device open
};

/// What brings a device to zero where the process that drives it cannot.
struct InterfaceRescue {
  RescueTime time = RescueTime::kNever;
  std::string after_a_crash;  ///< a sentence
};

/// One kind of interface that the program knows by name. Where a library of its maker is needed, it is loaded when one
/// of the functions is called, only if it is installed.
struct InterfaceDriver {
  std::string_view name;     ///< on the command line, as "force-dimension"
  std::string_view summary;  ///< what it drives, one line
  std::string_view options;  ///< what may follow the name and a colon, for help; empty: nothing
  /// What brings the interface to zero where this process dies in the middle of a call: one sentence.
  std::string_view after_a_crash;

  /// Looks for library and devices, without moving anything and without any force.
  InterfacePresence (*find)();
  /// Opens a device, calibrated, without force. A device that is lost later is opened again by the interface itself,
  /// off the thread that reads. Throws InterfaceError.
  std::unique_ptr<HapticInterface> (*open)(std::string_view options);
  /// Opens the device that another process, now dead, left as it was, commands zero and lets go of it. False where
  /// that could not be done. Null: not needed, `after_a_crash` says why.
  bool (*silence)(std::string_view options) noexcept;

  // What only some drivers have.

  /// What a person should know before a device is opened, a sentence's part.
  std::string_view before_opening = "a device that is not calibrated may move by itself: hands off";
  /// As `find`, where what is looked for depends on the options. Throws InterfaceError for options that are none. Null:
  /// it does not.
  InterfacePresence (*find_with)(std::string_view options) = nullptr;
  /// Where what brings a device to zero depends on the options. Throws InterfaceError. Null: it does not.
  InterfaceRescue (*rescue)(std::string_view options) = nullptr;
};

/// What `driver` finds on this machine of an interface with these options; ones that are none are its trouble, where
/// the driver looks at them.
InterfacePresence find_interface(const InterfaceDriver& driver, std::string_view options);

/// What brings the interface with these options to zero. Throws InterfaceError.
InterfaceRescue rescue_of(const InterfaceDriver& driver, std::string_view options);

}  // namespace tegotae
