// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/device/observed_interface.hpp>
#include <tegotae/device/playback_interface.hpp>
#include <tegotae/lab/progress.hpp>
#include <tegotae/lab/samples_file.hpp>
#include <tegotae/lab/session_settings.hpp>
#include <tegotae/runtime/live_link.hpp>
#include <tegotae/runtime/realtime_session.hpp>
#include <tegotae/runtime/simulated_session.hpp>
#include <tegotae/world/mujoco_world.hpp>

#include <atomic>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace tegotae {

/// A recorded motion rendered on a scene: world, both loops and a hand that plays the motion, or means to follow it on
/// a simulated interface. Used for one run, as the run moves the world.
class Session {
 public:
  /// The hand plays the motion exactly, whatever is displayed; or, where there is an `interface` (null: none), for as
  /// long as the motion lasts. Throws InputError where the motion is too long for the haptic rate.
  Session(std::unique_ptr<MujocoWorld> world, Trajectory motion, const SessionSettings& settings,
          std::unique_ptr<ObservedInterface> interface = nullptr);
  ~Session();

  /// In simulated time, on this thread, until the motion ends or the observer says so: every record but `tick_us`
  /// repeats bit for bit.
  void run_simulated(const TickObserver& observer, const Progress& progress);

  /// In real time, both rates on threads of their own, until the motion ends or `stop` becomes true. A world that
  /// throws ends a run that is watched; else the physics alone.
  RealtimeReport run_realtime(const TickObserver& observer, const Progress& progress, const std::atomic<bool>& stop);

  /// Before a run in real time: `contacts` and `bodies` will be asked for.
  void watch() { link_ = std::make_unique<LiveLink>(); }

  // For the observer of a run, on its thread.

  /// What the newest tick worked with; in real time, of a tick at most a sixtieth of a second ago.
  const ContactView& contacts();
  /// Where the moving bodies are, as far as physics has come.
  const MovingBodies& bodies();

  /// What went wrong in the world during the run, a sentence; empty: nothing.
  std::string trouble() const;

  const SessionSettings& settings() const noexcept { return settings_; }
  const MujocoWorld& world() const noexcept { return *world_; }
  const Tool& tool() const { return world_->geometry().tool; }
  double start() const noexcept { return start_; }  ///< s, first time of the motion
  /// On a simulated interface: records tell what it displays and what the hand means.
  bool is_closed_loop() const noexcept { return observed_ != nullptr; }
  SampleKind sample_kind() const noexcept { return is_closed_loop() ? SampleKind::kClosedLoop : SampleKind::kPlayed; }
  std::string interface_name() const { return interface_->capability().name; }

  /// What identifies the session, a line each, for the head of files.
  std::vector<std::string> notes() const;

 private:
  struct Seen;
  TickObserver with_progress(const TickObserver& observer, const Progress& progress);
  void add_truth(TickRecord& record);

  std::unique_ptr<MujocoWorld> world_;
  SessionSettings settings_;
  double start_, duration_;  ///< s
  std::unique_ptr<HapticInterface> interface_;
  ObservedInterface* observed_;  ///< interface_, or null: playback
  GripTruth truth_;              ///< the newest that was taken
  PhysicsLoop physics_;
  std::unique_ptr<HapticTick> haptics_;
  std::unique_ptr<LiveLink> link_;  ///< null: not watched, or in simulated time
  std::unique_ptr<Seen> seen_;      ///< in simulated time
};

/// Limits of the safety stage for a session on an interface.
SafetyLimits safety_limits_of(const SessionSettings& settings, const InterfaceCapability& interface, const Tool& tool);

/// The settings with stiffness, and then metric length, damping and transient, as they are felt at the interface, no
/// greater than it is rated for; unchanged where they say that ratings are not applied.
SessionSettings held_to_rating(SessionSettings settings, const InterfaceCapability& interface);

/// What identifies a session, a line each, for the head of files.
std::vector<std::string> notes_of(const SessionSettings& settings, const Tool& tool);

/// What went wrong in a world, a sentence; empty: nothing.
std::string trouble_of(const WorldDiagnostics& found);

/// The scene's own haptic settings as a request. Throws InputError that names `file` and the setting where one is
/// unknown or out of range.
SettingsRequest settings_of(const std::vector<HapticSettingInScene>& scene, const std::filesystem::path& file);

/// The world's warnings on loading, each beginning with the file of its scene.
std::vector<std::string> scene_warnings(const MujocoWorld& world, const std::filesystem::path& file);

}  // namespace tegotae
