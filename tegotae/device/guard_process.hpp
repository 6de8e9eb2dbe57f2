// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/device/interface_driver.hpp>

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

namespace tegotae {

/// A small process beside this one that brings an interface to zero if this one dies in the middle of a call (SIGSEGV,
/// SIGKILL, out of memory): then no call to the maker's library is safe here, but the other process can open the
/// device anew, command zero and let go of it.
///
/// It holds one end of a socket and sleeps. A word of farewell ends it; an end without one means that this process is
/// gone. It does not watch for a process that stands still but lives: what the device does then is its driver's
/// `after_a_crash`, as it cannot be opened twice.
class GuardProcess {
 public:
  /// Starts `program` with `arguments`; the socket is its standard input. `program` must end in `guard_interface`.
  /// Throws InterfaceError where it cannot be started. Allocates.
  GuardProcess(const std::filesystem::path& program, const std::vector<std::string>& arguments);
  /// Says farewell and waits for its end.
  ~GuardProcess();
  GuardProcess(const GuardProcess&) = delete;
  GuardProcess& operator=(const GuardProcess&) = delete;

  pid_t pid() const noexcept { return pid_; }

 private:
  int socket_ = -1;
  pid_t pid_ = -1;
};

/// How a guard ended.
enum class GuardEnd {
  kFarewell,  ///< the guarded process ended as it should
  kSilenced,  ///< it died, and the interface is at zero
  kFailed,    ///< it died, and the interface could not be opened for `patience`
};

/// What the guard does: waits on `socket` until the guarded process takes leave or dies; in the second case silences
/// the interface, again and again for `patience` (s), as a device may be held for a moment after the death. Keyboard
/// signals and hang-ups are for the guarded process and are ignored here.
GuardEnd guard_interface(const InterfaceDriver& driver, const std::string& options, int socket, double patience);

}  // namespace tegotae
