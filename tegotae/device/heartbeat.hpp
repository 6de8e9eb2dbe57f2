// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/runtime/haptic_interface.hpp>

#include <atomic>
#include <cstdint>

namespace tegotae {

/// What the haptic thread tells another process of itself, without entering the kernel: that it goes on, and whether a
/// force that was commanded is still displayed. Lies in memory that both have mapped.
struct Heartbeat {
  std::atomic<std::uint64_t> beats{0};  ///< commands that the device took or refused
  std::atomic<bool> displays{false};    ///< a command that was not zero, with no zero taken since
  std::atomic<double> period{0.0};      ///< s between the last two readings, at most `kSlowest`

  static constexpr double kSlowest = 0.1;  ///< s; slower haptics are not permitted
};
static_assert(std::atomic<std::uint64_t>::is_always_lock_free && std::atomic<bool>::is_always_lock_free &&
                  std::atomic<double>::is_always_lock_free,
              "processes cannot share a lock that is hidden in an atomic");

/// Memory for a heartbeat, to be shared with a process that this one starts.
class HeartbeatMemory {
 public:
  /// A new one. Throws InterfaceError.
  HeartbeatMemory();
  /// The one behind a descriptor that was inherited. Throws InterfaceError where it holds none.
  explicit HeartbeatMemory(int descriptor);
  ~HeartbeatMemory();
  HeartbeatMemory(const HeartbeatMemory&) = delete;
  HeartbeatMemory& operator=(const HeartbeatMemory&) = delete;

  Heartbeat& operator*() const noexcept { return *heart_; }
  Heartbeat* operator->() const noexcept { return heart_; }
  int descriptor() const noexcept { return descriptor_; }  ///< closed in programs that this process starts

 private:
  void map();

  int descriptor_ = -1;
  bool owns_descriptor_ = false;
  Heartbeat* heart_ = nullptr;
};

/// An interface whose commands beat. Of the same thread as it; costs a few nanoseconds.
class BeatingInterface final : public HapticInterface {
 public:
  /// Both outlive it.
  BeatingInterface(HapticInterface& interface, Heartbeat& heart) : interface_(interface), heart_(heart) {}

  InterfaceCapability capability() const override { return interface_.capability(); }
  InterfaceStatus read(double time, InterfaceState& state) noexcept override;
  InterfaceStatus write(const InterfaceCommand& command) noexcept override;

 private:
  HapticInterface& interface_;
  Heartbeat& heart_;
  double last_read_ = 0.0;  ///< s
};

/// Tells from looks at a heartbeat when a force is displayed that nobody renews.
class Standstill {
 public:
  /// s without a beat. Ticks that come late are some milliseconds late, on a machine that is busy with other things
  /// some tens; a hand needs 200 ms to let go.
  static constexpr double kLongest = 0.1;
  /// The same in periods, of haptics so slow that this is longer.
  static constexpr double kPeriods = 5.0;

  /// At each look, `time` in s, rising: whether a force has been displayed without a beat for the longer of `kLongest`
  /// and `kPeriods`.
  bool see(double time, const Heartbeat& heart) noexcept;

 private:
  std::uint64_t beats_ = 0;
  double since_ = 0.0;  ///< s
  bool has_seen_ = false;
};

}  // namespace tegotae
