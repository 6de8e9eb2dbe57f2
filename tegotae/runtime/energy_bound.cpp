// SPDX-License-Identifier: Apache-2.0
#include <tegotae/runtime/energy_bound.hpp>

#include <algorithm>
#include <cmath>

namespace tegotae {
namespace {

// Energy (J) of a spring of `stiffness` stretched by `stretch`, of whose force `part` is displayed, up to `limit`.
double stored(double stiffness, double stretch, double part, double limit) noexcept {
  const double shown = part * stiffness * stretch;
  if (shown <= limit) return 0.5 * shown * stretch;
  return limit * (stretch - 0.5 * limit / (part * stiffness));
}

double product_in_metric(const Vector6& a, const Vector6& b, double l2) noexcept {
  return a.head<3>().dot(b.head<3>()) + l2 * a.tail<3>().dot(b.tail<3>());
}

// N: force, and torque over the metric length.
double size_in_metric(const Wrench& wrench, double metric_length) noexcept {
  return std::sqrt(wrench.force.squaredNorm() + wrench.torque.squaredNorm() / (metric_length * metric_length));
}

bool displays_nothing(const Wrench& wrench) noexcept {
  return wrench.force == Vector3::Zero() && wrench.torque == Vector3::Zero();
}

}  // namespace

// What the interface has displayed since the last call: the command of as many calls ago as its delay has periods.
const Wrench& EnergyBound::shown(const EnergyBoundSettings& settings, double dt, const Wrench& before) noexcept {
  newest_ = (newest_ + 1) % commanded_.size();
  commanded_[newest_] = before;
  const double calls = std::clamp(settings.delay / dt, 0.0, static_cast<double>(kMostDelay));
  const auto late = static_cast<std::size_t>(std::lround(calls));
  return commanded_[(newest_ + commanded_.size() - late) % commanded_.size()];
}

void EnergyBound::observe(const EnergyBoundSettings& settings, const EnergyBoundInput& input,
                          const Wrench& shown) noexcept {
  const double rotational = settings.stiffness * settings.metric_length * settings.metric_length;
  const auto held = [&](double stretch, double turn) {
    return stored(settings.stiffness, stretch, input.part, input.max_force) +
           stored(rotational, turn, input.part, input.max_torque);
  };
  const Vector3 dr = input.moved.head<3>(), dtheta = input.moved.tail<3>();
  const double given = shown.force.dot(dr) + shown.torque.dot(dtheta);
  // Of the same part of the motion that is braked: a slide earns nothing.
  const double swallowed = (settings.own_damping * std::max(0.0, input.stretched.head<3>().dot(dr)) +
                            settings.own_rotational_damping * std::max(0.0, input.stretched.tail<3>().dot(dtheta))) /
                           input.dt;
  const double change = held(input.stretch, input.turn) - held(stretch_, turn_);
  level_ = std::clamp(level_ - given - change + swallowed, -settings.debt, settings.carried);
  stretch_ = input.stretch;
  turn_ = input.turn;
}

Wrench EnergyBound::apply(const EnergyBoundSettings& settings, const EnergyBoundInput& input,
                          const Wrench& before) noexcept {
  damping_ = 0.0;
  if (!settings.on || !(input.dt > 0.0)) return input.target;
  const Wrench& displayed = shown(settings, input.dt, before);
  observe(settings, input, displayed);
  if (displays_nothing(displayed) && displays_nothing(input.target)) level_ = 0.0;
  if (!std::isfinite(level_)) reset();
  const Vector6& braked = input.stretched;
  const double l2 = settings.metric_length * settings.metric_length;
  // What a damper of 1 N s/m along `braked` takes from the motion, times dt.
  const double taken = product_in_metric(braked, input.moved, l2);
  if (!(level_ < 0.0 && taken > 0.0)) return input.target;

  double most = 4.0 * settings.stiffness * (0.5 * input.dt + settings.delay);
  if (settings.encoder_step > 0.0) most = std::min(most, settings.noise * input.dt / settings.encoder_step);
  const double speed = std::sqrt(product_in_metric(braked, braked, l2)) / input.dt;
  const double most_here = size_in_metric(input.target, settings.metric_length) / speed;
  damping_ = std::min({-level_ * input.dt / taken, most, most_here});
  return {input.target.force - damping_ / input.dt * braked.head<3>(),
          input.target.torque - damping_ * l2 / input.dt * braked.tail<3>()};
}

}  // namespace tegotae
