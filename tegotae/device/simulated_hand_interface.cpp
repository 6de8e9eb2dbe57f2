// SPDX-License-Identifier: Apache-2.0
#include <tegotae/device/simulated_hand_interface.hpp>

#include <tegotae/math/rotation.hpp>
#include <tegotae/runtime/vector_limits.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

namespace tegotae {
namespace {

constexpr double kTimeRounding = PoseHistory::kTimeRounding;
constexpr double kTargetSpan = 1e-3;    // s over which the hand's target moves linearly
constexpr double kLongestRead = 1.0;    // s: more is a fault of the caller's clock
constexpr double kLongestDelay = 0.1;   // s
constexpr double kFastestWrite = 20e3;  // Hz

void require(double value, double least, double most, const char* what) {
  if (std::isfinite(value) && value >= least && value <= most) return;
  throw std::invalid_argument("the simulated device's " + std::string(what) + " of " + std::to_string(value) +
                              " is out of range: " + std::to_string(least) + " to " + std::to_string(most));
}

const SimulatedDevice& checked(const SimulatedDevice& device) {
  require(device.delay, 0.0, kLongestDelay, "delay (s)");
  require(device.velocity_window, 0.0, kLongestRead, "velocity window (s)");
  require(device.capability.encoder_step, 0.0, 1.0, "encoder step (m)");
  require(device.encoder_angle, 0.0, 1.0, "encoder step (rad)");
  return device;
}

Vector3 rounded(const Vector3& value, double step) noexcept {
  if (step == 0.0) return value;
  return step * Vector3(std::round(value.x() / step), std::round(value.y() / step), std::round(value.z() / step));
}

}  // namespace

SimulatedHandInterface::SimulatedHandInterface(Trajectory intended, const SimulatedDevice& device,
                                               const HandImpedance& hand, double substep)
    : SimulatedHandInterface(std::make_unique<IntendedTrajectory>(std::move(intended)), device, hand, substep) {}

SimulatedHandInterface::SimulatedHandInterface(std::unique_ptr<IntendedMotion> intended, const SimulatedDevice& device,
                                               const HandImpedance& hand, double substep)
    : intended_(std::move(intended)),
      X_WG_start_(intended_->start()),
      X_WH_(X_WG_start_),
      device_(checked(device)),
      grip_(device.mechanics, hand, substep),
      waiting_(static_cast<std::size_t>(device.delay * kFastestWrite) + 2) {
  grip_.set_state({X_WG_start_, {}});
}

InterfaceCapability SimulatedHandInterface::capability() const {
  InterfaceCapability capability = device_.capability;
  capability.delay = device_.delay;
  return capability;
}

void SimulatedHandInterface::restart(double time, const Pose& X_WG) noexcept {
  grip_.set_state({X_WG, {}});
  X_WH_ = X_WG;
  time_ = time;
  displayed_ = {};
  first_ = count_ = 0;
  history_.clear();
}

InterfaceStatus SimulatedHandInterface::read(double time, InterfaceState& state) noexcept {
  if (!(time - time_ <= kLongestRead)) return InterfaceStatus::kLost;
  advance_to(time);
  state = {};
  state.time = time;
  state.X_WT = quantised(grip_.state().X_WG);
  history_.add(time_, state.X_WT);
  state.V_WT = history_.velocity(device_.velocity_window);
  return InterfaceStatus::kOk;
}

InterfaceStatus SimulatedHandInterface::write(const InterfaceCommand& command) noexcept {
  if (count_ == waiting_.size()) {
    ++dropped_;
    return InterfaceStatus::kOk;
  }
  Wrench wrench = command.wrench.is_finite() ? command.wrench : Wrench{};
  wrench.force = saturated(wrench.force, device_.capability.max_force);
  wrench.torque = saturated(wrench.torque, device_.capability.max_torque);
  waiting_[(first_ + count_) % waiting_.size()] = {time_ + device_.delay, wrench};
  ++count_;
  display_due();
  return InterfaceStatus::kOk;
}

void SimulatedHandInterface::advance_to(double time) noexcept {
  while (time - time_ > kTimeRounding) {
    double end = std::min(time, time_ + kTargetSpan);
    if (count_ > 0) end = std::min(end, waiting_[first_].due);
    const double duration = end - time_;
    const Pose X_WH_end = intended_->at(end);
    const Vector6 way = displacement(X_WH_, X_WH_end, Vector3::Zero());
    grip_.integrate(duration, displayed_, X_WH_, {way.head<3>() / duration, way.tail<3>() / duration});
    X_WH_ = X_WH_end;
    time_ = end;
    display_due();
  }
}

void SimulatedHandInterface::display_due() noexcept {
  while (count_ > 0 && waiting_[first_].due - time_ <= kTimeRounding) {
    displayed_ = waiting_[first_].wrench;
    first_ = (first_ + 1) % waiting_.size();
    --count_;
  }
}

Pose SimulatedHandInterface::quantised(const Pose& X_WG) const noexcept {
  Pose result = X_WG;
  result.p = rounded(X_WG.p, device_.capability.encoder_step);
  if (device_.encoder_angle > 0.0) {
    const Quaternion& q_start = X_WG_start_.q;
    const Vector3 turned = rotation_vector(X_WG.q * q_start.conjugate());
    result.q = (rotation_from_vector(rounded(turned, device_.encoder_angle)) * q_start).normalized();
  }
  return result;
}

}  // namespace tegotae
