// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/session.hpp>

#include <tegotae/lab/input_error.hpp>
#include <tegotae/lab/numeric_setting.hpp>
#include <tegotae/lab/tolerances.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace tegotae {
namespace {

const NumericSetting& setting_in_scene(const std::string& name, const std::filesystem::path& file) {
  std::string known;
  for (const NumericSetting& setting : numeric_settings()) {
    if (setting.of_interface) continue;
    if (setting.name == name) return setting;
    known += fmt::format("{}tegotae_{}", known.empty() ? "" : ", ", setting.name);
  }
  throw InputError(
      fmt::format("{}: unknown haptic setting 'tegotae_{}' in <custom>; known are {}.", file.string(), name, known));
}

SessionSettings in_world(SessionSettings settings, const MujocoWorld& world) {
  settings.gravity = world.gravity();
  return settings;
}

}  // namespace

struct Session::Seen {
  ContactView contacts;
  MovingBodies bodies;
  std::vector<BodyState> states;
};

Session::Session(std::unique_ptr<MujocoWorld> world, Trajectory motion, const SessionSettings& settings,
                 std::unique_ptr<ObservedInterface> interface)
    : world_(std::move(world)),
      settings_(in_world(settings, *world_)),
      start_(motion.start()),
      duration_(motion.end() - motion.start()),
      observed_(interface.get()),
      physics_(*world_, {1.0 / settings.physics_rate, settings.margin},
               needs_of(settings_.make_method(world_->geometry()))),
      seen_(std::make_unique<Seen>()) {
  if (duration_ * settings_.haptic_rate > tolerance::kMaxTicks) {
    throw InputError(
        fmt::format("the motion lasts {:g} s, which is {:g} ticks at {:g} Hz; at most {:g} are rendered: "
                    "is its time in seconds?",
                    duration_, duration_ * settings_.haptic_rate, settings_.haptic_rate, tolerance::kMaxTicks));
  }
  truth_.time = -std::numeric_limits<double>::infinity();
  interface_ = std::move(interface);
  if (observed_ == nullptr) interface_ = std::make_unique<PlaybackInterface>(std::move(motion));
  haptics_ =
      std::make_unique<HapticTick>(settings_.make_method(world_->geometry()), tool(),
                                   with_short_ramp(safety_limits_of(settings_, interface_->capability(), tool())),
                                   1.0 / settings_.haptic_rate, settings_.workspace);
}

Session::~Session() = default;

TickObserver Session::with_progress(const TickObserver& observer, const Progress& progress) {
  constexpr long kTicksBetweenReports = 1000;
  return [this, &observer, &progress, ticks = 0L](const TickRecord& record) mutable {
    if (++ticks % kTicksBetweenReports == 0) progress(record.time / duration_);
    if (observed_ == nullptr) return observer(record);
    TickRecord whole = record;
    add_truth(whole);
    return observer(whole);
  };
}

// Of the same tick: in real time, ticks that nobody saw have truths all the same.
void Session::add_truth(TickRecord& record) {
  while (truth_.time < record.time && observed_->take(truth_)) {
  }
  const Vector3 arm = record.X_WT.pose().q * tool().mass.centre_of_mass;
  record.interface_wrench = Wrench(truth_.displayed).shifted(-arm);
  record.X_WH = truth_.X_WH;
  record.falls_short = truth_.falls_short;
}

void Session::run_simulated(const TickObserver& observer, const Progress& progress) {
  link_.reset();
  tegotae::run_simulated(physics_, *haptics_, *interface_, 1.0 / settings_.haptic_rate, duration_,
                         with_progress(observer, progress));
}

RealtimeReport Session::run_realtime(const TickObserver& observer, const Progress& progress,
                                     const std::atomic<bool>& stop) {
  return tegotae::run_realtime(physics_, *haptics_, *interface_, 1.0 / settings_.haptic_rate, duration_, stop,
                               with_progress(observer, progress), link_.get());
}

const ContactView& Session::contacts() {
  if (link_ != nullptr) {
    link_->contacts.update();
    return link_->contacts.get();
  }
  haptics_->view(seen_->contacts);
  return seen_->contacts;
}

const MovingBodies& Session::bodies() {
  if (link_ != nullptr) {
    link_->bodies.update();
    return link_->bodies.get();
  }
  MovingBodies& bodies = seen_->bodies;
  seen_->states.resize(static_cast<std::size_t>(world_->geometry().moving_count));
  world_->read_bodies(seen_->states);
  bodies.time = world_->time();
  bodies.period = physics_.settings().period;
  bodies.steps = static_cast<std::uint64_t>(std::llround(bodies.time / bodies.period));
  bodies.count = static_cast<std::int32_t>(seen_->states.size());
  for (std::size_t i = 0; i < seen_->states.size(); ++i) bodies.poses[i] = seen_->states[i].X_WB;
  return bodies;
}

