// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace tegotae {

/// Priority of the haptic thread under SCHED_FIFO, 1 to 99: above the kernel's own threaded interrupts (50), so that
/// disk and network do not delay a tick, below its watchdogs (99). Force-feedback programs use about 80.
inline constexpr int kHapticPriority = 80;
/// Priority of the physics thread: after haptics, before everything that is not real-time.
inline constexpr int kPhysicsPriority = 40;

/// What the system granted to a thread that asked to be real-time.
struct RealtimeRights {
  bool fifo = false;           ///< the thread runs under SCHED_FIFO
  bool memory_locked = false;  ///< memory of the process, present and to come, stays in RAM
  std::string explanation;     ///< for the user: empty if all is granted, else what is not, why, and the mend
};

/// Asks for SCHED_FIFO at `priority` (clamped to what the system has) for the calling thread, and for locked memory for
/// the process. Whatever is refused, the program can go on: with late ticks where the machine is busy. Does not throw
/// but for lack of memory; may take long (locking reads all memory in), so call it before the loop begins.
RealtimeRights request_realtime(int priority);

/// Gives both back: the calling thread to the ordinary scheduler, memory to paging.
void release_realtime() noexcept;

}  // namespace tegotae
