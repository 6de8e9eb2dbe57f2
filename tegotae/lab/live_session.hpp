// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/lab/device_watch.hpp>
#include <tegotae/lab/frame_maker.hpp>
#include <tegotae/lab/live_inbox.hpp>
#include <tegotae/lab/live_run.hpp>
#include <tegotae/lab/recording_file.hpp>
#include <tegotae/lab/viewer_output.hpp>
#include <tegotae/stream/short_messages.hpp>

#include <atomic>
#include <chrono>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tegotae {

struct LiveSessionOptions {
  LiveScene scene;
  std::vector<LiveScene> scenes;              ///< others that a page may ask for
  SettingsRequest settings;                   ///< these win over those of every scene
  std::filesystem::path recordings = ".";     ///< folder of the recordings that a page starts
  std::optional<std::filesystem::path> file;  ///< a recording from the beginning
  HapticInterface* device = nullptr;  ///< what the hand holds, outlives the session; null: simulated, guided by a page
  /// Warnings about what the hand holds that came since it was asked last; asked often, from the session's thread.
  std::function<std::vector<std::string>()> news;
};

/// A scene in real time for the pages that look at it: it makes what they ask for, and shows them what came of it. Runs
/// one scene after another, as they choose; a fault in one ends neither the session nor a viewer's connection.
class LiveSession {
 public:
  using Log = std::function<void(NoticeLevel, const std::string&)>;

  /// `log` gets the sentences that go to all viewers, for the terminal. Throws InputError, SceneError where the first
  /// scene cannot be run or the recording not be written.
  LiveSession(LiveSessionOptions options, ViewerOutput output, Log log);
  ~LiveSession();

  /// What the server is told. Any thread.
  LiveInbox& inbox() noexcept { return inbox_; }

  /// Name of the scene that runs.
  const std::string& scene_name() const noexcept { return run_->scene().name; }

  /// Runs until `stop` becomes true. The recording is whole when it returns.
  void run(const std::atomic<bool>& stop);

 private:
  using Clock = std::chrono::steady_clock;
  struct Handler;

  // Runs of scenes.
  void begin(const LiveScene& scene, const SettingsRequest& wanted);
  void begin_next(const std::atomic<bool>& stop);
  void wait_for_choice(const std::atomic<bool>& stop);
  void finish_run(const RealtimeReport& report);
  void tell_rights(const RealtimeRights& haptics, const RealtimeRights& physics);
  void choose(const LiveScene& scene, const SettingsRequest& wanted);

  // Called while a scene runs.
  void pass();
  void tell_news();
  void take_messages();
  void handle(const LiveInbox::Event& event);
  void obey(ViewerId viewer, const ViewerCommand& command);
  void release_silent_hand();
  void show();

  void greet(ViewerId viewer);
  void tell(NoticeLevel level, const std::string& text);
  void refuse(ViewerId viewer, const std::string& why);
  std::string scene_message() const;
  std::string settings_message() const;
  void settings_changed();

  void start_recording(const std::filesystem::path& file);
  void stop_recording();
  void watch_recording();
  void watch_device(const TickRecord& record);
  void record(const TickRecord& tick);
  void record_state(const ViewFrame& frame, const std::string& message);
  void record_scene();

  LiveSessionOptions options_;
  ViewerOutput output_;
  Log log_;
  LiveInbox inbox_;

  std::unique_ptr<LiveRun> run_;
  std::unique_ptr<FrameMaker> frames_;
  bool has_ticks_ = false;
  bool rights_told_ = false;
  std::optional<LiveScene> next_scene_;
  SettingsRequest next_settings_;

  Clock::time_point next_state_{}, next_histogram_{};
  std::optional<ViewerId> hand_;
  Clock::time_point hand_heard_{};
  std::map<ViewerId, int> refusals_;  ///< messages that were none
  std::optional<std::string> motion_;
  std::unique_ptr<RecordingFile> recording_;
  std::string recording_error_;  ///< of the last recording that failed
  std::filesystem::path recording_path_;
  DeviceWatch device_watch_;
  double newest_time_ = 0.0;       ///< s, of the run
  double recording_offset_ = 0.0;  ///< s, from the time of the run to that of the recording: it outlives runs
};

}  // namespace tegotae
