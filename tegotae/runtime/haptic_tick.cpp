// SPDX-License-Identifier: Apache-2.0
#include <tegotae/runtime/haptic_tick.hpp>

#include <tegotae/render/receding_bodies.hpp>

#include <algorithm>
#include <limits>
#include <utility>

namespace tegotae {
namespace {

std::span<const NearBody> bodies_near(const IntermediateRepresentation& model) noexcept {
  return {model.bodies.data(), static_cast<size_t>(model.body_count)};
}

bool is_down(std::uint32_t buttons, int button) noexcept {
  return button >= 0 && button < 32 && ((buttons >> static_cast<unsigned>(button)) & 1U) != 0;
}

}  // namespace

HapticTick::HapticTick(RenderingMethod method, const Tool& tool, const SafetyLimits& limits, double period,
                       const WorkspaceSettings& workspace)
    : method_(std::make_unique<RenderingMethod>(std::move(method))),
      p_TCm_(tool.mass.centre_of_mass),
      limits_(limits),
      length_(tool.mass.gyration_length()),
      period_(period),
      mapping_(workspace, tool.X_WT),
      based_(!workspace.from_first_pose),
      X_D_(tool.X_WT),
      X_WT_felt_(tool.X_WT),
      known_from_(-std::numeric_limits<double>::infinity()),
      dt_(period) {
  state_.X_WT = tool.X_WT;
  rendered_.X_WP = tool.X_WT;
}

InterfaceCommand HapticTick::operator()(const InterfaceState& state, const IntermediateRepresentation* fresh,
                                        const Circumstances& circumstances, TickRecord& record) noexcept {
  dt_ = elapsed_until(state.time);
  hold_tool(state, circumstances);
  const IntermediateRepresentation& model = model_at(state_.time, fresh);
  model_ = &model;
  if (model.time >= known_from_) X_WT_felt_ = state_.X_WT;

  const Vector3 p_WCm = X_WT_felt_ * p_TCm_;
  const Vector3 arm = p_WCm - X_WT_felt_.p;
  render(*method_, {model, X_WT_felt_, dt_}, rendered_);
  yield_to_receding(bodies_near(model), {state_.V_WT.at(arm), state_.V_WT.angular}, p_WCm, rendered_);
  if (!pose_valid_) {
    rendered_.wrench = {};
    rendered_.status = RenderStatus::kInvalidInput;
  }

  const SafetyOutput safe = limit(model, state, arm, circumstances);
  const Wrench displayed = mapping_.to_world(safe.displayed).shifted(-arm);  // about the centre of mass
  push_bodies(model, displayed, p_WCm);

  record.safety_events = safe.events;
  write(model, displayed, record);
  ++tick_count_;
  return {safe.displayed, 0.0};
}

// The period, or more where ticks were missed; never more than a tenth of a second, after which nothing that was is
// worth continuing, and at low rates than 25 periods, as the safety stage must see that ticks were missed there too.
double HapticTick::elapsed_until(double time) noexcept {
  constexpr double kLongest = 0.1, kPeriods = 25.0;  // s; twice the default of SafetyLimits::max_missed_ticks
  const double since = tick_count_ > 0 ? time - state_.time : period_;
  // Within half a period it is the period: the clock's jitter is no change of rate.
  return since > 1.5 * period_ ? std::min(since, std::max(kLongest, kPeriods * period_)) : period_;
}

ToolState HapticTick::begin(const InterfaceState& state, bool interface_lost) noexcept {
  Circumstances circumstances;
  circumstances.interface_lost = interface_lost;
  hold_tool(state, circumstances);
  return {state_.X_WT, state_.V_WT};
}

// Without a pose, or with an interface that is lost, the tool stays where it was last. Where the pose is elsewhere
// afterwards the method is not told before a model has come that was made there, so that the proxy passes through
// nothing on its way.
void HapticTick::hold_tool(const InterfaceState& state, const Circumstances& circumstances) noexcept {
  state_.time = state.time;
  state_.V_WT = {};
  moved_.setZero();
  clutched_ = circumstances.clutched || is_down(state.buttons, mapping_.settings().clutch_button);
  if (circumstances.interface_lost || is_gap(limits_, dt_)) guard_.lose();
  const PoseVerdict verdict = circumstances.interface_lost
                                  ? PoseVerdict::kFault
                                  : guard_.judge({limits_.max_speed, limits_.max_turning_speed}, state, dt_);
  pose_valid_ = verdict != PoseVerdict::kFault;
  if (!pose_valid_) return;

  InterfaceState grip = state;
  grip.X_WT.q.normalize();
  if (!based_) mapping_.rebase(grip.X_WT, state_.X_WT);
  if (verdict == PoseVerdict::kMoved) known_from_ = state.time;
  if (verdict == PoseVerdict::kGood && based_) moved_ = displacement(X_D_, grip.X_WT, Vector3::Zero());
  based_ = true;
  X_D_ = grip.X_WT;
  state_ = mapping_.to_world(grip, clutched_);
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

SafetyOutput HapticTick::limit(const IntermediateRepresentation& model, const InterfaceState& state, const Vector3& arm,
                               const Circumstances& circumstances) noexcept {
  SafetyInput input;
  input.target = mapping_.to_device(rendered_.wrench.shifted(arm));  // about the grip
  input.elapsed = dt_;
  input.model_age = model.sequence > 0 ? state_.time - model.time : std::numeric_limits<double>::infinity();
  input.pose_age = circumstances.pose_age;
  input.pushing_out = rendered_.pushing_out;
  input.pose_fault = !pose_valid_ || model.time < known_from_;
  input.clutched = clutched_;
  input.enabled = limits_.dead_man_button < 0 || is_down(state.buttons, limits_.dead_man_button);
  input.interface_lost = circumstances.interface_lost;
  input.ending = circumstances.ending;
  input.moved = moved_;
  measure_spring(input);
  return apply_safety(limits_, safety_, input);
}

// How far the coupling between hand and tool is stretched, as felt. A method whose tool is simply where the hand holds
// it has springs elsewhere: then what one coupling of the same wrench would be.
void HapticTick::measure_spring(SafetyInput& input) noexcept {
  const WorkspaceSettings& scales = mapping_.settings();
  const Vector6 e = displacement(X_WT_felt_, rendered_.X_WP, p_TCm_);
  input.stretch = e.head<3>().norm() / scales.translation_scale;
  input.turn = e.tail<3>().norm() / scales.rotation_scale;
  Vector6 offset = displacement(rendered_.X_WP, X_WT_felt_, Vector3::Zero());
  offset.head<3>() /= scales.translation_scale;
  offset.tail<3>() /= scales.rotation_scale;
  input.stretched = offset - offset_;
  offset_ = offset;
  if (input.stretch != 0.0 || input.turn != 0.0) return;
  input.stretched = input.moved;
  const Wrench felt = mapping_.to_device(rendered_.wrench);
  const double stiffness = limits_.energy_bound.stiffness, length = limits_.energy_bound.metric_length;
  input.stretch = felt.force.norm() / stiffness;
  input.turn = felt.torque.norm() / (stiffness * length * length);
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
  safety_.calm_for = limits_.calm_time;
  if (!adopt_or_start(*method_, *update.method, rendered_.X_WP, X_WT_felt_)) std::swap(method_, update.method);
}

void HapticTick::view(ContactView& view) const noexcept {
  view.clear();
  if (model_ == nullptr) return;
  view_contacts(*method_, {*model_, X_WT_felt_, dt_}, rendered_, view);
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
