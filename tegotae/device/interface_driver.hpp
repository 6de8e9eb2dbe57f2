// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/runtime/haptic_interface.hpp>

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
};

}  // namespace tegotae
