// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/separated_tool.hpp>

#include <tegotae/lab/separating_plane.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace tegotae {
namespace {

constexpr double kTrust = 1e-4;        // m: greatest step, far below any feature that a hand tells apart
constexpr double kTrustOfWay = 2.0;    // the first, of the hand's way: so that it leaps over no ridge to a lower place
constexpr double kFirstTrust = 1e-6;   // m: the first at least
constexpr double kAtBound = 0.4;       // of the trust: a step that would go further
constexpr double kLeastTrust = 1e-11;  // m: no step that small is refused but by rounding
constexpr double kShrink = 0.3, kGrow = 2.0;  // of the trust, after a step that was refused or taken
constexpr double kValueRounding = 1e-12;      // of the value, and
constexpr double kGapRounding = 1e-14;        // m, of each gap: what a step may seem to worsen
constexpr double kConverged = 1e-9;           // m: of the step, of violations
constexpr double kPlaneTurn = 1e-5;           // rad that the planes of loaded pairs still turn by
constexpr double kTouch = 1e-12;              // m of displacement, that a pushing force stretches the coupling by
constexpr int kPrograms = 3000;               // of one step of the hand: a leap of 10 cm
constexpr double kReach = 2.0 * kTrust;       // m: a step moves no point further, so pairs further apart wait

// What rounding alone can change of the `value` of the minimised function, m^2.
double rounding_of(double value, std::span<const PlanePair> pairs) {
  double rounding = kValueRounding * value;
  for (const PlanePair& pair : pairs) rounding += kGapRounding * pair.load;
  return rounding;
}

}  // namespace

SeparatedTool::SeparatedTool(const SceneGeometry& scene, const Parameters& parameters)
    : scene_(scene), parameters_(parameters) {
  for (const Shape& shape : scene.tool.pieces) {
    if (!shape.is_bounded()) throw std::invalid_argument("a tool cannot have a half-space among its pieces");
    tool_local_.push_back(core_of(shape));
    for (const Vector3& v : tool_local_.back().vertices)
      radius_ = std::max(radius_, (v - centre()).norm() + tool_local_.back().radius);
  }
  tool_.resize(tool_local_.size());
  trial_.resize(tool_local_.size());
  for (const Body& body : scene.bodies) {
    for (const Shape& shape : body.pieces) {
      bodies_.emplace_back();
      place(core_of(shape), body.X_WB, bodies_.back());
      for (size_t i = 0; i < scene.tool.pieces.size(); ++i)
        if (may_touch(scene.tool.pieces[i], shape)) tracked_.push_back({.above = i, .below = bodies_.size() - 1});
    }
  }
}

bool SeparatedTool::start(const Pose& X_WH) {
  for (Tracked& pair : tracked_) pair = {.above = pair.above, .below = pair.below};
  X_WH_ = X_WH;
  move_to(X_WH);
  update_near();
  for (const PlanePair& pair : near_)
    if (gap_along(*pair.above, *pair.below, pair.n) < -kShallow) return false;
  return follow(X_WH);
}

void SeparatedTool::move_to(const Pose& X_WP) {
  X_WP_ = X_WP;
  for (size_t i = 0; i < tool_.size(); ++i) place(tool_local_[i], X_WP, tool_[i]);
}

double SeparatedTool::way(const Vector6& displacement) const noexcept {
  return displacement.head<3>().norm() + radius_ * displacement.tail<3>().norm();
}

Wrench SeparatedTool::wrench() const {
  const Vector6 stretch = displacement(X_WH_, X_WP_, centre());
  const double k = parameters_.stiffness, l2 = parameters_.metric_length * parameters_.metric_length;
  return {k * stretch.head<3>(), k * l2 * stretch.tail<3>()};
}

bool SeparatedTool::touches() const noexcept {
  return std::any_of(near_.begin(), near_.end(), [](const PlanePair& pair) { return pair.load > kTouch; });
}

// Whether a step could bring the pair into touch. A pair that comes near gets the plane that keeps it apart widest.
bool SeparatedTool::is_close(Tracked& pair) {
  const ConvexCore &above = tool_[pair.above], &below = bodies_[pair.below];
  const double reach = kReach + parameters_.skin;
  if (!above.box.enlarged(reach).overlaps(below.box)) return pair.has_plane = false;
  if (pair.has_plane && gap_along(above, below, pair.n) > reach) return false;
  if (pair.has_plane && pair.is_near) return true;
  pair.n = widest_gap_normal(above, below);
  pair.has_plane = true;
  return gap_along(above, below, pair.n) <= reach;
}

