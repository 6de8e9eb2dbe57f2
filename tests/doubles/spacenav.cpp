// SPDX-License-Identifier: Apache-2.0
// The functions of libspnav that the driver uses. The daemon is DoubleState: its deflection and buttons become events
// when they change, `unplugged` ends the connection.
#include <tests/doubles/double_device.hpp>

#include <sys/socket.h>
#include <unistd.h>

#include <array>

using tegotae::test::DoubleDevice;
using tegotae::test::DoubleState;

namespace {

struct Motion {
  int type;
  int x, y, z, rx, ry, rz;
  unsigned period;
  int* data;
};
struct Button {
  int type, press, number;
};
union Event {
  Motion motion;
  Button button;
  int type;
};

DoubleDevice& device() { return DoubleDevice::instance(); }

// One connection in a process, used by one thread at a time, as libspnav's.
std::array<int, 2> ends = {-1, -1};
std::array<int, 6> told{};
unsigned told_buttons = 0;

void close_end(int& end) {
  if (end >= 0) close(end);
  end = -1;
}

}  // namespace

#define TEGOTAE_EXPORT extern "C" __attribute__((visibility("default")))

TEGOTAE_EXPORT int spnav_open() {
  if (ends[0] >= 0 || !device().open()) return -1;
  if (socketpair(AF_UNIX, SOCK_STREAM, 0, ends.data()) != 0) return -1;
  told = {};
  told_buttons = 0;
  return 0;
}
TEGOTAE_EXPORT int spnav_close() {
  if (ends[0] < 0) return -1;
  close_end(ends[0]);
  close_end(ends[1]);
  device().close();
  return 0;
}
TEGOTAE_EXPORT int spnav_fd() { return ends[0]; }
TEGOTAE_EXPORT int spnav_poll_event(Event* event) {
  const DoubleState* state = device().state();
  if (state == nullptr || ends[0] < 0) return 0;
  if (!device().is_open()) {
    close_end(ends[1]);
    return 0;
  }
  std::array<int, 6> now{};
  for (std::size_t i = 0; i < now.size(); ++i) now[i] = state->deflection[i].load();
  if (now != told) {
    told = now;
    event->motion = {1, now[0], now[1], now[2], now[3], now[4], now[5], 16, nullptr};
    return 1;
  }
  const unsigned changed = state->buttons.load() ^ told_buttons;
  for (int number = 0; number < 32; ++number) {
    const unsigned bit = 1U << number;
    if ((changed & bit) == 0) continue;
    told_buttons ^= bit;
    event->button = {2, (told_buttons & bit) != 0 ? 1 : 0, number};
    return 2;
  }
  return 0;
}
