// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/device/vendor_library.hpp>

#include <string>

namespace tegotae {

/// Functions of Haption's Virtuose API, as the public headers of its version 4 declare them. A result of 0 is fine. SI
/// units, single precision; a pose is x y z and the quaternion x y z w; a speed and a force have the linear part first.
struct VirtuoseLibrary {
  static constexpr int kVersion = 4;  ///< others have another interface in binary
  static constexpr int kImpedance = 3;
  /// The pose follows the hand always. In the other modes the offset button, or no power, holds it still; some take the
  /// force meanwhile, and give it back in one step.
  static constexpr int kNoIndexing = 2;

  static VendorLibrary find();
  /// Throws InterfaceError where `library` is not loaded, is of another version or lacks a function.
  explicit VirtuoseLibrary(const VendorLibrary& library);

  /// Why the last call on `context` (null: opening) failed, in the API's words.
  std::string error(void* context) const;

  std::string file;
  int minor_version = 0;

  void* (*open)(const char* address) = nullptr;
  int (*close)(void*) = nullptr;
  int (*error_code)(void*) = nullptr;
  const char* (*error_message)(int) = nullptr;
  int (*set_indexing_mode)(void*, int) = nullptr;
  int (*set_force_factor)(void*, float) = nullptr;
  int (*set_speed_factor)(void*, float) = nullptr;
  int (*set_time_step)(void*, float seconds) = nullptr;
  int (*set_base_frame)(void*, float pose[7]) = nullptr;
  int (*set_observation_frame)(void*, float pose[7]) = nullptr;
  int (*set_command_type)(void*, int) = nullptr;
  int (*saturate)(void*, float newtons, float newton_metres) = nullptr;
  int (*enable_force_feedback)(void*, int on) = nullptr;
  int (*set_power)(void*, int on) = nullptr;
  int (*get_power)(void*, int* on) = nullptr;
  int (*get_emergency_stop)(void*, int* chain_is_closed) = nullptr;  ///< 1: it may run
  int (*is_shifting)(void*, int* shifting) = nullptr;  ///< by the offset button; null in versions without it
  int (*get_button)(void*, int number, int* pressed) = nullptr;
  int (*get_pose)(void*, float pose[7]) = nullptr;
  int (*get_speed)(void*, float speed[6]) = nullptr;
  int (*set_force)(void*, float force[6]) = nullptr;
};

}  // namespace tegotae
