// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/device/open_device.hpp>
#include <tegotae/runtime/mailbox.hpp>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <thread>

namespace tegotae {

/// Keeps a device open for the thread that reads it. A device that this thread gives up is closed, and opened again
/// when it is back, on a slow thread of the connection's own; the new one is handed over wait-free. So a maker's
/// functions for one device are never called by two threads at a time.
class Connection {
 public:
  struct Pace {
    std::chrono::milliseconds look{20};     ///< between looks whether the device was given up
    std::chrono::milliseconds retry{1000};  ///< between attempts to open it again
  };

  /// Starts with the open device `first`, not null. `reopen` is called on the slow thread; what it throws counts as a
  /// device that is not there yet. Throws std::system_error where the thread cannot be started.
  Connection(std::unique_ptr<OpenDevice> first, DeviceOpener reopen, const Pace& pace);
  Connection(std::unique_ptr<OpenDevice> first, DeviceOpener reopen)
      : Connection(std::move(first), std::move(reopen), Pace{}) {}
  /// Closes the device. No thread may be in `device` or `give_up`.
  ~Connection();
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  /// The reading thread's: the open device, or null while there is none. Wait-free.
  OpenDevice* device() noexcept;
  /// The reading thread's: `device` is lost, its pointer ends here. Wait-free.
  void give_up() noexcept;

  /// Any thread's: how often it was opened again.
  std::uint64_t reconnections() const noexcept { return reconnections_.load(std::memory_order_relaxed); }

 private:
  using Devices = Mailbox<std::unique_ptr<OpenDevice>>;

  void watch();
  bool reopened();

  DeviceOpener reopen_;
  Pace pace_;
  Devices devices_;
  Devices::Envelope* current_ = nullptr;  // the reading thread's
  std::atomic<bool> given_up_{false};
  std::atomic<std::uint64_t> reconnections_{0};
  std::mutex mutex_;
  std::condition_variable wake_;
  bool ending_ = false;  // under mutex_
  std::thread thread_;
};

}  // namespace tegotae
