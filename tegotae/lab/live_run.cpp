// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/live_run.hpp>

#include <tegotae/device/simulated_presets.hpp>
#include <tegotae/lab/experiment.hpp>
#include <tegotae/lab/free_body_stiffness.hpp>
#include <tegotae/lab/input_error.hpp>
#include <tegotae/lab/numeric_setting.hpp>
#include <tegotae/lab/physics_rate.hpp>
#include <tegotae/lab/session.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace tegotae {
namespace {

SettingsRequest request_of(const LiveScene& scene, const MujocoWorld& world, const SettingsRequest& wanted) {
  const SettingsRequest of_scene = settings_of(world.haptic_settings(), scene.file);
  if (scene.experiment == nullptr) return wanted.or_else(of_scene);
  const Experiment& experiment = *scene.experiment;
  return wanted.or_else(experiment.variants.front().settings).or_else(experiment.settings).or_else(of_scene);
}

// What the method has no use for is left out.
SettingsRequest fitting(SettingsRequest request) {
  const std::string method = request.method.value_or(SessionSettings{}.method);
  if (!has_constraint_set(method)) request.constraint_set.reset();
  for (const NumericSetting& setting : numeric_settings()) {
    if (setting.of_proxy && method != "proxy") (request.*setting.field).reset();
  }
  return request;
}

std::optional<Trajectory> motion_of(const LiveScene& scene, const Tool& tool) {
  if (scene.experiment == nullptr) return std::nullopt;
  return scene.experiment->motion(tool);
}

const NumericSetting& setting_called(std::string_view name) {
  for (const NumericSetting& setting : numeric_settings()) {
    if (setting.name == name) return setting;
  }
  throw InputError(fmt::format("there is no setting '{}'.", name));
}

}  // namespace

LiveRun::LiveRun(const LiveScene& scene, const SettingsRequest& wanted, HapticInterface* device)
    : scene_(scene),
      device_(device),
      world_(load_mujoco_world(scene.file, scene.tool)),
      highest_physics_rate_(
          measured_physics_rate(*world_, wanted.haptic_rate.value_or(SessionSettings{}.haptic_rate)).rate),
      in_hand_(scene.experiment == nullptr),
      of_scene_(request_of(scene, *world_, {})),
      request_(request_of(scene, *world_, wanted)),
      settings_(decide(request_)),
      warnings_(scene_warnings(*world_, scene.file)),
      physics_(*world_, {1.0 / settings_.physics_rate, settings_.margin}, needs_of(settings_.make_method(geometry()))),
      haptics_(settings_.make_method(geometry()), geometry().tool,
               safety_limits_of(settings_, interface(), geometry().tool), 1.0 / settings_.haptic_rate,
               settings_.workspace) {
  warn_of_reductions();
  if (device_ != nullptr) {
    // Its time goes on where the run is paused, and then it is told zero.
    link_.interface_waits = false;
    if (scene.experiment == nullptr) return;
    throw InputError(
        fmt::format("the experiment '{}' plays a motion of its own, and {} is in somebody's hand; perform "
                    "it without the device: tegotae experiment {}.",
                    scene.experiment->name, interface().name, scene.experiment->name));
  }
  hand_.emplace(geometry().tool.X_WT, simulated_device("page"), simulated_hand("moderate"),
                motion_of(scene, geometry().tool));
}

void LiveRun::warn_of_reductions() {
  const auto warn = [this](const char* what, const std::optional<double>& asked, double got, const char* unit) {
    if (!asked || got >= *asked * (1.0 - 1e-9)) return;
    warnings_.push_back(
        fmt::format("the {} of {:g} {} is more than {} or what moves in the scene bears: rendered with {:g}.", what,
                    *asked, unit, interface().name, got));
  };
  warn("stiffness", request_.stiffness, settings_.stiffness, "N/m");
  warn("damping", request_.damping, settings_.damping, "N s/m");
  if (request_.metric_length.value_or(0.0) > 0.0) {
    warn("metric length", request_.metric_length, settings_.metric_length, "m");
  }
}

SessionSettings LiveRun::decide(const SettingsRequest& request) const {
  SettingsRequest complete = fitting(request);
  if (!complete.physics_rate) complete.physics_rate = highest_physics_rate_;
  SessionSettings settings = decide_settings(complete, geometry().tool);
  settings.gravity = world_->gravity();
  settings.workspace.from_first_pose = device_ != nullptr;
  return held_to_bodies(held_to_rating(settings, interface()), geometry());
}

