// SPDX-License-Identifier: Apache-2.0
// The functions of OpenHaptics' HD API that the driver uses, on a DoubleDevice, whose axes are the API's: x to the
// right, y up, z towards the person. The scheduler is a thread of the library's own at DoubleState::servo_rate, which
// goes on whatever the program does. DoubleState::oddity makes a fact otherwise than it is known. With
// TEGOTAE_DOUBLE_INCOMPLETE without hdUpdateCalibration.
#include <tests/doubles/double_device.hpp>

#include <array>
#include <cstring>
#include <thread>
#include <vector>

using tegotae::Matrix3;
using tegotae::Vector3;
using tegotae::Wrench;
using tegotae::test::DoubleDevice;
using tegotae::test::DoubleReading;
using tegotae::test::DoubleState;
using tegotae::test::HdOddity;

namespace {

using Callback = unsigned (*)(void*);

struct ErrorInfo {
  unsigned code;
  int internal_code;
  unsigned device;
};

constexpr unsigned kInvalidHandle = 0xFFFFFFFF, kTheDevice = 0;
constexpr unsigned kInvalidEnum = 0x0100, kInvalidOperation = 0x0102, kBadHandle = 0x0104;
constexpr unsigned kAlreadyInitiated = 0x0301, kNoAnswer = 0x0302, kIllegalBegin = 0x0400, kIllegalEnd = 0x0401;

// Errors and the frame are a thread's own, as the maker has them.
thread_local std::vector<unsigned> errors;
thread_local bool is_in_frame = false;
thread_local DoubleReading reading;
thread_local Wrench wrench;

std::atomic<bool> is_initialised{false}, is_enabled{false};
std::atomic<Callback> scheduled{nullptr};
std::atomic<void*> user_data{nullptr};
std::atomic<bool> is_running{false};
std::thread scheduler;  // of the thread that starts and stops it

void fail(unsigned code) { errors.push_back(code); }

DoubleDevice& device() { return DoubleDevice::instance(); }

bool is_odd(HdOddity oddity) {
  const DoubleState* state = device().state();
  return state != nullptr && state->oddity.load() == oddity;
}

void run_scheduler() {
  while (is_running.load()) {
    const DoubleState* state = device().state();
    const double rate = state != nullptr ? state->servo_rate.load() : 1000.0;
    std::this_thread::sleep_for(std::chrono::duration<double>(1.0 / rate));
    const Callback callback = scheduled.load();
    if (callback == nullptr || is_odd(HdOddity::kNoCallbacks)) continue;
    if (callback(user_data.load()) == 0) scheduled.store(nullptr);
  }
}

// Column by column, mm.
void write_transform(double* out) {
  const Matrix3 R = reading.X.q.toRotationMatrix();
  const bool by_rows = is_odd(HdOddity::kTransformByRows);
  const double unit = is_odd(HdOddity::kMicrometres) ? 1e6 : 1e3;
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) {
      double value = row == column ? 1.0 : 0.0;
      if (row < 3) value = column < 3 ? R(row, column) : unit * reading.X.p[row];
      out[by_rows ? 4 * row + column : 4 * column + row] = value;
    }
  }
}

Vector3 vector_of(const double* values) { return {values[0], values[1], values[2]}; }

}  // namespace

#define TEGOTAE_EXPORT extern "C" __attribute__((visibility("default")))

TEGOTAE_EXPORT unsigned hdInitDevice(const char* name) {
  const DoubleState* state = device().state();
  const bool is_named = name != nullptr && std::strcmp(name, "Default Device") != 0;
  if (state == nullptr || (is_named && std::strcmp(name, state->model.data()) != 0)) {
    fail(kNoAnswer);
    return kInvalidHandle;
  }
  if (is_initialised.load()) {
    fail(kAlreadyInitiated);
    return kInvalidHandle;
  }
  if (!device().open()) {
    fail(kNoAnswer);
    return kInvalidHandle;
  }
  is_initialised.store(true);
  return kTheDevice;
}
TEGOTAE_EXPORT void hdDisableDevice(unsigned handle) {
  if (handle != kTheDevice || !is_initialised.exchange(false)) return fail(kBadHandle);
  device().close();
}
TEGOTAE_EXPORT void hdMakeCurrentDevice(unsigned handle) {
  if (handle != kTheDevice || !is_initialised.load()) fail(kBadHandle);
}
TEGOTAE_EXPORT void hdBeginFrame(unsigned handle) {
  if (handle != kTheDevice || !is_initialised.load()) return fail(kBadHandle);
  if (is_in_frame) return fail(kIllegalBegin);
  is_in_frame = true;
  wrench = {};
  DoubleState* state = device().state();
  const int once = state != nullptr ? state->error_once.exchange(0) : 0;
  if (once != 0) fail(static_cast<unsigned>(once));
  if (!device().read(reading)) fail(kNoAnswer);
}
TEGOTAE_EXPORT void hdEndFrame(unsigned handle) {
  if (handle != kTheDevice || !is_in_frame) return fail(kIllegalEnd);
  is_in_frame = false;
  if (is_enabled.load() && !device().command(wrench, 0.0)) fail(kNoAnswer);
}
TEGOTAE_EXPORT void hdEnable(unsigned capability) {
  if (capability == 0x4000) {
    is_enabled.store(true);
    device().set_forces(true);
  } else if (capability != 0x4001 && capability != 0x4002) {
    fail(kInvalidEnum);
  }
}
TEGOTAE_EXPORT void hdDisable(unsigned capability) {
  if (capability != 0x4000) return fail(kInvalidEnum);
  is_enabled.store(false);
  device().set_forces(false);
}

