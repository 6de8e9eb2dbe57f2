// SPDX-License-Identifier: Apache-2.0
#include <tegotae/device/simulated_spidar.hpp>

#include <tegotae/device/pose_history.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace tegotae {
namespace {

constexpr double kSpan = 0.2e-3;            // s over which the strings' directions and the hand's speed are held
constexpr double kLongestSpidarRead = 1.0;  // s: more is a fault of the caller's clock

const SimulatedSpidarSettings& checked(const SimulatedSpidarSettings& settings) {
  check_numbers(settings.geometry);
  return settings;
}

}  // namespace

SimulatedSpidar::SimulatedSpidar(const SimulatedSpidarSettings& settings, std::unique_ptr<IntendedMotion> intended)
    : settings_(checked(settings)),
      intended_(std::move(intended)),
      grip_(settings.mechanics, settings.hand, settings.substep),
      X_WH_(intended_->start()),
      tensions_(min_tensions(settings.geometry)) {
  grip_.set_state({X_WH_, {}});
  reset();
}

bool SimulatedSpidar::reset() noexcept {
  let_out_at_reset_ = let_out(spidar_strings(settings_.geometry, {}).lengths, min_tensions(settings_.geometry));
  return is_connected_;
}

bool SimulatedSpidar::read(double time, SpidarVector& counts) noexcept {
  if (!(time - time_ <= kLongestSpidarRead)) return false;
  advance_to(time);
  if (!is_connected_) return false;
  const SpidarStrings strings = spidar_strings(settings_.geometry, settings_.X_WS.inverse() * grip_.state().X_WG);
  const SpidarVector length = let_out(strings.lengths, tensions_) - let_out_at_reset_;
  for (int i = 0; i < kSpidarStrings; ++i) {
    counts[i] = std::round(length[i] / settings_.geometry.strings[static_cast<std::size_t>(i)].metres_per_pulse);
  }
  return true;
}

bool SimulatedSpidar::write(const SpidarVector& tensions) noexcept {
  if (!is_connected_) return false;
  for (int i = 0; i < kSpidarStrings; ++i) {
    const SpidarString& string = settings_.geometry.strings[static_cast<std::size_t>(i)];
    tensions_[i] = std::isfinite(tensions[i]) ? std::clamp(tensions[i], 0.0, string.max_tension) : string.min_tension;
  }
  return true;
}

Wrench SimulatedSpidar::displayed() const noexcept {
  const Pose X_SG = settings_.X_WS.inverse() * grip_.state().X_WG;
  const Vector6 wrench = spidar_strings(settings_.geometry, X_SG).wrenches * tensions_;
  return {settings_.X_WS.q * wrench.head<3>(), settings_.X_WS.q * wrench.tail<3>()};
}

void SimulatedSpidar::set_connected(bool connected) noexcept {
  is_connected_ = connected;
  if (!connected) tensions_.setZero();
}

void SimulatedSpidar::advance_to(double time) noexcept {
  while (time - time_ > PoseHistory::kTimeRounding) {
    const double end = std::min(time, time_ + kSpan), duration = end - time_;
    const Pose X_WH_end = intended_->at(end);
    const Vector6 way = displacement(X_WH_, X_WH_end, Vector3::Zero());
    grip_.integrate(duration, displayed(), X_WH_, {way.head<3>() / duration, way.tail<3>() / duration});
    X_WH_ = X_WH_end;
    time_ = end;
  }
}

SpidarVector SimulatedSpidar::let_out(const SpidarVector& lengths, const SpidarVector& tensions) const noexcept {
  return (lengths.array() / (1.0 + tensions.array() / settings_.geometry.axial_stiffness)).matrix();
}

}  // namespace tegotae
