// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/device/live_hand.hpp>
#include <tegotae/lab/session_settings.hpp>
#include <tegotae/runtime/realtime_session.hpp>
#include <tegotae/world/mujoco_world.hpp>

#include <atomic>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tegotae {

struct Experiment;

/// What a live run shows: a scene with a tool for the hand, or an experiment.
struct LiveScene {
  std::string name;                        ///< for people
  std::filesystem::path file;              ///< MJCF or URDF
  std::string tool = "tool";               ///< body in the hand
  const Experiment* experiment = nullptr;  ///< whose motion is played first; null: none
};

/// One run of a scene in real time, from its first state: world, both loops, and a device in somebody's hand, or else a
/// simulated hand and interface that a person guides. What steers it is called from the thread that `run` is called on
/// (its observer, its `on_pass`).
class LiveRun {
 public:
  /// `wanted` wins over the experiment's settings, these over the scene's. A physics rate that nobody set is the
  /// highest that the scene affords on this machine. `device`, which must outlive the run, is what the hand holds;
  /// null: the simulated one. Throws InputError, also for an experiment on a device: its motion is played by a
  /// simulated hand; SceneError.
  LiveRun(const LiveScene& scene, const SettingsRequest& wanted, HapticInterface* device = nullptr);

  /// Runs until `stop` becomes true, `end` is called, the observer says so, or the physics fails. `on_rights`: see
  /// LiveLink.
  RealtimeReport run(const std::atomic<bool>& stop, const RealtimeObserver& observer, std::function<void()> on_pass,
                     std::function<void(const RealtimeRights&, const RealtimeRights&)> on_rights = {});

  // Steering.

  /// Changes one setting from the next tick or step on; no value: the scene's or the default. Throws InputError, and
  /// then nothing has changed. Stiffness and damping are held to what interface and moving bodies bear: `settings` says
  /// what holds.
  void set(std::string_view name, std::optional<double> value);
  /// Another method; settings that it does not have are kept for the next one that has them. Throws InputError.
  void set_method(std::string_view name);
  void pause(bool paused) noexcept { link_.pause(paused); }
  bool is_paused() const noexcept { return link_.paused.load(std::memory_order_relaxed); }
  /// Lets a paused run go on for one period of the physics.
  void step() noexcept;
  void end() noexcept { link_.ending = true; }

  // Of the simulated hand; with a device they throw InputError.

  /// Guides the hand to a pose; ends what plays.
  void guide(const Pose& X_WT);
  /// Plays a scripted motion: see GuidedMotion. Ends an experiment's.
  void play(Trajectory script);
  /// Ends what plays; the hand stays where it is.
  void stop_motion();

  // Looking.

  /// To be called in each pass: true once, when an experiment's motion has ended and the hand has taken the tool. The
  /// settings are those that the interface is rated for from then on.
  bool hand_took_over();

  bool has_device() const noexcept { return device_ != nullptr; }
  bool is_playing() const noexcept { return hand_ && (hand_->is_playing_exactly() || hand_->guide().is_playing()); }
  bool is_playing_exactly() const noexcept { return hand_ && hand_->is_playing_exactly(); }
  /// Where a simulated hand that is guided means the tool to be.
  std::optional<Pose> intended();
  /// Contacts of a tick at most a frame ago.
  const ContactView& contacts();
  const MovingBodies& bodies();

  const LiveScene& scene() const noexcept { return scene_; }
  const MujocoWorld& world() const noexcept { return *world_; }
  const SceneGeometry& geometry() const { return world_->geometry(); }
  /// What the commands are for: while an experiment's motion is played exactly, whatever is displayed, an interface
  /// without bounds; then the simulated one.
  InterfaceCapability interface() const;
  /// What identifies the run, a line each, for the head of files.
  std::vector<std::string> notes() const;
  const SessionSettings& settings() const noexcept { return settings_; }
  const SettingsRequest& request() const noexcept { return request_; }
  const std::vector<std::string>& warnings() const noexcept { return warnings_; }
  /// Hz, the highest physics rate that `set` permits on this machine.
  double highest_physics_rate() const noexcept { return highest_physics_rate_; }
  /// What went wrong in the world, a sentence; empty: nothing. After the run only.
  std::string trouble() const;

 private:
  SessionSettings decide(const SettingsRequest& request) const;
  void change(const SettingsRequest& request);
  void warn_of_reductions();
  LiveHand& guided_hand();

  LiveScene scene_;
  HapticInterface* device_;
  std::unique_ptr<MujocoWorld> world_;
  double highest_physics_rate_ = 0.0;
  bool in_hand_;              ///< a hand feels what is commanded, and the interface's rating holds
  SettingsRequest of_scene_;  ///< what scene and experiment ask for
  SettingsRequest request_;
  SessionSettings settings_;
  std::vector<std::string> warnings_;
  std::optional<LiveHand> hand_;  ///< where there is no device
  PhysicsLoop physics_;
  HapticTick haptics_;
  LiveLink link_;
};

}  // namespace tegotae
