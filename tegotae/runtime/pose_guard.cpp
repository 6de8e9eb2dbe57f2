// SPDX-License-Identifier: Apache-2.0
#include <tegotae/runtime/pose_guard.hpp>

#include <tegotae/math/rotation.hpp>

#include <algorithm>

namespace tegotae {
namespace {

// s. A device that reports more seldom than this is not one for force feedback; a hand that rested longer gets no more
// way for it.
constexpr double kLongestStill = 0.01;

constexpr double kFarthest = 100.0;  // m, of a device's workspace

bool is_pose(const InterfaceState& state) noexcept {
  const double square = state.X_WT.q.squaredNorm();
  return state.X_WT.is_finite() && state.V_WT.is_finite() && square > 0.25 && square < 2.25 &&
         state.X_WT.p.cwiseAbs().maxCoeff() < kFarthest;
}

bool is_same(const Pose& a, const Pose& b) noexcept { return a.p == b.p && a.q.coeffs() == b.q.coeffs(); }

bool is_near(const PoseGuard::Limits& limits, const Pose& a, const Pose& b, double time) noexcept {
  return (b.p - a.p).norm() <= limits.speed * time &&
         rotation_vector(b.q * a.q.conjugate()).norm() <= limits.turning_speed * time;
}

}  // namespace

PoseVerdict PoseGuard::judge(const Limits& limits, const InterfaceState& state, double elapsed) noexcept {
  still_ += elapsed;
  absent_ += elapsed;
  if (!is_pose(state)) return PoseVerdict::kFault;
  Pose pose = state.X_WT;
  pose.q.normalize();

  const bool first = !started_;
  const double allowed = std::clamp(kLongestStill, elapsed, std::max(still_, elapsed));
  const bool goes_on = first || lost_ || is_near(limits, seen_, pose, allowed);
  if (first || lost_ || !is_same(pose, seen_)) still_ = 0.0;
  seen_ = pose;
  started_ = true;
  if (!goes_on) {
    leapt_ = true;
    proven_ = 0.0;
    return PoseVerdict::kFault;
  }

  // Readings were refused or missed since the last good one, or it is not known for how long.
  const bool was_away = lost_ || absent_ > 1.5 * elapsed;
  const double since_good = lost_ ? kLongestStill : std::max(allowed, kLongestStill);
  const bool moved = !first && was_away && !is_near(limits, good_, pose, since_good);
  if (moved && leapt_ && !lost_) {
    proven_ += elapsed;
    if (proven_ < kProof) return PoseVerdict::kFault;
  }
  leapt_ = false;
  lost_ = false;
  good_ = pose;
  absent_ = 0.0;
  return moved ? PoseVerdict::kMoved : PoseVerdict::kGood;
}

}  // namespace tegotae
