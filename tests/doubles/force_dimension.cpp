// SPDX-License-Identifier: Apache-2.0
// The functions of Force Dimension's libraries that the driver uses, on a DoubleDevice, whose axes are theirs: x
// towards the person, y to the right, z up. One device, of number 0. Built as libdrd; with TEGOTAE_DOUBLE_DHD_ONLY as
// libdhd, which has no drd functions; with TEGOTAE_DOUBLE_INCOMPLETE without dhdSetForceAndTorqueAndGripperForce.
#include <tests/doubles/double_device.hpp>

#include <cstddef>

using tegotae::Matrix3;
using tegotae::Wrench;
using tegotae::test::DoubleDevice;
using tegotae::test::DoubleReading;
using tegotae::test::DoubleState;

namespace {

constexpr int kError = -1;
constexpr int kTimeGuard = 1;
constexpr int kSaturated = 2;
constexpr const char* kNone = "no device found";

thread_local const char* last_error = "no error";
std::atomic<unsigned> readings{0};

int failed(const char* why) {
  last_error = why;
  return kError;
}

bool is_mine(char id) { return id == 0 || id == -1; }

DoubleDevice& device() { return DoubleDevice::instance(); }

int open_device(int id) { return is_mine(static_cast<char>(id)) && device().open() ? 0 : failed(kNone); }

int close_device(char id) { return is_mine(id) && device().close() ? 0 : failed("device not open"); }

// Of what the state says, false where there is none.
template <class Ask>
bool says(char id, const Ask& ask) {
  const DoubleState* state = device().state();
  return is_mine(id) && state != nullptr && ask(*state);
}

// A reading now and then comes too early for the device's own rate, which is no error.
int read(char id, DoubleReading& reading) {
  if (!is_mine(id) || !device().read(reading)) return failed("communication refused");
  return readings.fetch_add(1) % 5 == 4 ? kTimeGuard : 0;
}

int command(char id, const Wrench& wrench, double gripper_force) {
  DoubleState* state = device().state();
  if (!is_mine(id) || state == nullptr) return failed(kNone);
  const double sign = state->left_handed.load() ? -1.0 : 1.0;
  if (!device().command(wrench, sign * gripper_force)) return failed("communication refused");
  return wrench.force.norm() > state->max_force.load() ? kSaturated : 0;
}

}  // namespace

#define TEGOTAE_EXPORT extern "C" __attribute__((visibility("default")))

#ifndef TEGOTAE_DOUBLE_DHD_ONLY
TEGOTAE_EXPORT int drdOpen() { return open_device(0); }
TEGOTAE_EXPORT int drdOpenID(char id) { return open_device(id); }
TEGOTAE_EXPORT int drdClose(char id) { return close_device(id); }
TEGOTAE_EXPORT bool drdIsInitialized(char id) {
  return says(id, [](const DoubleState& state) { return !state.uncalibrated.load(); });
}
TEGOTAE_EXPORT int drdAutoInit(char id) {
  return is_mine(id) && device().calibrate() ? 0 : failed("the arm cannot move freely");
}
TEGOTAE_EXPORT int drdStop(bool forces_on, char id) {
  return is_mine(id) && device().set_forces(forces_on) ? 0 : failed(kNone);
}
#endif

TEGOTAE_EXPORT int dhdGetDeviceCount() { return device().is_present() ? 1 : 0; }
TEGOTAE_EXPORT int dhdOpen() { return open_device(0); }
TEGOTAE_EXPORT int dhdOpenID(char id) { return open_device(id); }
TEGOTAE_EXPORT int dhdClose(char id) { return close_device(id); }
TEGOTAE_EXPORT int dhdStop(char id) { return is_mine(id) && device().set_forces(false) ? 0 : failed(kNone); }
TEGOTAE_EXPORT const char* dhdErrorGetLastStr() { return last_error; }
TEGOTAE_EXPORT const char* dhdGetSystemName(char id) {
  const DoubleState* state = device().state();
  return is_mine(id) && state != nullptr ? state->model.data() : nullptr;
}
TEGOTAE_EXPORT int dhdGetSerialNumber(unsigned short* number, char id) {
  const DoubleState* state = device().state();
  if (!is_mine(id) || state == nullptr || state->serial_number.load() == 0) return failed("not available");
  *number = static_cast<unsigned short>(state->serial_number.load());
  return 0;
}

