// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/device/axis_map.hpp>
#include <tegotae/device/force_dimension_library.hpp>
#include <tegotae/device/open_device.hpp>
#include <tegotae/device/pose_age.hpp>
#include <tegotae/device/pose_history.hpp>

#include <optional>
#include <string>
#include <string_view>

namespace tegotae {

/// What `--interface force-dimension:...` says.
struct ForceDimensionOptions {
  std::optional<int> id;                ///< index of the device; none: the first
  AxisMap axes;                         ///< from the SDK's (x towards the person, y to the right, z up)
  bool gravity_compensation = true;     ///< the device carries its own weight
  std::optional<double> effector_mass;  ///< kg, of what is mounted at its end
  bool auto_init = true;                ///< a device that is not calibrated may move by itself to become so

  /// Throws InterfaceError.
  static ForceDimensionOptions parse(std::string_view text);
};

/// Force and torque limits (N, N m) and rated stiffness (N/m) of a model by the SDK's name for it; of one that is not
/// known what the weakest bear. A torque is displayed only where the wrist has motors. Makers' public figures; the
/// other ratings are assumed_ratings.hpp's.
InterfaceCapability force_dimension_capability(std::string_view model, bool has_wrist, bool has_active_wrist);

/// An open device of Force Dimension. Velocities are the SDK's (over the last 20 ms), or finite differences of the pose
/// where it refuses them; without a wrist rotation is the identity and its velocity zero. A positive gripper force
/// opens, of whichever hand the device is. A pose that stands still against the velocity is dated back (PoseAge).
class ForceDimensionDevice final : public OpenDevice {
 public:
  /// Opens. Where it is not calibrated and `may_move`, and the options and the library allow it, the device moves by
  /// itself to its stops and back. Throws InterfaceError.
  ForceDimensionDevice(const ForceDimensionLibrary& library, const ForceDimensionOptions& options, bool may_move);
  ~ForceDimensionDevice() override;

  InterfaceCapability capability() const override { return capability_; }
  DeviceAnswer read(double time, InterfaceState& state) noexcept override;
  DeviceAnswer write(const InterfaceCommand& command) noexcept override;

  /// Commands zero to a device that somebody else left, and lets go of it. False where the zero did not reach it.
  static bool silence(const ForceDimensionLibrary& library, const ForceDimensionOptions& options) noexcept;

 private:
  std::string serial_number() const;
  void calibrate(bool may_move) const;
  void prepare() const;
  Twist velocity() const noexcept;

  ForceDimensionLibrary library_;
  ForceDimensionOptions options_;
  char id_;
  bool has_wrist_ = false, has_active_wrist_ = false, has_gripper_ = false;
  double gripper_sign_ = 1.0;
  InterfaceCapability capability_;
  PoseHistory history_;
  PoseAge age_;
};

}  // namespace tegotae