void SeparatedTool::update_near() {
  near_.clear();
  near_index_.clear();
  for (size_t i = 0; i < tracked_.size(); ++i) {
    Tracked& pair = tracked_[i];
    pair.is_near = is_close(pair);
    if (!pair.is_near) {
      pair.load = pair.slack = 0.0;
      pair.load_moment.setZero();
      continue;
    }
    near_.push_back({&tool_[pair.above], &bodies_[pair.below], pair.n, pair.load, pair.load_moment, pair.slack});
    near_index_.push_back(i);
  }
}

void SeparatedTool::remember(std::span<const PlanePair> pairs) {
  for (size_t j = 0; j < pairs.size(); ++j) {
    Tracked& pair = tracked_[near_index_[j]];
    pair.n = pairs[j].n;
    pair.load = pairs[j].load;
    pair.load_moment = pairs[j].load_moment;
    pair.slack = pairs[j].slack;
  }
}

void SeparatedTool::place_trial(const Pose& X_WP) {
  for (size_t i = 0; i < trial_.size(); ++i) place(tool_local_[i], X_WP, trial_[i]);
}

// The gap that the pair's plane proves where the tool is tried.
double SeparatedTool::trial_gap(const PlanePair& pair) const {
  return gap_along(trial_[static_cast<size_t>(pair.above - tool_.data())], *pair.below, pair.n);
}

// What is minimised, over the stiffness, m^2. Leaves the tool's pieces at `X_WP` in `trial_`.
double SeparatedTool::value_at(const Pose& X_WP, const Pose& X_WH, std::span<const PlanePair> pairs) {
  const Vector6 stretch = displacement(X_WH, X_WP, centre());
  const double l2 = parameters_.metric_length * parameters_.metric_length;
  double value = 0.5 * (stretch.head<3>().squaredNorm() + l2 * stretch.tail<3>().squaredNorm());
  place_trial(X_WP);
  for (const PlanePair& pair : pairs) {
    const double violation = std::max(0.0, parameters_.skin - trial_gap(pair));
    value += 0.5 * kViolationWeight * violation * violation;
  }
  return value;
}

// Where the hand is near and nothing is in its way, the tool is there exactly.
bool SeparatedTool::jump_to_hand(const Pose& X_WH) {
  if (way(displacement(X_WP_, X_WH, centre())) > kTrust) return false;
  place_trial(X_WH);
  for (const PlanePair& pair : near_)
    if (trial_gap(pair) < parameters_.skin) return false;
  for (Tracked& pair : tracked_) {
    pair.load = pair.slack = 0.0;
    pair.load_moment.setZero();
  }
  move_to(X_WH);
  update_near();
  return true;
}

// Whether the planes that carry load stand still, and keep the tool, on trial, as far from the bodies as they promise.
bool SeparatedTool::planes_hold(std::span<const PlanePair> pairs) const {
  for (size_t j = 0; j < pairs.size(); ++j) {
    const PlanePair& pair = pairs[j];
    if (trial_gap(pair) < parameters_.skin - pair.slack - kConverged) return false;
    if (pair.load > kTouch && (pair.n - near_[j].n).norm() > kPlaneTurn) return false;
  }
  return true;
}

// The program at the present pose. Its pairs, with their planes turned, replace `pairs`.
SeparationStep SeparatedTool::next_step(const Pose& X_WH, double trust, std::vector<PlanePair>& pairs) {
  ++programs_;
  pairs = near_;
  return separation_step({.centre_W = X_WP_ * centre(),
                          .to_hand = displacement(X_WP_, X_WH, centre()),
                          .metric_length = parameters_.metric_length,
                          .tool_radius = radius_,
                          .skin = parameters_.skin,
                          .trust = trust},
                         pairs);
}

bool SeparatedTool::follow(const Pose& X_WH) {
  double trust = std::clamp(kTrustOfWay * way(displacement(X_WH_, X_WH, centre())), kFirstTrust, kTrust);
  X_WH_ = X_WH;
  std::vector<PlanePair> pairs;
  for (int program = 0; program < kPrograms; ++program) {
    update_near();
    if (jump_to_hand(X_WH)) return true;
    const SeparationStep step = next_step(X_WH, trust, pairs);
    if (!step.converged) return false;
    const double before = value_at(X_WP_, X_WH, near_);
    const Pose X_WN = displaced(X_WP_, X_WP_ * centre(), step.move.head<3>(), step.move.tail<3>());
    const double after = value_at(X_WN, X_WH, pairs);
    if (after > before + rounding_of(before, pairs) && trust > kLeastTrust) {
      ++refused_;
      trust *= kShrink;
      continue;
    }
    const bool bounded = way(step.move) > kAtBound * trust;
    const bool settled = !bounded && way(step.move) < kConverged && planes_hold(pairs);
    move_to(X_WN);
    remember(pairs);
    if (settled) {
      update_near();
      return true;
    }
    if (bounded) trust = std::min(kTrust, kGrow * trust);
  }
  return false;
}

}  // namespace tegotae