std::string Session::trouble() const { return trouble_of(world_->diagnostics()); }

std::vector<std::string> Session::notes() const { return notes_of(settings_, tool()); }

SafetyLimits safety_limits_of(const SessionSettings& settings, const InterfaceCapability& interface, const Tool& tool) {
  const WorkspaceSettings& workspace = settings.workspace;
  const double arm = tool.mass.centre_of_mass.norm();
  StrikeAllowance strike;
  strike.grip_arm = workspace.felt_arm(arm);
  SafetyLimits limits = safety_limits(interface, workspace.felt_stiffness(settings.stiffness),
                                      workspace.felt_arm(settings.metric_length), 1.0 / settings.physics_rate, strike);
  limits.period = 1.0 / settings.haptic_rate;
  limits.dead_man_button = settings.dead_man_button;
  limits.energy_bound.on = limits.energy_bound.on && settings.energy_bound;
  // A tool that weighs in the hand is never less than that.
  const double weight = settings.tool_weight ? tool.mass.mass * settings.gravity.norm() : 0.0;
  limits.ramp_below_force += workspace.force_scale * weight;
  limits.ramp_below_torque += workspace.torque_scale() * arm * weight;
  return limits;
}

SessionSettings held_to_rating(SessionSettings settings, const InterfaceCapability& interface) {
  if (settings.beyond_rating) return settings;
  // What is felt of one N/m or N s/m, and of one N m/rad or N m s/rad.
  const double felt = settings.workspace.felt_stiffness(1.0);
  const double felt_turning = settings.workspace.felt_rotational_stiffness(1.0);
  settings.stiffness = std::min(settings.stiffness, interface.max_stiffness / felt);
  const double longest = std::sqrt(interface.max_rotational_stiffness / felt_turning / settings.stiffness);
  settings.metric_length = std::min(settings.metric_length, longest);
  settings.damping = std::min(settings.damping, interface.max_damping / felt);
  const double of_rotation =
      settings.rotational_damping.value_or(settings.damping * settings.metric_length * settings.metric_length);
  const double most = interface.max_rotational_damping / felt_turning;
  if (of_rotation > most) settings.rotational_damping = most;
  // At an impact it is a damper, too.
  settings.transient = std::min(settings.transient, interface.max_damping / felt);
  return settings;
}

std::vector<std::string> notes_of(const SessionSettings& settings, const Tool& tool) {
  std::vector<std::string> lines = settings.lines();
  const Vector3& p_TCm = tool.mass.centre_of_mass;
  lines.push_back(fmt::format("tool: {}", tool.name));
  lines.push_back(fmt::format("centre of mass in the tool's frame: {} {} {} m", p_TCm.x(), p_TCm.y(), p_TCm.z()));
  return lines;
}

std::string trouble_of(const WorldDiagnostics& found) {
  if (found.is_healthy()) return {};
  return fmt::format(
      "the physics had trouble: {} contacts and {} constraint rows dropped, {} near singular inertias, "
      "{} substeps diverged, {} given up, {} impulses ignored{}{}",
      found.dropped_contacts, found.dropped_constraint_rows, found.singular_inertias, found.diverged,
      found.engine_errors, found.ignored_impulses, found.last_message.empty() ? "" : "; it said: ", found.last_message);
}

SettingsRequest settings_of(const std::vector<HapticSettingInScene>& scene, const std::filesystem::path& file) {
  SettingsRequest request;
  for (const auto& [name, value] : scene) {
    const NumericSetting& setting = setting_in_scene(name, file);
    try {
      check_range(setting, value);
    } catch (const InputError& error) {
      throw InputError(fmt::format("{}: the setting 'tegotae_{}' in <custom>: {}", file.string(), name, error.what()));
    }
    request.*setting.field = value;
  }
  if (request.metric_length && request.rotational_stiffness) {
    throw InputError(fmt::format(
        "{}: 'tegotae_metric_length' and 'tegotae_rotational_stiffness' say the same in two ways; give one of them.",
        file.string()));
  }
  return request;
}

std::vector<std::string> scene_warnings(const MujocoWorld& world, const std::filesystem::path& file) {
  std::vector<std::string> warnings;
  for (const std::string& warning : world.warnings()) {
    const bool names_file = warning.find(file.string()) != std::string::npos;
    warnings.push_back(names_file ? warning : fmt::format("{}: {}", file.string(), warning));
  }
  return warnings;
}

}  // namespace tegotae