TEGOTAE_EXPORT void hdGetDoublev(unsigned parameter, double* out) {
  const DoubleState* state = device().state();
  if (state == nullptr) return fail(kBadHandle);
  switch (parameter) {
    case 0x2052:
      return is_in_frame ? write_transform(out) : fail(kInvalidOperation);
    case 0x2051:
      if (!is_in_frame) return fail(kInvalidOperation);
      for (int i = 0; i < 3; ++i) out[i] = 1e3 * reading.V.linear[i];
      return;
    case 0x2602:
      *out = 1e-3 * state->nominal_stiffness.load();
      return;
    case 0x2603:
      *out = state->max_force.load();
      return;
    case 0x2622:
      *out = 1e3 * state->max_torque.load();
      return;
    default:
      return fail(kInvalidEnum);
  }
}
TEGOTAE_EXPORT void hdSetDoublev(unsigned parameter, const double* in) {
  if (!is_in_frame) return fail(kInvalidOperation);
  if (parameter == 0x2700) {
    wrench.force = vector_of(in);
  } else if (parameter == 0x2701 && !is_odd(HdOddity::kNoCartesianTorque)) {
    wrench.torque = 1e-3 * vector_of(in);
  } else {
    fail(kInvalidEnum);
  }
}
TEGOTAE_EXPORT void hdGetIntegerv(unsigned parameter, int* out) {
  const DoubleState* state = device().state();
  if (state == nullptr) return fail(kBadHandle);
  switch (parameter) {
    case 0x2000:
      *out = static_cast<int>(reading.buttons);
      return;
    case 0x2553:
      *out = is_odd(HdOddity::kManyDegrees) ? 1000 : 6;
      return;
    case 0x2554:
      *out = state->degrees.load();
      return;
    case 0x2555:
      *out = is_odd(HdOddity::kResetStyle) ? 1 : 4;
      return;
    default:
      return fail(kInvalidEnum);
  }
}
TEGOTAE_EXPORT const char* hdGetString(unsigned parameter) {
  const DoubleState* state = device().state();
  if (parameter == 0x2501 && state != nullptr) return state->model.data();
  fail(kInvalidEnum);
  return nullptr;
}
TEGOTAE_EXPORT ErrorInfo hdGetError() {
  if (errors.empty()) return {0, 0, kTheDevice};
  const unsigned code = errors.back();
  errors.pop_back();
  return {code, -1, kTheDevice};
}

TEGOTAE_EXPORT unsigned hdCheckCalibration() {
  const DoubleState* state = device().state();
  if (state == nullptr || state->cannot_calibrate.load()) return 0x5002;
  return state->uncalibrated.load() ? 0x5001 : 0x5000;
}
#ifndef TEGOTAE_DOUBLE_INCOMPLETE
TEGOTAE_EXPORT void hdUpdateCalibration(unsigned style) {
  if (style != 4 || !device().calibrate()) fail(kInvalidOperation);
}
#endif

TEGOTAE_EXPORT unsigned long hdScheduleAsynchronous(Callback callback, void* data, unsigned short /*priority*/) {
  user_data.store(data);
  scheduled.store(callback);
  return 1;
}
TEGOTAE_EXPORT void hdUnschedule(unsigned long handle) {
  if (handle != 1) fail(kBadHandle);
  scheduled.store(nullptr);
}
TEGOTAE_EXPORT void hdStartScheduler() {
  if (is_running.exchange(true)) return fail(kInvalidOperation);
  scheduler = std::thread(run_scheduler);
}
TEGOTAE_EXPORT void hdStopScheduler() {
  if (!is_running.exchange(false)) return fail(kInvalidOperation);
  scheduler.join();
}
