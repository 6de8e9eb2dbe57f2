// SPDX-License-Identifier: Apache-2.0
#include <tegotae/device/kept_guard.hpp>

#include <chrono>
#include <utility>

namespace tegotae {
namespace {

constexpr std::chrono::milliseconds kLookAtGuard{20};
constexpr double kShortLife = 1.0;  // s
constexpr int kMostShortLives = 3;  // on end: what ends the guards is not over

double seconds_now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

KeptGuard::KeptGuard(GuardProgram program, std::function<void()> on_failure)
    : program_(std::move(program)),
      on_failure_(std::move(on_failure)),
      guard_(std::make_unique<GuardProcess>(program_)),
      started_(seconds_now()) {
  thread_ = std::thread([this] { watch(); });
}

KeptGuard::~KeptGuard() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    is_ending_ = true;
  }
  wake_.notify_all();
  thread_.join();
}

std::vector<std::string> KeptGuard::take_news() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return std::exchange(news_, {});
}

pid_t KeptGuard::pid() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return guard_->pid();
}

void KeptGuard::watch() {
  std::unique_lock<std::mutex> lock(mutex_);
  while (!wake_.wait_for(lock, kLookAtGuard, [this] { return is_ending_; })) {
    if (!guard_->has_ended() || keep()) continue;
    has_failed_.store(true, std::memory_order_release);
    lock.unlock();
    on_failure_();
    return;
  }
}

// The guard is gone: starts another. False where none can be kept.
bool KeptGuard::keep() {
  const double now = seconds_now();
  short_lives_ = now - started_ < kShortLife ? short_lives_ + 1 : 0;
  std::string why = "it ends as soon as it is started";
  if (short_lives_ < kMostShortLives) {
    try {
      guard_ = std::make_unique<GuardProcess>(program_);
      started_ = now;
      news_.emplace_back("the process that guards the interface was ended by somebody; another was started.");
      return true;
    } catch (const InterfaceError& error) {
      why = error.what();
    }
  }
  news_.push_back("the process that guards the interface is gone, and no other can be kept (" + why +
                  "): the interface is brought to zero, as nobody would do so after a crash.");
  return false;
}

}  // namespace tegotae
