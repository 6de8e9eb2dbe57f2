// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/model/representation_interpolator.hpp>
#include <tegotae/render/rendering_method.hpp>
#include <tegotae/runtime/haptic_interface.hpp>
#include <tegotae/runtime/impulse_sums.hpp>
#include <tegotae/runtime/pose_guard.hpp>
#include <tegotae/runtime/safety.hpp>
#include <tegotae/runtime/tick_record.hpp>
#include <tegotae/runtime/workspace_mapping.hpp>
#include <tegotae/runtime/world.hpp>

#include <memory>

namespace tegotae {

/// Another method, or other settings of it, for a tick that runs.
struct HapticUpdate {
  std::unique_ptr<RenderingMethod> method;  ///< not null
  SafetyLimits limits;
};

/// One tick of the haptic rate: from the interface's state and the newest model to a command and a log record. Reading
/// and commanding the interface lies outside. Pose of the interface -> guard -> workspace mapping -> method -> mapping
/// back -> safety stage, in the interface's own units -> command; bodies and record take what was displayed, brought to
/// the world. No allocation, lock, system call or exception after construction; the cost is bounded by the model's
/// capacities.
class HapticTick {
 public:
  /// `period` in s. Large (the models of the interpolation): make it once. Allocates.
  HapticTick(RenderingMethod method, const Tool& tool, const SafetyLimits& limits, double period,
             const WorkspaceSettings& workspace = {});

  /// What happened outside that the safety stage must know.
  struct Circumstances {
    bool interface_lost = false;
    bool ending = false;
    bool clutched = false;  ///< besides the clutch button
    double pose_age = 0.0;  ///< s since the pose was measured, as far as the interface says
  };

  /// Where the tool is while the interface, at the start, is at `state`: for the first model. Optional.
  ToolState begin(const InterfaceState& state, bool interface_lost) noexcept;

  /// `state` as the interface reports it, but for its time, which is the loop's. `fresh` is a model that has come since
  /// the last tick, or null. Fills `record`, all but tick_us.
  InterfaceCommand operator()(const InterfaceState& state, const IntermediateRepresentation* fresh,
                              const Circumstances& circumstances, TickRecord& record) noexcept;

  /// The message to the physics loop: pose, twist, and the impulses displayed to the bodies until now.
  void fill(ImpulseSums& message, int body_count) const noexcept;

  /// Renders by `update` from now on, the tool staying where it is and the wrench growing slowly at first; what is no
  /// longer used is left in `update`, to be freed by whoever may. Does not allocate.
  void adopt(HapticUpdate& update) noexcept;

  /// What the last tick worked with.
  void view(ContactView& view) const noexcept;

  const SafetyState& safety() const noexcept { return safety_; }

 private:
  const IntermediateRepresentation& model_at(double time, const IntermediateRepresentation* fresh) noexcept;
  void hold_tool(const InterfaceState& state, const Circumstances& circumstances) noexcept;
  double elapsed_until(double time) noexcept;
  SafetyOutput limit(const IntermediateRepresentation& model, const InterfaceState& state, const Vector3& arm,
                     const Circumstances& circumstances) noexcept;
  void measure_spring(SafetyInput& input) noexcept;
  void push_bodies(const IntermediateRepresentation& model, const Wrench& displayed, const Vector3& p_WCm) noexcept;
  void write(const IntermediateRepresentation& model, const Wrench& displayed, TickRecord& record) const noexcept;

  std::unique_ptr<RenderingMethod> method_;
  Vector3 p_TCm_;
  SafetyLimits limits_;
  double length_;  ///< gyration length of the tool, m
  double period_;

  RepresentationInterpolator interpolator_;
  double model_arrival_ = 0.0;                         ///< s, when the newest model was first seen
  const IntermediateRepresentation* model_ = nullptr;  ///< of the last tick
  RenderOutput rendered_;
  SafetyState safety_;
  ImpulseAccumulator impulses_;
  WorkspaceMapping mapping_;
  PoseGuard guard_;
  bool based_ = false;                ///< the workspace has its place in the world
  InterfaceState state_;              ///< the tool's, in the world; the last good one
  bool pose_valid_ = false;           ///< of this tick
  bool clutched_ = false;             ///< in this tick
  Pose X_D_;                          ///< the grip, in the interface's workspace; the last good one
  Vector6 moved_ = Vector6::Zero();   ///< of the grip, in this tick
  Vector6 offset_ = Vector6::Zero();  ///< of the hand from the tool's proxy, about the grip, as felt
  Pose X_WT_felt_;                    ///< what the method is told: the tool's, once the world there is known
  double known_from_ = 0.0;           ///< s, the model's time from which on it is
  double dt_;                         ///< s since the last tick
  std::uint64_t tick_count_ = 0;
};

}  // namespace tegotae