InterfaceCapability LiveRun::interface() const {
  if (device_ != nullptr) return device_->capability();
  return in_hand_ ? simulated_device("page").capability : PlaybackInterface::default_capability();
}

bool LiveRun::hand_took_over() {
  if (in_hand_ || is_playing_exactly()) return false;
  in_hand_ = true;
  change(request_);
  return true;
}

RealtimeReport LiveRun::run(const std::atomic<bool>& stop, const RealtimeObserver& observer,
                            std::function<void()> on_pass,
                            std::function<void(const RealtimeRights&, const RealtimeRights&)> on_rights) {
  link_.on_rights = std::move(on_rights);
  constexpr double kWithoutEnd = 1e9;  // s
  link_.on_pass = std::move(on_pass);
  HapticInterface& held = device_ != nullptr ? *device_ : *hand_;
  return run_realtime(physics_, haptics_, held, 1.0 / settings_.haptic_rate, kWithoutEnd, stop, observer, &link_);
}

void LiveRun::set(std::string_view name, std::optional<double> value) {
  const NumericSetting& setting = setting_called(name);
  SettingsRequest next = request_;
  next.*setting.field = value ? value : of_scene_.*setting.field;
  if (value) check_range(setting, *value);
  if (setting.of_interface) {
    throw InputError(fmt::format("the {} is set when the program starts.", name));
  }
  if (name == "haptic_rate") {
    throw InputError("the haptic rate is set when the program starts: --haptic-rate.");
  }
  if (setting.of_proxy && settings_.method != "proxy") {
    throw InputError(fmt::format("the method '{}' has no {}; take method 'proxy'.", settings_.method, name));
  }
  if (name == "physics_rate" && value && *value > highest_physics_rate_) {
    throw InputError(
        fmt::format("the scene affords a physics rate of at most {:g} Hz on this machine.", highest_physics_rate_));
  }
  if (value) check_bodies_bear(name, *value, geometry(), settings_.physics_rate);
  if (name == "metric_length") next.rotational_stiffness.reset();
  if (name == "rotational_stiffness") next.metric_length.reset();
  change(next);
}

void LiveRun::set_method(std::string_view name) {
  SettingsRequest next = request_;
  next.method = std::string(name);
  change(next);
}

void LiveRun::change(const SettingsRequest& request) {
  try {
    const SessionSettings next = decide(request);
    auto method = std::make_unique<RenderingMethod>(next.make_method(geometry()));
    const PhysicsUpdate physics{{1.0 / next.physics_rate, next.margin}, needs_of(*method)};
    link_.haptic_updates.give({std::move(method), safety_limits_of(next, interface(), geometry().tool)});
    link_.physics_updates.write(physics);
    settings_ = next;
    request_ = request;
  } catch (const std::invalid_argument& error) {
    throw InputError(error.what());
  }
}

void LiveRun::step() noexcept { link_.grant_step(1.0 / settings_.physics_rate, 1.0 / settings_.haptic_rate); }

LiveHand& LiveRun::guided_hand() {
  if (!hand_) throw InputError(fmt::format("{} is the hand; the page cannot move the tool.", interface().name));
  return *hand_;
}

void LiveRun::guide(const Pose& X_WT) {
  LiveHand& hand = guided_hand();
  hand.interrupt();
  hand.guide().guide(X_WT);
}

void LiveRun::play(Trajectory script) {
  LiveHand& hand = guided_hand();
  hand.interrupt();
  hand.guide().play(std::move(script));
}

void LiveRun::stop_motion() {
  LiveHand& hand = guided_hand();
  hand.interrupt();
  hand.guide().stop();
}

std::optional<Pose> LiveRun::intended() {
  if (!hand_ || hand_->is_playing_exactly()) return std::nullopt;
  return hand_->guide().intended();
}

const ContactView& LiveRun::contacts() {
  link_.contacts.update();
  return link_.contacts.get();
}

const MovingBodies& LiveRun::bodies() {
  link_.bodies.update();
  return link_.bodies.get();
}

std::vector<std::string> LiveRun::notes() const {
  std::vector<std::string> lines = notes_of(settings_, geometry().tool);
  lines.insert(lines.begin(),
               fmt::format("{}: {}", scene_.experiment != nullptr ? "experiment" : "scene", scene_.name));
  return lines;
}

std::string LiveRun::trouble() const { return trouble_of(world_->diagnostics()); }

}  // namespace tegotae
