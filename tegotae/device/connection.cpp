// SPDX-License-Identifier: Apache-2.0
#include <tegotae/device/connection.hpp>

#include <exception>
#include <utility>

namespace tegotae {

Connection::Connection(std::unique_ptr<OpenDevice> first, DeviceOpener reopen, const Pace& pace)
    : reopen_(std::move(reopen)), pace_(pace) {
  devices_.give(std::move(first));
  thread_ = std::thread([this] { watch(); });
}

Connection::~Connection() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    ending_ = true;
  }
  wake_.notify_all();
  thread_.join();
  if (current_ != nullptr) devices_.give_back(current_);
}

OpenDevice* Connection::device() noexcept {
  if (current_ == nullptr) current_ = devices_.take();
  return current_ == nullptr ? nullptr : current_->content.get();
}

// The flag comes after the device, so that who sees it can close the device before he opens it anew.
void Connection::give_up() noexcept {
  if (current_ == nullptr) return;
  devices_.give_back(std::exchange(current_, nullptr));
  given_up_.store(true, std::memory_order_release);
}

void Connection::watch() {
  bool is_lost = false;
  for (;;) {
    {
      std::unique_lock<std::mutex> lock(mutex_);
      if (wake_.wait_for(lock, is_lost ? pace_.retry : pace_.look, [this] { return ending_; })) return;
    }
    if (given_up_.exchange(false, std::memory_order_acquire)) is_lost = true;
    if (is_lost) is_lost = !reopened();
  }
}

bool Connection::reopened() {
  devices_.free_returned();
  try {
    std::unique_ptr<OpenDevice> device = reopen_();
    if (device == nullptr) return false;
    reconnections_.fetch_add(1, std::memory_order_relaxed);
    devices_.give(std::move(device));
    return true;
  } catch (const std::exception&) {
    return false;
  }
}

}  // namespace tegotae
