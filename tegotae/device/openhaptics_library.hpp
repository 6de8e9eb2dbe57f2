// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/device/vendor_library.hpp>

#include <string>

namespace tegotae {

/// Names and numbers of OpenHaptics' HD API (3D Systems), as its public headers of version 3.0 and those of 3.4 have
/// them.
namespace hd {

using Handle = unsigned;         ///< of a device
using Schedule = unsigned long;  ///< of a callback

inline constexpr Handle kInvalidHandle = 0xFFFFFFFF;
inline constexpr unsigned kCallbackDone = 0, kCallbackContinue = 1;
inline constexpr unsigned short kHighestPriority = 0xFFFF;

enum Parameter : unsigned {
  kCurrentButtons = 0x2000,
  kCurrentVelocity = 0x2051,   ///< mm/s
  kCurrentTransform = 0x2052,  ///< 16 numbers, column by column, mm
  kDeviceModelType = 0x2501,
  kInputDegrees = 0x2553,
  kOutputDegrees = 0x2554,
  kCalibrationStyle = 0x2555,     ///< bits
  kNominalMaxStiffness = 0x2602,  ///< N/mm
  kNominalMaxForce = 0x2603,      ///< N
  kNominalMaxTorque = 0x2622,     ///< mN m
  kCurrentForce = 0x2700,         ///< N
  kCurrentTorque = 0x2701,        ///< mN m, Cartesian; newer headers prefer torques of the joints
  kForceOutput = 0x4000,
  kMaxForceClamping = 0x4001,
  kForceRamping = 0x4002,
};

enum Calibration : unsigned { kCalibrationOk = 0x5000, kCalibrationNeedsUpdate = 0x5001, kCalibrationByHand = 0x5002 };
enum CalibrationStyle : unsigned { kEncoderReset = 1, kAutomatic = 2, kInkwell = 4 };

enum Error : unsigned {
  kSuccess = 0,
  kInvalidEnum = 0x0100,
  kInvalidValue = 0x0101,
  kInvalidOperation = 0x0102,
  kWarmMotors = 0x0200,
  kExceededForce = 0x0201,
  kExceededImpulse = 0x0202,
  kExceededVelocity = 0x0203,
  kForceError = 0x0204,
};

struct ErrorInfo {
  unsigned code;
  int internal_code;
  Handle device;
};

}  // namespace hd

/// Functions of OpenHaptics' HD API. Those without a device's handle are of the calling thread's current device.
struct OpenHapticsLibrary {
  static VendorLibrary find();
  /// Throws InterfaceError where `library` is not loaded or lacks a function.
  explicit OpenHapticsLibrary(const VendorLibrary& library);

  hd::Handle (*init_device)(const char* name);  ///< null: the default device
  void (*disable_device)(hd::Handle);
  void (*make_current_device)(hd::Handle);
  void (*begin_frame)(hd::Handle);
  void (*end_frame)(hd::Handle);
  void (*enable)(unsigned capability);
  void (*disable)(unsigned capability);
  void (*get_doubles)(unsigned parameter, double*);
  void (*set_doubles)(unsigned parameter, const double*);
  void (*get_integers)(unsigned parameter, int*);
  const char* (*get_string)(unsigned parameter);
  hd::ErrorInfo (*get_error)();  ///< the newest of the calling thread's, which it forgets with that
  unsigned (*check_calibration)();
  void (*update_calibration)(unsigned style);
  hd::Schedule (*schedule_asynchronous)(unsigned (*callback)(void*), void*, unsigned short priority);
  void (*unschedule)(hd::Schedule);
  void (*start_scheduler)();
  void (*stop_scheduler)();

  /// Errors that one call left at most; more are forgotten unseen.
  static constexpr int kMostErrors = 16;
};

}  // namespace tegotae
