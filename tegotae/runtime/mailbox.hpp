// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <memory>
#include <utility>

namespace tegotae {

/// Hands objects to a thread that may neither allocate nor free, and takes back what it has done with. One giver
/// thread, one receiver thread. Each object comes in an envelope that travels there and back; of several given before
/// one is taken the last counts.
template <class T>
class Mailbox {
 public:
  /// What travels.
  struct Envelope {
    explicit Envelope(T&& what) : content(std::move(what)) {}
    T content;

   private:
    friend class Mailbox;
    Envelope* next_ = nullptr;
  };

  Mailbox() = default;
  Mailbox(const Mailbox&) = delete;
  Mailbox& operator=(const Mailbox&) = delete;
  /// Neither thread may use it any more.
  ~Mailbox() {
    delete given_.load(std::memory_order_acquire);
    free_returned();
  }

  /// Giver: frees what came back, and gives `what`. Allocates.
  void give(T what) {
    free_returned();
    auto envelope = std::make_unique<Envelope>(std::move(what));
    delete given_.exchange(envelope.release(), std::memory_order_acq_rel);
  }

  /// Giver: frees what came back.
  void free_returned() noexcept {
    Envelope* envelope = returned_.exchange(nullptr, std::memory_order_acquire);
    while (envelope != nullptr) delete std::exchange(envelope, envelope->next_);
  }

  /// Receiver: the newest object given, or null. It is the receiver's until `give_back`. Wait-free.
  Envelope* take() noexcept {
    if (given_.load(std::memory_order_relaxed) == nullptr) return nullptr;
    return given_.exchange(nullptr, std::memory_order_acquire);
  }

  /// Receiver: the giver may free the envelope, which may not be null. Retries at most once for each `free_returned`
  /// that comes between.
  void give_back(Envelope* envelope) noexcept {
    envelope->next_ = returned_.load(std::memory_order_relaxed);
    while (!returned_.compare_exchange_weak(envelope->next_, envelope, std::memory_order_release,
                                            std::memory_order_relaxed)) {
    }
  }

 private:
  std::atomic<Envelope*> given_{nullptr};
  std::atomic<Envelope*> returned_{nullptr};  ///< a list, only ever taken whole
};

}  // namespace tegotae
