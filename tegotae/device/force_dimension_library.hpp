// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/device/vendor_library.hpp>

#include <string>

namespace tegotae {

/// Functions of Force Dimension's SDK, as its public headers declare them (3.17). The last argument `char` is the
/// device: a default argument in the headers, so always to be given. A result below 0 is an error; 1 (asked faster than
/// the device answers) and 2 (a motor is at its limit) are none. SI units; x towards the person, y to the right, z up.
struct ForceDimensionLibrary {
  /// Any device.
  static constexpr char kDefaultDevice = -1;

  /// Looks for the libraries: libdrd, which can calibrate a device by moving it, then libdhd, which cannot.
  static VendorLibrary find();
  /// Throws InterfaceError where `library` is not loaded or lacks a function.
  explicit ForceDimensionLibrary(const VendorLibrary& library);

  /// Why the last call in this thread failed, in the SDK's words.
  std::string error() const;

  std::string file;

  // Of libdrd alone; all null with libdhd.
  int (*drd_open)() = nullptr;
  int (*drd_open_id)(char) = nullptr;
  int (*drd_close)(char) = nullptr;  ///< null in versions without it: dhd_close then
  bool (*drd_is_initialized)(char) = nullptr;
  int (*drd_auto_init)(char) = nullptr;
  int (*drd_stop)(bool forces_on, char) = nullptr;

  int (*device_count)() = nullptr;
  int (*open)() = nullptr;
  int (*open_id)(char) = nullptr;
  int (*close)(char) = nullptr;
  int (*stop)(char) = nullptr;  ///< null in versions without it
  const char* (*last_error)() = nullptr;
  const char* (*system_name)(char) = nullptr;
  int (*serial_number)(unsigned short* number, char) = nullptr;  ///< null in versions without it
  bool (*has_wrist)(char) = nullptr;
  bool (*has_active_wrist)(char) = nullptr;
  bool (*has_gripper)(char) = nullptr;
  bool (*is_left_handed)(char) = nullptr;
  int (*enable_force)(unsigned char on, char) = nullptr;
  int (*set_gravity_compensation)(int on, char) = nullptr;
  int (*set_effector_mass)(double kg, char) = nullptr;
  int (*set_max_force)(double newtons, char) = nullptr;         ///< null before 3.8 or so
  int (*set_max_torque)(double newton_metres, char) = nullptr;  ///< the same
  int (*position)(double* x, double* y, double* z, char) = nullptr;
  int (*pose)(double* x, double* y, double* z, double frame[3][3], char) = nullptr;
  int (*linear_velocity)(double* x, double* y, double* z, char) = nullptr;
  int (*angular_velocity)(double* x, double* y, double* z, char) = nullptr;
  unsigned (*button_mask)(char) = nullptr;
  int (*gripper_gap)(double* metres, char) = nullptr;
  int (*set_force)(double fx, double fy, double fz, double gripper, char) = nullptr;
  int (*set_wrench)(double fx, double fy, double fz, double tx, double ty, double tz, double gripper, char) = nullptr;
};

}  // namespace tegotae
