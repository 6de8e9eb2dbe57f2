// SPDX-License-Identifier: Apache-2.0
#include <tegotae/render/proxy_method.hpp>

#include <tegotae/math/rotation.hpp>
#include <tegotae/render/tolerances.hpp>

#include <algorithm>
#include <cmath>

namespace tegotae {
namespace {

constexpr int kMaxRows = 4096;
constexpr int kMaxFrictionBlocks = 2 * kMaxNearBodies;

double skin_of(const Coupling& coupling) noexcept {
  return std::min(tolerance::kSkin, tolerance::kSkinForce / coupling.stiffness);
}

}  // namespace

ProxyMethod::ProxyMethod(const Parameters& parameters, const SceneGeometry& geometry)
    : parameters_(parameters),
      mass_(geometry.tool.mass),
      skin_(skin_of(parameters.coupling)),
      tracker_(geometry, {parameters.friction, parameters.friction_scale, parameters.kinetic_friction,
                          parameters.viscous_friction, tolerance::kBristleCompliance / parameters.coupling.stiffness}),
      problem_(kMaxRows, kMaxFrictionBlocks),
      workspace_(problem_),
      solution_(problem_),
      transient_(parameters.transient) {
  rows_.reserve(kMaxRows);
  blocks_.reserve(kMaxFrictionBlocks);
  patch_.reserve(kMaxPatchCorners);
}

void ProxyMethod::reset() noexcept {
  started_ = touched_ = false;
  tracker_.reset();
  workspace_.reset();
  transient_.reset();
}

void ProxyMethod::adopt(const ProxyMethod& other) noexcept {
  parameters_ = other.parameters_;
  skin_ = other.skin_;
  tracker_.adopt_friction(other.tracker_);
  transient_ = other.transient_;
}

void ProxyMethod::start_at(const Pose& X_WP, const Pose& X_WT) noexcept {
  reset();
  start(X_WP, X_WT);
}

void ProxyMethod::start(const Pose& X_WP, const Pose& X_WT) noexcept {
  X_WP_ = X_WP;
  X_WT_before_ = X_WT;
  moved_before_.setZero();
  displacement_before_ = displacement(X_WT, X_WP, mass_.centre_of_mass);
  started_ = true;
}

void ProxyMethod::render(const RenderInput& input, RenderOutput& output) noexcept {
  output.bodies.clear();
  output.wrench = {};
  output.X_WP = started_ ? X_WP_ : input.X_WT;
  output.constraint_count = output.active_count = output.solver_iterations = 0;
  output.linearisations = output.skipped_pairs = 0;
  output.deepest = 0.0;
  output.pushing_out = false;
  if (!admit(input, output)) return;

  tracker_.take(input.model, X_WP_);
  X_WP_start_ = X_WP_;
  push_out_ = tolerance::kPushOutSpeed * input.dt;
  left_out_ = 0;
  double margin = first_margin(input);
  for (bool settled = false; !settled && output.linearisations < tolerance::kLinearisations;) {
    ++output.linearisations;
    settled = linearise(input, margin, output);
  }
  display(input, output);
}

bool ProxyMethod::admit(const RenderInput& input, RenderOutput& output) noexcept {
  output.status = input.model.sequence == 0 ? RenderStatus::kNoModel : RenderStatus::kOk;
  if (!input.X_WT.is_finite()) output.status = RenderStatus::kInvalidInput;
  if (output.status != RenderStatus::kOk) return false;
  if (!started_) start(input.X_WT, input.X_WT);
  return true;
}

// Points beyond the hand's own way in this tick, and that of the bodies, are seldom needed, and on finely curved tools
// there are many. Where hand or bodies outrun all linearisations of a tick, at the margin that was asked for, these get
// a greater one, so that the proxy does not stay behind.
double ProxyMethod::first_margin(const RenderInput& input) noexcept {
  const double way = way_of(displacement(X_WT_before_, input.X_WT, mass_.centre_of_mass)) + tracker_.bodies_way();
  margin_limit_ = std::max(parameters_.margin, tolerance::kMarginLimitOfWay * way);
  return std::clamp(tolerance::kMarginOfWay * way, std::min(tolerance::kLeastMargin, margin_limit_), margin_limit_);
}

// One linearisation about the proxy's present pose. True if another one would move it no more than a settled step.
// Where `margin` held it back it grows for the next one.
bool ProxyMethod::linearise(const RenderInput& input, double& margin, RenderOutput& output) noexcept {
  const Vector3 p_WCm = X_WP_ * mass_.centre_of_mass;
  const Pose X_WP_solved = X_WP_;
  const double least = tracker_.measure(X_WP_, margin);
  const double reach = margin + std::max(least, 0.0);
  set_objective(input);
  to_hand_ = displacement(X_WP_, input.X_WT, mass_.centre_of_mass);

  rows_.clear();
  blocks_.clear();
  Vector6 x = problem_.x_free();
  if (way_of(x) + skin_ > least) {
    collect_rows(reach);
    x = solve(input, p_WCm, output);
  }
  if (!x.allFinite()) return true;
  const double stretch = way_of(problem_.x_free()), way = way_of(x);
  if (way > reach) x *= reach / way;
  predict(x);
  const double moved = step(x, p_WCm);
  const double load_change = take_loads(X_WP_solved);
  const bool bounded = moved < way - tolerance::kSettledStep;
  if (bounded) {
    margin = std::min(margin_limit_, tolerance::kMarginGrowth * margin);
    return moved == 0.0;
  }
  if (moved < tolerance::kSettledStep) return true;
  return is_settled(stretch) && load_change < tolerance::kSettledLoad &&
         way_of_turned_arms(x, p_WCm) < tolerance::kSettledArms;
}

// The spring to the interface; with the tool's weight its rest lies lower, with its inertia a second spring, of
// stiffness M / dt^2, pulls to where the proxy would coast to.
void ProxyMethod::set_objective(const RenderInput& input) noexcept {
  Matrix6 K = parameters_.coupling.stiffness_matrix();
  Vector6 x_free = displacement(X_WP_, input.X_WT, mass_.centre_of_mass);
  if (parameters_.weight) x_free.head<3>() += mass_.mass / parameters_.coupling.stiffness * parameters_.gravity;
  if (parameters_.inertia) {
    const Matrix3 R_WP = X_WP_.rotation();
    Matrix6 M = Matrix6::Zero();
    M.topLeftCorner<3, 3>() = mass_.mass * Matrix3::Identity();
    M.bottomRightCorner<3, 3>() = R_WP * mass_.inertia * R_WP.transpose();
    M /= input.dt * input.dt;
    const Vector6 coasting = moved_before_ - displacement(X_WP_start_, X_WP_, mass_.centre_of_mass);
    const Vector6 pull = K * x_free + M * coasting;
    K += 0.5 * (M + M.transpose());
    x_free = K.ldlt().solve(pull);
  }
  problem_.set_objective(K, x_free);
}

Vector6 ProxyMethod::solve_filled(const RenderInput& input, const Vector3& p_WCm, bool push_out,
                                  RenderOutput& output) noexcept {
  const int former_count = problem_.contact_count();
  fill_problem(input, p_WCm, push_out);
  // The solver remembers which rows were active by their number: of other rows that would lead it astray.
  if (problem_.contact_count() != former_count) workspace_.reset();
  // In the first linearisation the tool is likely to go on as it did in the last tick.
  solver_.solve(problem_, output.linearisations > 1 ? Vector6(Vector6::Zero()) : moved_before_, workspace_, solution_);
  output.solver_iterations += solution_.newton_iterations;
  output.constraint_count = problem_.contact_count();
  output.skipped_pairs += problem_.dropped_count();
  if (solution_.status == ConstraintStatus::kIterationLimit) output.status = RenderStatus::kIterationLimit;
  if (solution_.status == ConstraintStatus::kInvalidInput) output.status = RenderStatus::kInvalidInput;
  return solution_.x;
}

// Inside something, the way out is gone at a bounded speed: of the difference between the solution that leaves it and
// the one that goes no deeper only so much. Both have the same solution once no way out is left (opposed walls).
Vector6 ProxyMethod::solve(const RenderInput& input, const Vector3& p_WCm, RenderOutput& output) noexcept {
  Vector6 out = solve_filled(input, p_WCm, true, output);
  if (!is_inside()) return out;
  const Vector6 no_deeper = solve_filled(input, p_WCm, false, output);
  const Vector6 push = out - no_deeper;
  const double way = way_of(push);
  const double share = way > push_out_ ? push_out_ / way : 1.0;
  push_out_ -= share * way;
  output.pushing_out = share < 1.0;
  if (share == 1.0) return solve_filled(input, p_WCm, true, output);
  return no_deeper + share * push;
}

// Moves the proxy by x, or by the greatest half, quarter, ... of it that the geometry allows.
double ProxyMethod::step(const Vector6& x, const Vector3& p_WCm) noexcept {
  double share = 1.0;
  for (int halving = 0; halving <= tolerance::kHalvings; ++halving, share *= 0.5) {
    const double way = share * way_of(x);
    const Pose X_WP = displaced(X_WP_, p_WCm, share * x.head<3>(), share * x.tail<3>());
    if (!tracker_.examine(X_WP, way, skin_)) continue;
    tracker_.accept(way);
    for (NearContact& contact : tracker_.contacts()) {
      contact.bristle.follow_tool(contact.friction, X_WP_, X_WP, contact.X_WB, contact.now.n_W);
    }
    X_WP_ = X_WP;
    return way;
  }
  return 0.0;
}

// Whether the contacts at the new pose are those that the linear model foresaw: gaps, normals and loads.
bool ProxyMethod::is_settled(double stretch) noexcept {
  const auto contacts = tracker_.contacts();
  return std::all_of(contacts.begin(), contacts.end(), [stretch, skin = skin_](const NearContact& contact) {
    if (!contact.tried) return true;
    if (contact.predicted == NearContact::kNoRows) return contact.now.gap > skin - tolerance::kSettledStep;
    return std::abs(contact.now.gap - contact.predicted) < tolerance::kSettledStep &&
           contact.turned * stretch < tolerance::kSettledStep;
  });
}

// m of a tool point: how far the torque that the loads have gained, as the solved rotation turned their arms, would
// still take the tool. Felt in rolling, where an arm is short and the turn is not.
double ProxyMethod::way_of_turned_arms(const Vector6& x, const Vector3& p_WCm) const noexcept {
  if (rows_.empty()) return 0.0;
  Vector3 gained = Vector3::Zero();
  for (const int active : solution_.active_rows) {
    const auto row = static_cast<size_t>(active);
    const Vector3 n_W = problem_.J(active).head<3>();
    gained += solution_.multipliers[row] * x.tail<3>().cross(rows_[row].p_W - p_WCm).cross(n_W);
  }
  const double l2 = parameters_.coupling.metric_length * parameters_.coupling.metric_length;
  return gained.norm() / (parameters_.coupling.stiffness * l2) * tracker_.tool_radius();
}

void ProxyMethod::display(const RenderInput& input, RenderOutput& output) noexcept {
  const Vector6 felt = displacement(input.X_WT, X_WP_, mass_.centre_of_mass);
  output.wrench = parameters_.coupling.wrench(felt, displacement_before_, input.dt);
  output.X_WP = X_WP_;
  output.skipped_pairs += tracker_.skipped() + left_out_;
  output.active_count = rows_.empty() ? 0 : static_cast<int>(solution_.active_rows.size());
  output.deepest = deepest_at_hand();
  push_bodies(output);
  feel_impact(input, output);
  displacement_before_ = felt;
  moved_before_ = displacement(X_WP_start_, X_WP_, mass_.centre_of_mass);
  X_WT_before_ = input.X_WT;
}

// By the linear model of the last linearisation.
double ProxyMethod::deepest_at_hand() const noexcept {
  double deepest = 0.0;
  const int count = std::min(static_cast<int>(rows_.size()), problem_.contact_count());
  for (int i = 0; i < count; ++i) {
    deepest = std::max(deepest, -rows_[static_cast<size_t>(i)].gap - problem_.J(i).dot(to_hand_));
  }
  return deepest;
}

void ProxyMethod::feel_impact(const RenderInput& input, RenderOutput& output) noexcept {
  const bool touches = output.active_count > 0;
  if (touches && !touched_ && output.wrench.force.squaredNorm() > 0.0) {
    const Vector3 n_W = output.wrench.force.normalized();
    const Vector6 way = displacement(X_WT_before_, input.X_WT, mass_.centre_of_mass);
    transient_.strike(n_W, std::max(0.0, -n_W.dot(way.head<3>()) / input.dt));
  }
  touched_ = touches;
  output.wrench.force += transient_.advance(input.dt);
}

}  // namespace tegotae
