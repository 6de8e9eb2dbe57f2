// SPDX-License-Identifier: Apache-2.0
#include <tegotae/device/guided_motion.hpp>

#include <tegotae/math/rotation.hpp>
#include <tegotae/runtime/vector_limits.hpp>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace tegotae {
namespace {

constexpr double kTimeConstant = 0.02;  // s: two messages of a page
constexpr double kMaxSpeed = 1.0;       // m/s
constexpr double kMaxTurn = 10.0;       // rad/s

}  // namespace

GuidedMotion::GuidedMotion(const Pose& start) : start_(start), X_WH_(start), target_(start), X_WH_script_(start) {
  reached_.write(start);
}

GuidedMotion::~GuidedMotion() { delete script_; }

void GuidedMotion::guide(const Pose& X_WT) { orders_.write({++number_, false, X_WT}); }

void GuidedMotion::play(Trajectory script) {
  given_ = ++number_;
  scripts_.give({given_, std::move(script)});
}

void GuidedMotion::stop() { orders_.write({++number_, true, {}}); }

Pose GuidedMotion::intended() {
  reached_.update();
  return reached_.get();
}

Pose GuidedMotion::at(double time) noexcept {
  const double duration = std::max(0.0, time - time_);
  time_ = time;
  take_order();
  take_script();
  if (script_ != nullptr) {
    X_WH_ = target_ = scripted(time);
    if (time - script_begin_ >= script_->content.motion.end() - script_->content.motion.start()) end_script();
  } else {
    X_WH_ = towards(target_, duration);
  }
  reached_.write(X_WH_);
  return X_WH_;
}

void GuidedMotion::place(double time, const Pose& X_WT) noexcept {
  end_script();
  time_ = time;
  X_WH_ = target_ = X_WT;
  reached_.write(X_WH_);
}

// An order that was given before a script that came already is over.
void GuidedMotion::take_order() noexcept {
  if (!orders_.update() || orders_.get().number < taken_) return;
  const Order& order = orders_.get();
  taken_ = order.number;
  end_script();
  target_ = order.stays ? X_WH_ : order.X_WT.pose();
}

void GuidedMotion::take_script() noexcept {
  ScriptEnvelope* const next = scripts_.take();
  if (next == nullptr) return;
  if (next->content.number < taken_) {
    ended_.store(next->content.number, std::memory_order_release);
    scripts_.give_back(next);
    return;
  }
  taken_ = next->content.number;
  end_script();
  script_ = next;
  script_begin_ = time_;
  X_WH_script_ = X_WH_;
}

void GuidedMotion::end_script() noexcept {
  if (script_ == nullptr) return;
  ended_.store(script_->content.number, std::memory_order_release);
  scripts_.give_back(std::exchange(script_, nullptr));
}

Pose GuidedMotion::scripted(double time) const noexcept {
  const Trajectory& motion = script_->content.motion;
  const Pose moved = motion.at(motion.start() + time - script_begin_);
  return {X_WH_script_.p + moved.p, (moved.q * X_WH_script_.q).normalized()};
}

Pose GuidedMotion::towards(const Pose& target, double duration) const noexcept {
  const Vector6 way = displacement(X_WH_, target, Vector3::Zero());
  const double share = 1.0 - std::exp(-duration / kTimeConstant);
  const Vector3 dr = saturated(share * way.head<3>(), kMaxSpeed * duration);
  const Vector3 dtheta = saturated(share * way.tail<3>(), kMaxTurn * duration);
  return displaced(X_WH_, X_WH_.p, dr, dtheta);
}

}  // namespace tegotae
