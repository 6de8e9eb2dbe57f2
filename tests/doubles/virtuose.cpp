// SPDX-License-Identifier: Apache-2.0
// The functions of Haption's Virtuose API 4 that the driver uses, on a DoubleDevice, whose axes are its observation
// frame's. With TEGOTAE_DOUBLE_INCOMPLETE without virtAPIVersion, as a library whose version cannot be asked.
#include <tests/doubles/double_device.hpp>

#include <algorithm>
#include <cstring>

using tegotae::Vector3;
using tegotae::Wrench;
using tegotae::test::DoubleDevice;
using tegotae::test::DoubleReading;
using tegotae::test::DoubleState;

namespace {

constexpr int kFailed = -1;
constexpr int kCommunication = 2;
constexpr int kIncorrectValue = 9;
constexpr int kWrongMode = 17;
constexpr int kImpedance = 3;
constexpr int kNoIndexing = 2;

// What the maker's library keeps of a connection. Its order of calls is checked as the manual has it: factors, frames
// and time step before the command type, the command type before power and force.
struct Context {
  std::atomic<int> command_type{0}, indexing_mode{0};
  std::atomic<float> force_factor{0.0F}, speed_factor{0.0F}, time_step{0.0F}, most_force{0.0F}, most_torque{0.0F};
  std::atomic<bool> base_frame{false}, observation_frame{false}, feedback{false};
};

Context connection;
std::atomic<int> error_code{0};

int failed(int code) {
  error_code.store(code);
  return kFailed;
}

DoubleDevice& device() { return DoubleDevice::instance(); }
bool is_connected(const void* context) { return context == &connection && device().is_open(); }

bool is_identity(const float* frame) {
  return frame[6] == 1.0F && std::all_of(frame, frame + 6, [](float each) { return each == 0.0F; });
}

template <class Value>
int set(const void* context, std::atomic<Value>& member, Value value, bool fits) {
  if (!is_connected(context)) return failed(kCommunication);
  if (!fits) return failed(kIncorrectValue);
  if (connection.command_type.load() != 0) return failed(kWrongMode);
  member.store(value);
  return 0;
}

template <class Ask>
int tell(const void* context, int* value, const Ask& ask) {
  const DoubleState* state = device().state();
  if (!is_connected(context) || state == nullptr) return failed(kCommunication);
  *value = ask(*state) ? 1 : 0;
  return 0;
}

Wrench clipped(Wrench wrench) {
  const double force = wrench.force.norm(), torque = wrench.torque.norm();
  const double most_force = connection.most_force.load(), most_torque = connection.most_torque.load();
  if (most_force > 0.0 && force > most_force) wrench.force *= most_force / force;
  if (most_torque > 0.0 && torque > most_torque) wrench.torque *= most_torque / torque;
  return wrench;
}

bool drives(const DoubleState& state) {
  return state.powered.load() && !state.power_off.load() && !state.emergency_stop.load() && !state.hand_off.load();
}

// The offset button silences the force, unless it was told to do nothing.
bool is_shifted(const DoubleState& state) {
  return state.offset_button.load() && connection.indexing_mode.load() != kNoIndexing;
}

}  // namespace

#define TEGOTAE_EXPORT extern "C" __attribute__((visibility("default")))

#ifndef TEGOTAE_DOUBLE_INCOMPLETE
TEGOTAE_EXPORT int virtAPIVersion(int* major, int* minor) {
  const DoubleState* state = device().state();
  *major = state != nullptr && state->library_major.load() > 0 ? state->library_major.load() : 4;
  *minor = state != nullptr && state->library_major.load() > 0 ? state->library_minor.load() : 4;
  return 0;
}
#endif
TEGOTAE_EXPORT void* virtOpen(const char* name) {
  const DoubleState* state = device().state();
  if (state == nullptr || std::strcmp(name, state->model.data()) != 0 || !device().open()) {
    error_code.store(kCommunication);
    return nullptr;
  }
  connection.command_type.store(0);
  connection.indexing_mode.store(0);
  connection.feedback.store(false);
  connection.most_force.store(0.0F);
  connection.most_torque.store(0.0F);
  return &connection;
}
TEGOTAE_EXPORT int virtClose(void* context) {
  return context == &connection && device().close() ? 0 : failed(kCommunication);
}
TEGOTAE_EXPORT int virtGetErrorCode(void* /*context*/) { return error_code.load(); }
TEGOTAE_EXPORT const char* virtGetErrorMessage(int code) {
  switch (code) {
    case 0:
      return "no error";
    case kCommunication:
      return "communication failure";
    case kIncorrectValue:
      return "incorrect value";
    case kWrongMode:
      return "wrong mode";
    default:
      return "another error";
  }
}

