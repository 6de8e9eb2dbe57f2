// SPDX-License-Identifier: Apache-2.0
#include <tegotae/device/spacenav_device.hpp>

#include <tegotae/device/interface_driver.hpp>
#include <tegotae/device/interface_options.hpp>

#include <poll.h>
#include <sys/socket.h>

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <string>
#include <utility>

namespace tegotae {
namespace {

constexpr int kWait = 20;         // ms for an event, and so until the end is noticed
constexpr int kMostEvents = 256;  // taken at once: seconds of them
constexpr int kButtons = 32;      // that an InterfaceState has room for

// The other end has closed the connection.
bool has_ended(int file) noexcept {
  char byte = 0;
  return recv(file, &byte, 1, MSG_PEEK | MSG_DONTWAIT) == 0;
}

}  // namespace

VendorLibrary SpacenavLibrary::find() {
  return VendorLibrary({"spacenav",
                        "libspnav",
                        {"libspnav.so.0", "libspnav.so"},
                        "",
                        "Install it, and the daemon that it speaks to: sudo apt install libspnav0 spacenavd."});
}

SpacenavLibrary::SpacenavLibrary(const VendorLibrary& library) {
  library.require("spnav_open", open);
  library.require("spnav_close", close);
  library.require("spnav_fd", file);
  library.require("spnav_poll_event", poll_event);
}

SpacenavSettings parse_spacenav_settings(std::string_view text) {
  InterfaceOptions given("spacenav", text);
  SpacenavSettings settings;
  if (!given.value().empty()) {
    throw InterfaceError("spacenav: '" + given.value() +
                         "' is no option; all 3-D mice of the daemon are one, so there is no name.");
  }
  if (given.text("mode", "rate|offset") == "offset") settings.mode = SpacenavSettings::Mode::kOffset;
  settings.speed = given.number("speed", 1e-4, 1.0).value_or(settings.speed);
  settings.turning_speed = given.number("turning-speed", 1e-3, 10.0).value_or(settings.turning_speed);
  settings.reach = given.number("reach", 1e-4, 1.0).value_or(settings.reach);
  settings.tilt = given.number("tilt", 1e-3, 3.0).value_or(settings.tilt);
  settings.dead_zone = given.number("dead-zone", 0.0, 0.9).value_or(settings.dead_zone);
  if (const auto axes = given.text("axes")) {
    try {
      settings.axes = AxisMap(*axes);
    } catch (const std::invalid_argument& error) {
      throw InterfaceError(std::string("spacenav: ") + error.what());
    }
  }
  given.refuse_others();
  return settings;
}

struct SpacenavDevice::Connection {
  explicit Connection(const SpacenavLibrary& the_library) : library(the_library) {
    if (is_taken.exchange(true)) throw InterfaceError("spacenav: this program listens to the daemon already.");
    if (library.open() >= 0) return;
    is_taken.store(false);
    throw InterfaceError(
        "spacenav: the daemon spacenavd does not answer; sudo apt install spacenavd; sudo systemctl start spacenavd.");
  }
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;
  ~Connection() {
    library.close();
    is_taken.store(false);
  }

  const SpacenavLibrary& library;
  static inline std::atomic<bool> is_taken{false};
};

SpacenavDevice::SpacenavDevice(const SpacenavLibrary& library, std::shared_ptr<SpacenavMotion> motion)
    : library_(library), motion_(std::move(motion)), connection_(std::make_unique<Connection>(library_)) {
  thread_ = std::thread([this] { listen(); });
}

SpacenavDevice::~SpacenavDevice() {
  ending_.store(true, std::memory_order_release);
  thread_.join();
}

InterfaceCapability SpacenavDevice::spacenav_capability() {
  InterfaceCapability result;
  result.name = "spacenav";
  result.output_degrees_of_freedom = 0;
  result.max_force = 0.0;
  result.max_torque = 0.0;
  return result;
}

void SpacenavDevice::check_daemon(const SpacenavLibrary& library) { const Connection connection(library); }

void SpacenavDevice::listen() {
  while (!ending_.load(std::memory_order_acquire)) {
    pollfd file{library_.file(), POLLIN, 0};
    const int ready = poll(&file, 1, kWait);
    if (take_events()) {
      latest_.write(seen_);
    } else if (ready > 0) {
      // Something that is no event: the end, or bytes that libspnav kept to itself.
      if ((file.revents & (POLLERR | POLLHUP | POLLNVAL)) != 0 || has_ended(file.fd)) break;
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }
  lost_.store(true, std::memory_order_release);
}

// Whether there was one.
bool SpacenavDevice::take_events() noexcept {
  bool any = false;
  SpacenavLibrary::Event event{};
  for (int i = 0; i < kMostEvents && library_.poll_event(&event) != 0; ++i) {
    any = true;
    if (event.type == SpacenavLibrary::kMotion) {
      const auto& [type, x, y, z, rx, ry, rz, period, data] = event.motion;
      seen_.deflection = {{x, y, z}, {rx, ry, rz}};
    } else if (event.type == SpacenavLibrary::kButton && event.button.number >= 0 && event.button.number < kButtons) {
      const std::uint32_t bit = std::uint32_t{1} << event.button.number;
      seen_.buttons = event.button.press != 0 ? seen_.buttons | bit : seen_.buttons & ~bit;
    }
  }
  return any;
}

DeviceAnswer SpacenavDevice::read(double time, InterfaceState& state) noexcept {
  if (lost_.load(std::memory_order_acquire)) return DeviceAnswer::kFailed;
  latest_.update();
  const Seen& seen = latest_.get();
  motion_->advance(time, seen.deflection);
  state = {};
  state.time = time;
  state.X_WT = motion_->X_WT();
  state.V_WT = motion_->V_WT();
  state.buttons = seen.buttons;
  return DeviceAnswer::kOk;
}

DeviceAnswer SpacenavDevice::write(const InterfaceCommand& /*command*/) noexcept { return DeviceAnswer::kOk; }

}  // namespace tegotae
