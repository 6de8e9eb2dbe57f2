// SPDX-License-Identifier: Apache-2.0
#include <tegotae/device/spidar_interface.hpp>

#include <tegotae/device/spidar_reach.hpp>
#include <tegotae/device/tolerances.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace tegotae {
namespace {

const SpidarSettings& checked(const SpidarSettings& settings) {
  check_force_closure(settings.geometry);
  if (!settings.X_WS.is_finite() || !(std::abs(settings.X_WS.q.norm() - 1.0) < 1e-9)) {
    throw std::invalid_argument(
        "the SPIDAR's place in the world is no pose: give finite metres and a unit quaternion.");
  }
  if (!(settings.velocity_window >= 0.0 && std::isfinite(settings.velocity_window)) || !(settings.rate > 0.0)) {
    throw std::invalid_argument("the SPIDAR's velocity window (s) must not be negative, its rate (Hz) above 0.");
  }
  return settings;
}

InterfaceCapability capability_of(const SpidarSettings& settings) {
  const SpidarReach reach = spidar_reach(settings.geometry, {});
  InterfaceCapability result;
  result.name = "spidar-g6:" + settings.geometry.name;
  result.max_force = reach.force;
  result.max_torque = reach.torque;
  result.rate = settings.rate;
  // A component rounded to steps of q is off by q/sqrt(12) RMS.
  const Matrix6 covariance = spidar_quantisation(settings.geometry, {});
  result.encoder_step = std::sqrt(12.0 * covariance.diagonal().head<3>().maxCoeff());
  return result;
}

}  // namespace

SpidarInterface::SpidarInterface(const SpidarSettings& settings, std::unique_ptr<SpidarTransport> transport,
                                 SpidarZero zero)
    : settings_(checked(settings)),
      transport_(std::move(transport)),
      capability_(capability_of(settings)),
      radius_(knot_radius(settings.geometry)),
      min_(min_tensions(settings.geometry)),
      max_(max_tensions(settings.geometry)) {
  const SpidarVector at_centre = spidar_strings(settings_.geometry, {}).lengths;
  let_out_at_centre_ = (at_centre.array() / (1.0 + min_.array() / settings_.geometry.axial_stiffness)).matrix();
  for (int i = 0; i < kSpidarStrings; ++i) {
    metres_per_pulse_[i] = settings_.geometry.strings[static_cast<std::size_t>(i)].metres_per_pulse;
  }
  if (!begin(zero)) {
    throw std::runtime_error("the SPIDAR '" + settings_.geometry.name +
                             "' does not answer: check its power, its cable and the rights on its port.");
  }
}

SpidarInterface::~SpidarInterface() { transport_->write(min_); }

InterfaceStatus SpidarInterface::calibrate() noexcept {
  return begin(SpidarZero::kHere) ? InterfaceStatus::kOk : InterfaceStatus::kLost;
}

bool SpidarInterface::begin(SpidarZero zero) noexcept {
  pose_ = {};
  last_lengths_ = spidar_strings(settings_.geometry, {}).lengths;
  last_time_ = -std::numeric_limits<double>::infinity();
  is_doubted_ = false;
  lost();
  if (!transport_->write(min_) || (zero == SpidarZero::kHere && !transport_->reset())) return false;
  is_lost_ = false;
  return true;
}

InterfaceStatus SpidarInterface::read(double time, InterfaceState& state) noexcept {
  SpidarVector counts;
  if (!transport_->read(time, counts)) return lost();
  if (!fit(lengths(counts), time)) return lost();
  is_lost_ = false;
  state = {};
  state.time = time - transport_->age();
  state.buttons = transport_->buttons();
  state.X_WT = settings_.X_WS * pose_.X_SG;
  history_.add(time, state.X_WT);
  state.V_WT = history_.velocity(settings_.velocity_window);
  return InterfaceStatus::kOk;
}

InterfaceStatus SpidarInterface::write(const InterfaceCommand& command) noexcept {
  if (is_lost_) return lost();
  const Quaternion q_SW = settings_.X_WS.q.conjugate();
  const Wrench wrench_S{q_SW * command.wrench.force, q_SW * command.wrench.torque};
  const SpidarStrings strings = spidar_strings(settings_.geometry, pose_.X_SG);
  display_ = spidar_tensions(strings.wrenches, radius_, min_, max_, wrench_S);
  if (display_.display != SpidarDisplay::kExact) ++shortfalls_;
  return transport_->write(display_.tensions) ? InterfaceStatus::kOk : lost();
}

// From the last pose; where nothing fits there, from the centre, to which the grip may have been put back.
bool SpidarInterface::fit(const SpidarVector& lengths, double time) noexcept {
  const double since = std::max(time - last_time_, 1.0 / settings_.rate);
  if ((lengths - last_lengths_).cwiseAbs().maxCoeff() > tolerance::kSpidarFastest * since) is_doubted_ = true;
  const double misfit = is_doubted_ ? tolerance::kSpidarSureMisfit : tolerance::kSpidarMisfit;
  const Pose last = pose_.X_SG;
  for (const Pose& guess : {last, Pose{}}) {
    pose_ = spidar_pose(settings_.geometry, lengths, guess);
    if (pose_.fit == SpidarFit::kConverged && pose_.misfit <= misfit) {
      is_doubted_ = false;
      last_lengths_ = lengths;
      last_time_ = time;
      return true;
    }
  }
  pose_.X_SG = last;
  return false;
}

SpidarVector SpidarInterface::lengths(const SpidarVector& counts) const noexcept {
  const SpidarVector let_out = let_out_at_centre_ + metres_per_pulse_.cwiseProduct(counts);
  return (let_out.array() * (1.0 + display_.tensions.array() / settings_.geometry.axial_stiffness)).matrix();
}

InterfaceStatus SpidarInterface::lost() noexcept {
  is_lost_ = true;
  history_.clear();
  display_ = {};
  display_.tensions = min_;
  transport_->write(min_);
  return InterfaceStatus::kLost;
}

}  // namespace tegotae