TEGOTAE_EXPORT int virtSetIndexingMode(void* context, int mode) {
  if (!is_connected(context)) return failed(kCommunication);
  connection.indexing_mode.store(mode);
  return 0;
}
TEGOTAE_EXPORT int virtSetForceFactor(void* context, float factor) {
  return set(context, connection.force_factor, factor, factor > 0.0F);
}
TEGOTAE_EXPORT int virtSetSpeedFactor(void* context, float factor) {
  return set(context, connection.speed_factor, factor, factor > 0.0F);
}
TEGOTAE_EXPORT int virtSetTimeStep(void* context, float step) {
  return set(context, connection.time_step, step, step >= 0.001F && step <= 0.1F);
}
TEGOTAE_EXPORT int virtSetBaseFrame(void* context, const float* frame) {
  return set(context, connection.base_frame, true, is_identity(frame));
}
TEGOTAE_EXPORT int virtSetObservationFrame(void* context, const float* frame) {
  return set(context, connection.observation_frame, true, is_identity(frame));
}
TEGOTAE_EXPORT int virtSetCommandType(void* context, int type) {
  if (!is_connected(context)) return failed(kCommunication);
  const bool ready = connection.force_factor.load() == 1.0F && connection.speed_factor.load() == 1.0F &&
                     connection.time_step.load() > 0.0F && connection.base_frame.load() &&
                     connection.observation_frame.load();
  if (type == kImpedance && !ready) return failed(kWrongMode);
  connection.command_type.store(type);
  return 0;
}
TEGOTAE_EXPORT int virtSaturateTorque(void* context, float force, float torque) {
  if (!is_connected(context)) return failed(kCommunication);
  connection.most_force.store(force);
  connection.most_torque.store(torque);
  return 0;
}
TEGOTAE_EXPORT int virtEnableForceFeedback(void* context, int on) {
  if (!is_connected(context) || !device().set_forces(on != 0)) return failed(kCommunication);
  connection.feedback.store(on != 0);
  return 0;
}
TEGOTAE_EXPORT int virtSetPowerOn(void* context, int on) {
  DoubleState* state = device().state();
  if (!is_connected(context) || state == nullptr) return failed(kCommunication);
  if (on != 0 && connection.command_type.load() != kImpedance) return failed(kWrongMode);
  state->powered.store(on != 0);
  return 0;
}

TEGOTAE_EXPORT int virtGetPowerOn(void* context, int* power) { return tell(context, power, drives); }
// 1: the chain is closed, all is well.
TEGOTAE_EXPORT int virtGetEmergencyStop(void* context, int* closed) {
  return tell(context, closed, [](const DoubleState& state) { return !state.emergency_stop.load(); });
}
TEGOTAE_EXPORT int virtGetDeadMan(void* context, int* present) {
  return tell(context, present, [](const DoubleState& state) { return !state.hand_off.load(); });
}
TEGOTAE_EXPORT int virtIsInShiftPosition(void* context, int* shifting) {
  return tell(context, shifting, [](const DoubleState& state) { return state.offset_button.load(); });
}
TEGOTAE_EXPORT int virtGetButton(void* context, int number, int* pressed) {
  DoubleState* state = device().state();
  if (!is_connected(context) || state == nullptr) return failed(kCommunication);
  if (state->failed_buttons.load() > 0) {
    state->failed_buttons.fetch_sub(1);
    return failed(kCommunication);
  }
  const int bit = number - state->first_button.load();
  if (bit < 0 || bit >= state->button_count.load()) return failed(kIncorrectValue);
  *pressed = static_cast<int>((state->buttons.load() >> bit) & 1U);
  return 0;
}

TEGOTAE_EXPORT int virtGetPosition(void* context, float* pose) {
  DoubleReading reading;
  if (context != &connection || !device().read(reading)) return failed(kCommunication);
  const auto& [p, q] = reading.X;
  const double values[7] = {p.x(), p.y(), p.z(), q.x(), q.y(), q.z(), q.w()};
  for (int i = 0; i < 7; ++i) pose[i] = static_cast<float>(values[i]);
  return 0;
}
TEGOTAE_EXPORT int virtGetSpeed(void* context, float* speed) {
  DoubleReading reading;
  if (context != &connection || !device().read(reading)) return failed(kCommunication);
  for (int i = 0; i < 3; ++i) {
    speed[i] = static_cast<float>(reading.V.linear[i]);
    speed[i + 3] = static_cast<float>(reading.V.angular[i]);
  }
  return 0;
}
TEGOTAE_EXPORT int virtSetForce(void* context, const float* force) {
  if (context != &connection) return failed(kCommunication);
  if (connection.command_type.load() != kImpedance) return failed(kWrongMode);
  const Wrench wrench{Vector3(force[0], force[1], force[2]), Vector3(force[3], force[4], force[5])};
  const DoubleState* state = device().state();
  if (state != nullptr && is_shifted(*state)) return device().command({}, 0.0) ? 0 : failed(kCommunication);
  const bool powered = state != nullptr && drives(*state);
  return device().command(powered ? clipped(wrench) : wrench, 0.0) ? 0 : failed(kCommunication);
}
