// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace tegotae {

/// Beside the port of an interface: what a person should know of how it went.
class InterfaceRemarks {
 public:
  InterfaceRemarks() = default;
  InterfaceRemarks(const InterfaceRemarks&) = delete;
  InterfaceRemarks& operator=(const InterfaceRemarks&) = delete;
  virtual ~InterfaceRemarks() = default;

  /// What went wrong without ending the use of the device since it was opened, a sentence; empty: nothing. Not while
  /// another thread reads or writes. Allocates.
  virtual std::string remarks() = 0;
};

}  // namespace tegotae
