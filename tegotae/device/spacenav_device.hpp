// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/device/open_device.hpp>
#include <tegotae/device/spacenav_motion.hpp>
#include <tegotae/device/vendor_library.hpp>
#include <tegotae/runtime/latest_value.hpp>

#include <atomic>
#include <cstdint>
#include <memory>
#include <string_view>
#include <thread>

namespace tegotae {

/// Functions of libspnav, through which the daemon spacenavd tells what 3-D mice do (Debian's 1.0; earlier ones have
/// the same).
struct SpacenavLibrary {
  /// A motion (type 1) or a button (type 2).
  union Event {
    struct Motion {
      int type;
      int x, y, z, rx, ry, rz;
      unsigned period;
      int* data;
    } motion;
    struct Button {
      int type, press, number;
    } button;
    int type;
  };
  static constexpr int kMotion = 1, kButton = 2;

  static VendorLibrary find();
  /// Throws InterfaceError where `library` is not loaded or lacks a function.
  explicit SpacenavLibrary(const VendorLibrary& library);

  int (*open)();  ///< -1: the daemon does not answer
  int (*close)();
  int (*file)();              ///< descriptor that becomes readable with an event
  int (*poll_event)(Event*);  ///< 0: there is none
};

/// What `--interface spacenav:...` says. Throws InterfaceError.
SpacenavSettings parse_spacenav_settings(std::string_view text);

/// The 3-D mice that spacenavd knows, as one interface that only reads: six degrees of freedom in and none out.
///
/// A thread of its own waits for events, as libspnav reads from a socket and may allocate; the haptic thread takes the
/// newest deflection from it, wait-free. The daemon's end is kFailed. One at a time in a process, as libspnav has one
/// connection.
class SpacenavDevice final : public OpenDevice {
 public:
  /// Connects. `motion` goes on from where it is, also on the next device. Throws InterfaceError.
  SpacenavDevice(const SpacenavLibrary& library, std::shared_ptr<SpacenavMotion> motion);
  ~SpacenavDevice() override;

  /// No force and no torque.
  static InterfaceCapability spacenav_capability();
  InterfaceCapability capability() const override { return spacenav_capability(); }
  DeviceAnswer read(double time, InterfaceState& state) noexcept override;
  /// Displays nothing, whatever is commanded.
  DeviceAnswer write(const InterfaceCommand& command) noexcept override;

  /// Whether the daemon answers. Throws InterfaceError where it does not.
  static void check_daemon(const SpacenavLibrary& library);

 private:
  struct Connection;  // to the daemon
  struct Seen {
    SpacenavDeflection deflection;
    std::uint32_t buttons = 0;
  };

  void listen();
  bool take_events() noexcept;

  SpacenavLibrary library_;
  std::shared_ptr<SpacenavMotion> motion_;
  std::unique_ptr<Connection> connection_;
  LatestValue<Seen> latest_;
  Seen seen_;  // the listening thread's
  std::atomic<bool> ending_{false}, lost_{false};
  std::thread thread_;
};

}  // namespace tegotae
