// SPDX-License-Identifier: Apache-2.0
#include <tegotae/runtime/realtime_thread.hpp>

#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>

namespace tegotae {
namespace {

// Error number, 0: granted.
int request_fifo(int priority) noexcept {
  sched_param parameters{};
  parameters.sched_priority =
      std::clamp(priority, sched_get_priority_min(SCHED_FIFO), sched_get_priority_max(SCHED_FIFO));
  return pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameters);
}

// Error number, 0: granted. Under a finite limit memory must not be locked for the future: allocations would fail there
// once the limit is reached, which is worse than paging.
int request_locked_memory() noexcept {
  const rlimit unlimited{RLIM_INFINITY, RLIM_INFINITY};
  rlimit limit{};
  if (getrlimit(RLIMIT_MEMLOCK, &limit) != 0) return errno;
  if (limit.rlim_max == RLIM_INFINITY) {
    setrlimit(RLIMIT_MEMLOCK, &unlimited);
  } else if (setrlimit(RLIMIT_MEMLOCK, &unlimited) != 0) {
    return EPERM;
  }
  return mlockall(MCL_CURRENT | MCL_FUTURE) == 0 ? 0 : errno;
}

// What root is refused, no membership or sudo brings: a container or a service took the right away.
std::string mend_for_root(bool fifo_refused, bool memory_refused) {
  std::string text =
      " Mend: the program runs as root already, so the container or service that it runs in withholds this; grant it";
  if (fifo_refused) text += " the capability CAP_SYS_NICE";
  if (fifo_refused && memory_refused) text += " and";
  if (memory_refused) text += " the capability CAP_IPC_LOCK with no limit on locked memory (RLIMIT_MEMLOCK)";
  return text + ".";
}

std::string explain(int fifo_error, int memory_error) {
  std::string text;
  const auto refused = [&text](const char* what, int error, const char* effect) {
    if (error == 0) return;
    if (!text.empty()) text += ' ';
    text += what;
    text += " was not granted (" + std::generic_category().message(error) + "): " + effect;
  };
  refused("Real-time scheduling (SCHED_FIFO)", fifo_error, "ticks may come late when the machine is busy.");
  refused("Locked memory", memory_error, "a tick may wait for paging.");
  if (text.empty()) return text;
  if (geteuid() == 0) return text + mend_for_root(fifo_error != 0, memory_error != 0);
  return text +
         " Mend: add the lines '@realtime - rtprio 90' and '@realtime - memlock unlimited' to "
         "/etc/security/limits.d/realtime.conf, make yourself a member ('sudo groupadd -f realtime; sudo usermod -aG "
         "realtime $USER') and log in again; or start the program with sudo.";
}

}  // namespace

RealtimeRights request_realtime(int priority) {
  const int fifo_error = request_fifo(priority);
  const int memory_error = request_locked_memory();
  return {fifo_error == 0, memory_error == 0, explain(fifo_error, memory_error)};
}

void release_realtime() noexcept {
  const sched_param ordinary{};
  pthread_setschedparam(pthread_self(), SCHED_OTHER, &ordinary);
  munlockall();
}

}  // namespace tegotae