TEGOTAE_EXPORT bool dhdHasWrist(char id) {
  return says(id, [](const DoubleState& state) { return state.degrees.load() == 6 || state.has_passive_wrist.load(); });
}
TEGOTAE_EXPORT bool dhdHasActiveWrist(char id) {
  return says(id, [](const DoubleState& state) { return state.degrees.load() == 6; });
}
TEGOTAE_EXPORT bool dhdHasGripper(char id) {
  return says(id, [](const DoubleState& state) { return state.has_gripper.load(); });
}
TEGOTAE_EXPORT bool dhdHasActiveGripper(char id) { return dhdHasGripper(id); }
TEGOTAE_EXPORT bool dhdIsLeftHanded(char id) {
  return says(id, [](const DoubleState& state) { return state.left_handed.load(); });
}

TEGOTAE_EXPORT int dhdEnableForce(unsigned char on, char id) {
  return is_mine(id) && device().set_forces(on != 0) ? 0 : failed(kNone);
}
TEGOTAE_EXPORT int dhdSetGravityCompensation(int on, char id) {
  DoubleState* state = device().state();
  if (!is_mine(id) || state == nullptr || !device().is_open()) return failed(kNone);
  state->gravity_compensated.store(on != 0);
  return 0;
}
TEGOTAE_EXPORT int dhdSetEffectorMass(double mass, char id) {
  DoubleState* state = device().state();
  if (!is_mine(id) || state == nullptr || !device().is_open()) return failed(kNone);
  state->effector_mass.store(mass);
  return 0;
}

TEGOTAE_EXPORT int dhdSetMaxForce(double newtons, char id) {
  DoubleState* state = device().state();
  if (!is_mine(id) || state == nullptr || !device().is_open()) return failed(kNone);
  state->limit_force.store(newtons);
  return 0;
}
TEGOTAE_EXPORT int dhdSetMaxTorque(double newton_metres, char id) {
  DoubleState* state = device().state();
  if (!is_mine(id) || state == nullptr || !device().is_open()) return failed(kNone);
  state->limit_torque.store(newton_metres);
  return 0;
}

TEGOTAE_EXPORT int dhdGetPosition(double* x, double* y, double* z, char id) {
  DoubleReading reading;
  const int result = read(id, reading);
  if (result < 0) return result;
  *x = reading.X.p.x();
  *y = reading.X.p.y();
  *z = reading.X.p.z();
  return result;
}
TEGOTAE_EXPORT int dhdGetPositionAndOrientationFrame(double* x, double* y, double* z, double frame[3][3], char id) {
  DoubleReading reading;
  const int result = dhdHasWrist(id) ? read(id, reading) : failed("not available on this device");
  if (result < 0) return result;
  *x = reading.X.p.x();
  *y = reading.X.p.y();
  *z = reading.X.p.z();
  Matrix3 rotation = reading.X.rotation();
  if (device().state()->bad_frame.load()) rotation.row(0).setZero();
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) frame[row][column] = rotation(row, column);
  }
  return result;
}
TEGOTAE_EXPORT int dhdGetLinearVelocity(double* x, double* y, double* z, char id) {
  DoubleReading reading;
  const int result = read(id, reading);
  if (result < 0) return result;
  *x = reading.V.linear.x();
  *y = reading.V.linear.y();
  *z = reading.V.linear.z();
  return result;
}
TEGOTAE_EXPORT int dhdGetAngularVelocityRad(double* x, double* y, double* z, char id) {
  DoubleReading reading;
  const int result = dhdHasWrist(id) ? read(id, reading) : failed("not available on this device");
  if (result < 0) return result;
  *x = reading.V.angular.x();
  *y = reading.V.angular.y();
  *z = reading.V.angular.z();
  return result;
}
TEGOTAE_EXPORT unsigned dhdGetButtonMask(char id) {
  const DoubleState* state = device().state();
  return is_mine(id) && state != nullptr ? state->buttons.load() : 0;
}
TEGOTAE_EXPORT int dhdGetGripperGap(double* gap, char id) {
  DoubleReading reading;
  const int result = dhdHasGripper(id) ? read(id, reading) : failed("not available on this device");
  if (result >= 0) *gap = reading.gripper;
  return result;
}

TEGOTAE_EXPORT int dhdSetForceAndGripperForce(double fx, double fy, double fz, double gripper, char id) {
  return command(id, {{fx, fy, fz}, tegotae::Vector3::Zero()}, gripper);
}
#ifndef TEGOTAE_DOUBLE_INCOMPLETE
TEGOTAE_EXPORT int dhdSetForceAndTorqueAndGripperForce(double fx, double fy, double fz, double tx, double ty, double tz,
                                                       double gripper, char id) {
  return command(id, {{fx, fy, fz}, {tx, ty, tz}}, gripper);
}
#endif
