// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/lab/doctor.hpp>

#include <filesystem>

namespace tegotae {

/// Where the system tells of itself. Another machine's files may lie elsewhere.
struct SystemRoots {
  std::filesystem::path proc = "/proc", sys = "/sys", dev = "/dev";
};

/// Version of the kernel, and when it lets a thread in the kernel be interrupted: real-time, full, voluntary, not at
/// all. Never "not possible": the wake-ups are measured.
Finding kernel_finding(const SystemRoots& roots);

/// Whether a thread got SCHED_FIFO (`granted`), and what the process is permitted: its limit of real-time priority
/// and its capability CAP_SYS_NICE.
Finding scheduling_finding(const SystemRoots& roots, bool granted);

/// Whether memory could be locked, and what the process is permitted.
Finding memory_finding(const SystemRoots& roots, bool granted);

/// Whether the processors keep their clock rate: the governor of each.
Finding governor_finding(const SystemRoots& roots);

}  // namespace tegotae
