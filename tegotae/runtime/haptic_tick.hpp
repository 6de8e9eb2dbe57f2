// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/model/representation_interpolator.hpp>
#include <tegotae/render/rendering_method.hpp>
#include <tegotae/runtime/haptic_interface.hpp>
#include <tegotae/runtime/impulse_sums.hpp>
#include <tegotae/runtime/safety.hpp>
#include <tegotae/runtime/tick_record.hpp>

#include <memory>

namespace tegotae {

/// Another method, or other settings of it, for a tick that runs.
struct HapticUpdate {
  std::unique_ptr<RenderingMethod> method;  ///< not null
  SafetyLimits limits;
};

/// One tick of the haptic rate: from the interface's state and the newest model to a command and a log record. Reading
/// and commanding the interface lies outside. No allocation, lock, system call or exception after construction; the
/// cost is bounded by the model's capacities.
class HapticTick {
 public:
  /// `period` in s. Large (the models of the interpolation): make it once. Allocates.
  HapticTick(RenderingMethod method, const Tool& tool, const SafetyLimits& limits, double period);

  /// What happened outside that the safety stage must know.
  struct Circumstances {
    bool interface_lost = false;
    bool ending = false;
  };

  /// `fresh` is a model that has come since the last tick, or null. Fills `record`, all but tick_us.
  InterfaceCommand operator()(const InterfaceState& state, const IntermediateRepresentation* fresh,
                              const Circumstances& circumstances, TickRecord& record) noexcept;

  /// The message to the physics loop: pose, twist, and the impulses displayed to the bodies until now.
  void fill(ImpulseSums& message, int body_count) const noexcept;

  /// Renders by `update` from now on, the tool staying where it is; what is no longer used is left in `update`, to be
  /// freed by whoever may. Does not allocate.
  void adopt(HapticUpdate& update) noexcept;

  /// What the last tick worked with.
  void view(ContactView& view) const noexcept;

  const SafetyState& safety() const noexcept { return safety_; }

 private:
  const IntermediateRepresentation& model_at(double time, const IntermediateRepresentation* fresh) noexcept;
  InterfaceState held(const InterfaceState& state, bool interface_lost) noexcept;
  double elapsed_until(double time) noexcept;
  SafetyOutput limit(const IntermediateRepresentation& model, double time, const Vector3& arm,
                     const Circumstances& circumstances) noexcept;
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
  InterfaceState state_;  ///< the last finite one
  bool pose_valid_ = false;
  double dt_;  ///< s since the last tick
  std::uint64_t tick_count_ = 0;
};

}  // namespace tegotae
