// SPDX-License-Identifier: Apache-2.0
#include <tegotae/device/openhaptics_servo.hpp>

#include <tegotae/device/tolerances.hpp>
#include <tegotae/runtime/periodic_timer.hpp>

#include <cmath>

namespace tegotae {
namespace {

constexpr double kMillimetre = 1e-3;  // m
constexpr double kNewtonMetre = 1e3;  // mN m
constexpr double kNanosecond = 1e-9;  // s

bool is_zero(const Wrench& wrench) noexcept { return wrench.force.isZero(0.0) && wrench.torque.isZero(0.0); }

}  // namespace

bool rigid_motion_of(const std::array<double, 16>& transform, Vector3& p_DG, Matrix3& R_DG) noexcept {
  for (const double number : transform) {
    if (!std::isfinite(number)) return false;
  }
  const Eigen::Map<const Eigen::Matrix4d> X(transform.data());  // column by column, as Eigen's
  p_DG = kMillimetre * X.topRightCorner<3, 1>();
  R_DG = X.topLeftCorner<3, 3>();
  const Eigen::RowVector4d last = X.row(3) - Eigen::RowVector4d(0.0, 0.0, 0.0, 1.0);
  const Matrix3 defect = R_DG.transpose() * R_DG - Matrix3::Identity();
  return last.cwiseAbs().maxCoeff() <= tolerance::kRigidTransform &&
         defect.cwiseAbs().maxCoeff() <= tolerance::kRigidTransform && R_DG.determinant() > 0.0 &&
         p_DG.norm() <= tolerance::kGreatestReach;
}

unsigned OpenHapticsServo::frame() noexcept {
  const bool is_last = ending_.load(std::memory_order_acquire);
  frame_failed_ = false;
  library_.make_current_device(device_);
  library_.begin_frame(device_);
  const OpenHapticsReading reading = read();
  take_errors();
  const Wrench wrench = command();
  send(is_last ? Wrench{} : wrench);
  library_.end_frame(device_);
  take_errors();
  failed_frames_ = frame_failed_ ? failed_frames_ + 1 : 0;
  if (frame_failed_) {
    ++sample_.counts.failed_frames;
  } else {
    ++sample_.counts.frames;
    static_cast<OpenHapticsReading&>(sample_) = reading;
  }
  sample_.has_failed = failed_frames_ >= kMostFailedFrames;
  samples_.write(sample_);
  if (!is_last && !sample_.has_failed) return hd::kCallbackContinue;
  ended_.store(true, std::memory_order_release);
  return hd::kCallbackDone;
}

OpenHapticsReading OpenHapticsServo::read() noexcept {
  std::array<double, 16> transform{};
  std::array<double, 3> velocity{};
  int buttons = 0;
  library_.get_doubles(hd::kCurrentTransform, transform.data());
  library_.get_doubles(hd::kCurrentVelocity, velocity.data());
  library_.get_integers(hd::kCurrentButtons, &buttons);
  OpenHapticsReading reading;
  reading.time = monotonic_nanoseconds();
  reading.buttons = static_cast<std::uint32_t>(buttons);
  Vector3 p_DG;
  Matrix3 R_DG;
  const Vector3 v_D(velocity[0], velocity[1], velocity[2]);
  if (!rigid_motion_of(transform, p_DG, R_DG) || !v_D.allFinite()) {
    history_.clear();
    return reading;
  }
  Pose X_WT = axes_.to_world(p_DG, R_DG);
  X_WT.q.normalize();
  history_.add(kNanosecond * static_cast<double>(reading.time), X_WT);
  reading.X_WT = X_WT;
  reading.V_WT = Twist{axes_.to_world(Vector3(kMillimetre * v_D)), history_.velocity(kVelocityWindow).angular};
  reading.is_plausible = true;
  return reading;
}

// The newest command, unless it is withheld. A frame that failed, and the one after it, whose predecessor may have
// failed when it was ended, command zero: so whichever is the last, zero was commanded before it.
Wrench OpenHapticsServo::command() noexcept {
  const bool is_new = commands_.update();
  const Wrench wrench = commands_.get();
  silent_callbacks_ = is_new ? 0 : silent_callbacks_ + 1;
  if (frame_failed_ || failed_frames_ > 0) {
    if (!is_zero(wrench)) sample_.is_withheld = true;
    return {};
  }
  if (sample_.is_withheld) {
    if (is_new && is_zero(wrench)) sample_.is_withheld = false;
  } else if (silent_callbacks_ >= kPatience && !is_zero(wrench)) {
    sample_.is_withheld = true;
    ++sample_.counts.withheld;
  }
  return sample_.is_withheld || !wrench.is_finite() ? Wrench{} : wrench;
}

void OpenHapticsServo::send(const Wrench& wrench_W) noexcept {
  const Vector3 force = axes_.to_device(wrench_W.force);
  library_.set_doubles(hd::kCurrentForce, force.data());
  // A frame that failed already cannot tell whether there is such a parameter.
  if (turns() && (torque_is_asked_for_ || !frame_failed_)) send_torque(kNewtonMetre * axes_.to_device(wrench_W.torque));
}

// The first one asks whether there is such a parameter.
void OpenHapticsServo::send_torque(const Vector3& torque) noexcept {
  if (!torque_is_asked_for_) take_errors();  // which are not its own
  library_.set_doubles(hd::kCurrentTorque, torque.data());
  if (torque_is_asked_for_) return;
  torque_is_asked_for_ = true;
  const unsigned code = library_.get_error().code;
  if (code == hd::kSuccess) return;
  if (code == hd::kInvalidEnum || code == hd::kInvalidValue || code == hd::kInvalidOperation) {
    turns_.store(false, std::memory_order_release);
  } else {
    account(code);
  }
}

void OpenHapticsServo::take_errors() noexcept {
  for (int i = 0; i < OpenHapticsLibrary::kMostErrors; ++i) {
    const unsigned code = library_.get_error().code;
    if (code == hd::kSuccess) return;
    account(code);
  }
}

void OpenHapticsServo::account(unsigned code) noexcept {
  OpenHapticsCounts& counts = sample_.counts;
  switch (code) {
    case hd::kWarmMotors:
      ++counts.warm_motors;
      break;
    case hd::kExceededForce:
      ++counts.exceeded_force;
      break;
    case hd::kExceededImpulse:
      ++counts.exceeded_impulse;
      break;
    case hd::kExceededVelocity:
      ++counts.exceeded_velocity;
      break;
    case hd::kForceError:
      ++counts.force_errors;
      break;
    default:
      frame_failed_ = true;
      counts.last_failure = code;
  }
}

}  // namespace tegotae
