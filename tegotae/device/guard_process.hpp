// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/device/heartbeat.hpp>
#include <tegotae/device/interface_driver.hpp>

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

namespace tegotae {

/// A program that guards, and what it is given.
struct GuardProgram {
  std::filesystem::path file;
  std::vector<std::string> arguments;
  int heartbeat = -1;  ///< descriptor of a HeartbeatMemory, its descriptor kGuardHeartbeat; negative: none
};

/// Descriptor at which a guard finds the memory of the heartbeat.
inline constexpr int kGuardHeartbeat = 3;

/// A small process beside this one that brings an interface to zero if this one dies in the middle of a call (SIGSEGV,
/// SIGKILL, out of memory): then no call to the maker's library is safe here, but the other process can open the
/// device anew, command zero and let go of it. It also watches for this process standing still (guard_interface).
///
/// It holds one end of a socket. A word of farewell ends it; an end without one means that this process is gone. Of
/// this process' files it holds no other, whenever it is started, so none that a maker's library keeps for itself.
class GuardProcess {
 public:
  /// Starts the program; the socket is its standard input. It must end in `guard_interface`. Throws InterfaceError
  /// where it cannot be started. Allocates.
  explicit GuardProcess(const GuardProgram& program);
  /// Says farewell and waits for its end, for at most 2 s: then it is killed.
  ~GuardProcess();
  GuardProcess(const GuardProcess&) = delete;
  GuardProcess& operator=(const GuardProcess&) = delete;

  /// Whether it is gone, or stands still (somebody stopped it: then it is ended), and so guards nothing any more.
  bool has_ended() noexcept;

  pid_t pid() const noexcept { return pid_; }

 private:
  bool wait(int options) noexcept;

  int socket_ = -1;
  pid_t pid_ = -1;
  bool has_ended_ = false;
};

/// How a guard ended.
enum class GuardEnd {
  kFarewell,  ///< the guarded process ended as it should
  kSilenced,  ///< it died, and the interface is at zero
  kFailed,    ///< it died, and the interface could not be opened for `patience`
};

/// Who is guarded.
struct GuardedProcess {
  int socket = -1;                   ///< to it
  pid_t process = 0;                 ///< 0: not known
  const Heartbeat* heart = nullptr;  ///< its haptic thread's; null: it is not watched
  RescueTime rescue = RescueTime::kAfterDeath;
  double patience = 10.0;  ///< s for which a device may be held after the death
};

/// What the guard does: waits until the guarded process takes leave or dies (its end of the socket is closed, or
/// `process` is dead); in the second case silences the interface, again and again for `patience`, as a device may be
/// held for a moment after the death. Keyboard signals and hang-ups are for the guarded process and are ignored here.
///
/// Where the heart stands still while a force is displayed (Standstill), it silences the interface at once, and every
/// 0.1 s while that lasts, if a second process may (RescueTime::kAnyTime), and continues a process that was stopped
/// (SIGSTOP, or Ctrl-Z): its own safety stage then knows that it stood, and fades. A process that is stuck in a
/// call to a device which nobody else can open is beyond help: it is told of, once.
GuardEnd guard_interface(const InterfaceDriver& driver, const std::string& options, const GuardedProcess& guarded);

}  // namespace tegotae
