// SPDX-License-Identifier: Apache-2.0
#include <tegotae/render/receding_bodies.hpp>
#include <tegotae/runtime/haptic_tick.hpp>

#include <algorithm>
#include <limits>
#include <utility>

namespace tegotae {
namespace {

std::span<const NearBody> bodies_near(const IntermediateRepresentation& model) noexcept {
  return {model.bodies.data(), static_cast<size_t>(model.body_count)};
}

}  // namespace

HapticTick::HapticTick(RenderingMethod method, const Tool& tool, const SafetyLimits& limits, double period)
    : method_(std::make_unique<RenderingMethod>(std::move(method))),
      p_TCm_(tool.mass.centre_of_mass),
      limits_(limits),
      length_(tool.mass.gyration_length()),
      period_(period),
      dt_(period) {
  state_.X_WT = tool.X_WT;
  rendered_.X_WP = tool.X_WT;
}

InterfaceCommand HapticTick::operator()(const InterfaceState& state, const IntermediateRepresentation* fresh,
                                        const Circumstances& circumstances, TickRecord& record) noexcept {
  dt_ = elapsed_until(state.time);
  state_ = held(state, circumstances.interface_lost);
  const IntermediateRepresentation& model = model_at(state_.time, fresh);
  model_ = &model;

  const Vector3 p_WCm = state_.X_WT * p_TCm_;
  const Vector3 arm = p_WCm - state_.X_WT.p;
  render(*method_, {model, state_.X_WT, dt_}, rendered_);
  yield_to_receding(bodies_near(model), {state_.V_WT.at(arm), state_.V_WT.angular}, p_WCm, rendered_);
  if (!pose_valid_) {
    rendered_.wrench = {};
    rendered_.status = RenderStatus::kInvalidInput;
  }

  const SafetyOutput safe = limit(model, state_.time, arm, circumstances);
  const Wrench displayed = safe.displayed.shifted(-arm);  // about the centre of mass
  push_bodies(model, displayed, p_WCm);

  record.safety_events = safe.events;
  write(model, displayed, record);
  ++tick_count_;
  return {safe.displayed, 0.0};
}

// The period, or more where ticks were missed; never more than a tenth of a second, after which nothing that was is
// worth continuing.
double HapticTick::elapsed_until(double time) noexcept {
  constexpr double kLongest = 0.1;  // s
  const double since = tick_count_ > 0 ? time - state_.time : period_;
  // Within half a period it is the period: the clock's jitter is no change of rate.
  return since > 1.5 * period_ ? std::min(since, kLongest) : period_;
}

// A pose that is not finite, or an interface that is lost: the hand is where it was last seen, and nothing is
// displayed.
InterfaceState HapticTick::held(const InterfaceState& state, bool interface_lost) noexcept {
  InterfaceState result = state_;
  result.time = state.time;
  pose_valid_ =
      state.X_WT.is_finite() && state.V_WT.is_finite() && state.X_WT.q.squaredNorm() > 0.25 && !interface_lost;
  if (!pose_valid_) {
    result.V_WT = {};
    return result;
  }
  result = state;
  result.X_WT.q.normalize();
  return result;
}

// Between two models the contact state is taken to change linearly, over the period of the newest; for a method that
// holds its model it is the newest's.
const IntermediateRepresentation& HapticTick::model_at(double time, const IntermediateRepresentation* fresh) noexcept {
  if (fresh != nullptr) {
    interpolator_.accept(*fresh);
    model_arrival_ = time;
  }
  const double period = holds_model(*method_) ? 0.0 : interpolator_.newest_period();
  return interpolator_.at(period > 0.0 ? (time - model_arrival_) / period : 1.0);
}

SafetyOutput HapticTick::limit(const IntermediateRepresentation& model, double time, const Vector3& arm,
                               const Circumstances& circumstances) noexcept {
  SafetyInput input;
  input.target = rendered_.wrench.shifted(arm);  // about the grip
  input.elapsed = dt_;
  input.model_age = model.sequence > 0 ? time - model.time : std::numeric_limits<double>::infinity();
  input.interface_lost = circumstances.interface_lost;
  input.ending = circumstances.ending;
  return apply_safety(limits_, safety_, input);
}

void HapticTick::push_bodies(const IntermediateRepresentation& model, const Wrench& displayed,
                             const Vector3& p_WCm) noexcept {
  rendered_.bodies.share(displayed, p_WCm, length_, bodies_near(model), model.period);
  for (const BodyWrench& body : rendered_.bodies.moving()) {
    impulses_.add(body.moving_index, body.on_body.shifted(body.p_WC), dt_);  // about the world's origin
  }
}

void HapticTick::write(const IntermediateRepresentation& model, const Wrench& displayed,
                       TickRecord& record) const noexcept {
  record.time = state_.time;
  record.X_WT = state_.X_WT;
  record.wrench = rendered_.wrench;
  record.displayed = displayed;
  record.X_WP = rendered_.X_WP;
  record.deepest = rendered_.deepest;
  record.model_age = state_.time - model.time;
  record.model_sequence = model.sequence;
  record.near_objects = model.near_object_count;
  record.planes = model.plane_count;
  record.contact_points = model.point_count;
  record.constraints = rendered_.constraint_count;
  record.active = rendered_.active_count;
  record.solver_iterations = rendered_.solver_iterations;
  record.dropped = model.dropped_planes + model.dropped_points + model.dropped_pairs + rendered_.skipped_pairs;
  record.status = static_cast<std::uint8_t>(rendered_.status);
}

void HapticTick::adopt(HapticUpdate& update) noexcept {
  limits_ = update.limits;
  if (!adopt_or_start(*method_, *update.method, rendered_.X_WP, state_.X_WT)) std::swap(method_, update.method);
}

void HapticTick::view(ContactView& view) const noexcept {
  view.clear();
  if (model_ == nullptr) return;
  view_contacts(*method_, {*model_, state_.X_WT, dt_}, rendered_, view);
  view.time = state_.time;
}

void HapticTick::fill(ImpulseSums& message, int body_count) const noexcept {
  message.sequence = tick_count_;
  message.time = state_.time;
  message.X_WT = state_.X_WT;
  message.V_WT = state_.V_WT;
  message.X_WP = rendered_.X_WP;
  impulses_.fill(message, body_count);
}

}  // namespace tegotae
