// SPDX-License-Identifier: Apache-2.0
// The functions of spidar_transport.h on a DoubleDevice, whose axes are S: a SPIDAR of the preset that the state's
// model names. Strings are elastic, taut and massless; motors clip to [0, greatest tension]; encoders round. Options
// other than "" and "board 7" open nothing. With TEGOTAE_DOUBLE_INCOMPLETE without tegotae_spidar_stop.
#include <tegotae/device/spidar_transport.h>
#include <tegotae/device/spidar_presets.hpp>

#include <tests/doubles/double_device.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

using tegotae::kSpidarStrings;
using tegotae::Pose;
using tegotae::SpidarGeometry;
using tegotae::SpidarVector;
using tegotae::Vector6;
using tegotae::test::DoubleDevice;
using tegotae::test::DoubleReading;
using tegotae::test::DoubleState;

struct tegotae_spidar_board {
  SpidarGeometry geometry;
};

namespace {

constexpr int kError = -1;
constexpr double kNanosecond = 1e-9;

thread_local const char* last_error = nullptr;

int failed(const char* why) {
  last_error = why;
  return kError;
}

DoubleDevice& device() { return DoubleDevice::instance(); }

SpidarVector loaded(const std::array<std::atomic<double>, kSpidarStrings>& from) {
  SpidarVector result;
  for (int i = 0; i < kSpidarStrings; ++i) result[i] = from[static_cast<std::size_t>(i)].load();
  return result;
}

void store(std::array<std::atomic<double>, kSpidarStrings>& to, const SpidarVector& from) {
  for (int i = 0; i < kSpidarStrings; ++i) to[static_cast<std::size_t>(i)].store(from[i]);
}

SpidarVector let_out(const DoubleState& state, const SpidarVector& lengths) {
  return (lengths.array() / (1.0 + loaded(state.tensions).array() / state.axial_stiffness.load())).matrix();
}

Pose true_pose(const DoubleState& state) {
  const auto& s = state.pose;
  return {{s[0].load(), s[1].load(), s[2].load()},
          tegotae::Quaternion(s[3].load(), s[4].load(), s[5].load(), s[6].load()).normalized()};
}

// What the motors are told, clipped as they do, and the wrench that they display with it.
bool pull(tegotae_spidar_board& board, const SpidarVector& told) {
  DoubleState* state = device().state();
  if (state == nullptr) return false;
  const SpidarVector tensions = told.cwiseMax(0.0).cwiseMin(max_tensions(board.geometry));
  const Vector6 wrench = spidar_strings(board.geometry, true_pose(*state)).wrenches * tensions;
  if (!device().command({wrench.head<3>(), wrench.tail<3>()}, 0.0)) return false;
  store(state->tensions, tensions);
  return true;
}

}  // namespace

extern "C" {

int tegotae_spidar_version() {
  const DoubleState* state = device().state();
  return state != nullptr && state->library_major.load() > 0 ? state->library_major.load() : TEGOTAE_SPIDAR_VERSION;
}

int tegotae_spidar_sharing() {
  const DoubleState* state = device().state();
  return state != nullptr ? state->sharing.load() : TEGOTAE_SPIDAR_NEVER;
}

tegotae_spidar_board* tegotae_spidar_open(const char* options) {
  static tegotae_spidar_board board;
  last_error = "no board of that name";
  const std::string name = options;
  if (!name.empty() && name != "board 7") return nullptr;
  last_error = "nothing answers on its port";
  if (!device().open()) return nullptr;
  DoubleState& state = *device().state();
  board.geometry = tegotae::spidar_preset(state.model.data()).geometry;
  if (!state.forces_on.load()) store(state.tensions, SpidarVector::Zero());  // it had no power
  return &board;
}

int tegotae_spidar_strings(tegotae_spidar_board* /*board*/) {
  const DoubleState* state = device().state();
  return state != nullptr ? state->strings.load() : 0;
}

int tegotae_spidar_reset(tegotae_spidar_board* board) {
  if (!device().calibrate()) return failed("the counters cannot be set");
  DoubleState& state = *device().state();
  store(state.let_out_at_reset, let_out(state, spidar_strings(board->geometry, true_pose(state)).lengths));
  return 0;
}

int tegotae_spidar_read(tegotae_spidar_board* board, tegotae_spidar_reading* reading) {
  DoubleReading measured;
  if (!device().read(measured)) return failed("no packet came");
  const DoubleState& state = *device().state();
  const SpidarVector way =
      let_out(state, spidar_strings(board->geometry, measured.X).lengths) - loaded(state.let_out_at_reset);
  for (int i = 0; i < kSpidarStrings; ++i) {
    const auto string = static_cast<std::size_t>(i);
    reading->counts[i] =
        std::round(way[i] / board->geometry.strings[string].metres_per_pulse + state.slip[string].load());
  }
  const std::int64_t age = state.reading_age.load();
  reading->age = age == INT64_MAX ? HUGE_VAL : kNanosecond * static_cast<double>(age);
  reading->buttons = measured.buttons;
  reading->is_uncalibrated = state.uncalibrated.load() ? 1 : 0;
  return 0;
}

int tegotae_spidar_write(tegotae_spidar_board* board, const double* tensions) {
  if (!device().set_forces(true)) return failed("no answer to a packet");
  return pull(*board, Eigen::Map<const SpidarVector>(tensions)) ? 0 : failed("no answer to a packet");
}

#ifndef TEGOTAE_DOUBLE_INCOMPLETE
int tegotae_spidar_stop(tegotae_spidar_board* board) {
  const bool is_told = pull(*board, SpidarVector::Zero());
  return device().set_forces(false) && is_told ? 0 : failed("no answer to a packet");
}
#endif

void tegotae_spidar_close(tegotae_spidar_board* /*board*/) { device().close(); }

const char* tegotae_spidar_error() { return last_error; }

}  // extern "C"
