// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/device/guard_process.hpp>

#include <atomic>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace tegotae {

/// A guard process that is there for as long as this is: one that dies or is stopped is noticed within 20 ms, on a
/// thread of its own, and another is started. Where that cannot be done, or guards end at once again and again, nobody
/// would bring the interface to zero after a crash: then this says so, once, and whoever drives the interface must end
/// its force.
class KeptGuard {
 public:
  /// Starts the first. `on_failure` is called on this object's thread, at most once. Throws InterfaceError where the
  /// first cannot be started, std::system_error where its thread cannot.
  KeptGuard(GuardProgram program, std::function<void()> on_failure);
  /// Says farewell to the guard.
  ~KeptGuard();
  KeptGuard(const KeptGuard&) = delete;
  KeptGuard& operator=(const KeptGuard&) = delete;

  /// What a person should hear since this was asked last, a sentence each. Any thread.
  std::vector<std::string> take_news();
  /// Any thread: no guard can be kept.
  bool has_failed() const noexcept { return has_failed_.load(std::memory_order_acquire); }
  /// Of the guard that is there now. Any thread.
  pid_t pid();

 private:
  void watch();
  bool keep();

  GuardProgram program_;
  std::function<void()> on_failure_;
  std::mutex mutex_;
  std::condition_variable wake_;
  bool is_ending_ = false;  // under mutex_, as are the next two
  std::vector<std::string> news_;
  std::unique_ptr<GuardProcess> guard_;
  int short_lives_ = 0;   ///< of guards, on end; the thread's, as is the next
  double started_ = 0.0;  ///< s
  std::atomic<bool> has_failed_{false};
  std::thread thread_;
};

}  // namespace tegotae
