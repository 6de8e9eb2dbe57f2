// SPDX-License-Identifier: Apache-2.0
#include <apps/interruption.hpp>

#include <csignal>
#include <initializer_list>

namespace tegotae {
namespace {

std::atomic<bool> was_interrupted{false};
std::atomic<int> first_signal{0};
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<int>::is_always_lock_free);

extern "C" void remember_signal(int signal) {
  int none = 0;
  first_signal.compare_exchange_strong(none, signal);
  was_interrupted.store(true);
}

}  // namespace

const std::atomic<bool>& interrupted() noexcept { return was_interrupted; }

void interrupt() noexcept { was_interrupted.store(true); }

void listen_for_interruption() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction present {};
    if (sigaction(signal, nullptr, &present) == 0 && present.sa_handler == SIG_IGN) continue;
    struct sigaction wanted {};
    wanted.sa_handler = remember_signal;
    wanted.sa_flags = SA_RESTART;
    sigemptyset(&wanted.sa_mask);
    sigaction(signal, &wanted, nullptr);
  }
}

Interruption::Interruption(const std::string& what) : std::runtime_error(what), exit_code_(128 + first_signal.load()) {}

}  // namespace tegotae
