// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/live_session.hpp>

#include <tegotae/lab/experiment.hpp>
#include <tegotae/lab/input_error.hpp>
#include <tegotae/lab/live_messages.hpp>
#include <tegotae/lab/scripted_motion.hpp>
#include <tegotae/stream/scene_message.hpp>
#include <tegotae/world/scene_error.hpp>

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <exception>
#include <set>
#include <system_error>
#include <thread>
#include <utility>

namespace tegotae {
namespace {

using std::chrono::milliseconds;

constexpr milliseconds kHistogramPeriod{500};
constexpr int kMostRefusals = 50;           // of messages that are none, from one page
constexpr milliseconds kHandSilence{1000};  // after which another may take the tool

}  // namespace

LiveSession::LiveSession(LiveSessionOptions options, ViewerOutput output, Log log)
    : options_(std::move(options)), output_(std::move(output)), log_(std::move(log)) {
  begin(options_.scene, options_.settings);
  if (!options_.file) return;
  start_recording(*options_.file);
  if (!recording_) throw InputError(recording_error_);
}

LiveSession::~LiveSession() = default;

void LiveSession::run(const std::atomic<bool>& stop) {
  const auto observer = [this](const TickRecord& record) {
    frames_->add(record);
    has_ticks_ = true;
    newest_time_ = record.time;
    this->record(record);
    watch_device(record);
    return true;
  };
  while (!stop) {
    finish_run(run_->run(
        stop, observer, [this] { pass(); },
        [this](const auto& haptics, const auto& physics) { tell_rights(haptics, physics); }));
    begin_next(stop);
  }
  stop_recording();
}

// What was chosen; where it cannot be run, what has run until now; where that cannot either (its file has changed,
// say), what is chosen then.
void LiveSession::begin_next(const std::atomic<bool>& stop) {
  while (!stop && next_scene_) {
    const LiveScene scene = *std::exchange(next_scene_, std::nullopt);
    try {
      begin(scene, next_settings_);
    } catch (const std::exception& error) {
      tell(NoticeLevel::kError, error.what());
      const LiveScene& last = run_->scene();
      if (scene.file != last.file || scene.experiment != last.experiment) {
        choose(last, run_->request());
      } else {
        wait_for_choice(stop);
      }
    }
  }
}

void LiveSession::wait_for_choice(const std::atomic<bool>& stop) {
  constexpr milliseconds kPause{20};
  tell(NoticeLevel::kWarning, "no scene runs; reset starts this one anew, or choose another.");
  while (!stop && !next_scene_) {
    take_messages();
    tell_news();
    std::this_thread::sleep_for(kPause);
  }
}

// Once, of the first run: the system gives later ones the same.
void LiveSession::tell_rights(const RealtimeRights& haptics, const RealtimeRights& physics) {
  if (std::exchange(rights_told_, true)) return;
  for (const std::string& sentence : std::set<std::string>{haptics.explanation, physics.explanation}) {
    if (!sentence.empty()) tell(NoticeLevel::kWarning, sentence);
  }
}

// The scene that has run until now stays until the new one stands.
void LiveSession::begin(const LiveScene& scene, const SettingsRequest& wanted) {
  run_ = std::make_unique<LiveRun>(scene, wanted, options_.device);
  frames_ = std::make_unique<FrameMaker>(run_->settings(), run_->geometry().tool.mass.centre_of_mass);
  recording_offset_ += newest_time_ + 1.0 / run_->settings().haptic_rate;
  newest_time_ = 0.0;
  has_ticks_ = false;
  device_watch_ = {};
  motion_.reset();
  if (scene.experiment != nullptr) motion_ = scene.experiment->name;
  output_.send_all(shared(scene_message()));
  output_.send_all(shared(settings_message()));
  if (recording_) record_scene();
  for (const std::string& warning : run_->warnings()) tell(NoticeLevel::kWarning, warning);
}

void LiveSession::finish_run(const RealtimeReport& report) {
  if (!run_->trouble().empty()) tell(NoticeLevel::kWarning, run_->trouble());
  if (report.physics_error.empty()) return;
  tell(NoticeLevel::kError, fmt::format("the physics failed, and the scene starts anew: {}", report.physics_error));
  if (!next_scene_) choose(run_->scene(), run_->request());
}

void LiveSession::choose(const LiveScene& scene, const SettingsRequest& wanted) {
  next_scene_ = scene;
  next_settings_ = wanted;
  run_->end();
}

void LiveSession::pass() {
  take_messages();
  tell_news();
  release_silent_hand();
  if (run_->hand_took_over()) settings_changed();
  if (motion_ && !run_->is_playing()) motion_.reset();
  watch_recording();
  const Clock::time_point now = Clock::now();
  if (now < next_state_ || !has_ticks_) return;
  next_state_ = std::max(next_state_ + kStatePeriod, now);
  show();
}

void LiveSession::tell_news() {
  if (!options_.news) return;
  for (const std::string& sentence : options_.news()) tell(NoticeLevel::kWarning, sentence);
}

void LiveSession::take_messages() {
  for (const LiveInbox::Event& event : inbox_.take()) handle(event);
}

void LiveSession::handle(const LiveInbox::Event& event) {
  if (std::holds_alternative<LiveInbox::Joined>(event.what)) greet(event.viewer);
  if (std::holds_alternative<LiveInbox::Left>(event.what) && hand_ == event.viewer) hand_.reset();
  if (std::holds_alternative<LiveInbox::Left>(event.what)) refusals_.erase(event.viewer);
  if (const auto* refused = std::get_if<LiveInbox::Refused>(&event.what)) {
    refuse(event.viewer, refused->why);
    if (++refusals_[event.viewer] == kMostRefusals) output_.disconnect(event.viewer, "too many messages that are none");
  }
  const auto* command = std::get_if<ViewerCommand>(&event.what);
  if (command == nullptr) return;
  try {
    obey(event.viewer, *command);
  } catch (const InputError& error) {
    refuse(event.viewer, error.what());
    // The page shows what holds, not what was refused.
    output_.send(event.viewer, shared(settings_message()));
  }
}

// One function a command. Each throws InputError where it cannot be obeyed, and then nothing has changed.
struct LiveSession::Handler {
  LiveSession& session;
  ViewerId viewer;

  LiveRun& run() const { return *session.run_; }

  void operator()(const viewer_command::Hand& hand) const {
    // A page that has not heard of the device yet, or another's hand: many messages a second, none worth an answer.
    if (run().has_device() || (session.hand_ && session.hand_ != viewer)) return;
    session.hand_ = viewer;
    session.hand_heard_ = Clock::now();
    session.motion_.reset();
    run().guide(hand.X_WT);
  }
  void operator()(const viewer_command::Release&) const {
    if (session.hand_ == viewer) session.hand_.reset();
  }
  void operator()(const viewer_command::Set& set) const {
    run().set(set.name, set.value);
    session.settings_changed();
  }
  void operator()(const viewer_command::Method& method) const {
    run().set_method(method.name);
    session.settings_changed();
  }
  void operator()(const viewer_command::Pause&) const { run().pause(true); }
  void operator()(const viewer_command::Resume&) const { run().pause(false); }
  void operator()(const viewer_command::Step&) const {
    if (!run().is_paused()) throw InputError("only a session that is paused can be stepped.");
    run().step();
  }
  void operator()(const viewer_command::Reset&) const { session.choose(run().scene(), run().request()); }
  void operator()(const viewer_command::Motion& motion) const {
    run().play(find_scripted_motion(motion.name).motion(up_axis(run().world().gravity())));
    session.motion_ = motion.name;
  }
  void operator()(const viewer_command::Stop&) const { run().stop_motion(); }
  void operator()(const viewer_command::SceneChoice& choice) const {
    session.choose(find_live_scene(session.options_.scenes, choice.name), kept());
  }
  void operator()(const viewer_command::ExperimentChoice& choice) const {
    session.choose(live_scene_of(find_experiment(choice.name)), kept());
  }
  void operator()(const viewer_command::Record& record) const {
    if (!record.on) return session.stop_recording();
    if (!session.recording_) session.start_recording(new_recording(session.options_.recordings));
  }
  void operator()(const viewer_command::Seek&) const { refuse_replay(); }
  void operator()(const viewer_command::Play&) const { refuse_replay(); }

  // The command line's settings hold for every scene, and so does the method that was chosen last.
  SettingsRequest kept() const {
    SettingsRequest wanted = session.options_.settings;
    wanted.method = run().request().method;
    return wanted;
  }
  [[noreturn]] static void refuse_replay() {
    throw InputError("only a replay has a time to go to; open a recording with 'tegotae replay FILE'.");
  }
  // None that is there already: two may be started in one second.
  static std::filesystem::path new_recording(const std::filesystem::path& folder) {
    const std::string name = fmt::format("tegotae-{:%Y%m%d-%H%M%S}", fmt::localtime(std::time(nullptr)));
    std::error_code error;
    std::filesystem::path file = folder / (name + ".mcap");
    for (int n = 2; std::filesystem::exists(file, error); ++n) file = folder / fmt::format("{}-{}.mcap", name, n);
    return file;
  }
};

void LiveSession::obey(ViewerId viewer, const ViewerCommand& command) { std::visit(Handler{*this, viewer}, command); }

void LiveSession::release_silent_hand() {
  if (hand_ && Clock::now() - hand_heard_ > kHandSilence) hand_.reset();
}

void LiveSession::show() {
  ViewFrame frame = frames_->frame(run_->contacts(), run_->bodies());
  frame.target = run_->intended();
  frame.paused = run_->is_paused();
  frame.motion = motion_;
  frame.hand = hand_;
  frame.viewers = static_cast<int>(output_.viewer_count());
  if (recording_) frame.recording = {recording_path_.string(), recording_->ticks()};
  const Clock::time_point now = Clock::now();
  if (now >= next_histogram_) {
    next_histogram_ = now + kHistogramPeriod;
    frame.histogram = frames_->histogram();
  }
  const SharedText message = shared(encode(frame));
  output_.publish(message);
  if (recording_ && !frame.paused) record_state(frame, *message);
}

void LiveSession::greet(ViewerId viewer) {
  output_.send(viewer, shared(encode_welcome(viewer)));
  output_.send(viewer, shared(scene_message()));
  output_.send(viewer, shared(settings_message()));
  for (const std::string& warning : run_->warnings()) {
    output_.send(viewer, shared(encode_notice(NoticeLevel::kWarning, warning)));
  }
}

void LiveSession::tell(NoticeLevel level, const std::string& text) {
  output_.send_all(shared(encode_notice(level, text)));
  log_(level, text);
}

void LiveSession::refuse(ViewerId viewer, const std::string& why) {
  output_.send(viewer, shared(encode_notice(NoticeLevel::kError, why)));
}

std::string LiveSession::scene_message() const { return live_scene_message(*run_, options_.scenes); }
std::string LiveSession::settings_message() const { return live_settings_message(*run_); }

void LiveSession::settings_changed() {
  frames_->change(run_->settings());
  const std::string message = settings_message();
  output_.send_all(shared(message));
  if (recording_) recording_->write_settings(recording_offset_ + newest_time_, message);
}

void LiveSession::start_recording(const std::filesystem::path& file) {
  recording_path_ = file;
  recording_offset_ = 0.0;
  recording_ = std::make_unique<RecordingFile>(file, run_->notes(), 0.0);
  record_scene();
  watch_recording();
  if (recording_) tell(NoticeLevel::kInfo, fmt::format("recording to {}.", file.string()));
}

void LiveSession::stop_recording() {
  if (!recording_) return;
  recording_->close();
  if (recording_->ok()) {
    tell(NoticeLevel::kInfo, fmt::format("{} ticks recorded in {}.", recording_->ticks(), recording_path_.string()));
  } else {
    recording_error_ = recording_->error();
    tell(NoticeLevel::kError, recording_error_);
  }
  recording_.reset();
}

void LiveSession::record_scene() {
  const double time = recording_offset_ + newest_time_;
  recording_->write_scene(time, scene_message());
  recording_->write_settings(time, settings_message());
}

void LiveSession::record(const TickRecord& tick) {
  if (!recording_) return;
  TickRecord recorded = tick;
  recorded.time += recording_offset_;
  recording_->write(recorded);
}

void LiveSession::record_state(const ViewFrame& frame, const std::string& message) {
  if (recording_offset_ == 0.0) return recording_->write_state(frame.time, message);
  ViewFrame recorded = frame;
  recorded.time += recording_offset_;
  for (ViewedSample& sample : recorded.samples) sample.time += recording_offset_;
  recording_->write_state(recorded.time, encode(recorded));
}

void LiveSession::watch_device(const TickRecord& record) {
  if (!run_->has_device() || run_->is_paused()) return;
  const bool is_silent = ((record.safety_events >> static_cast<unsigned>(SafetyEvent::kPoseFault)) & 1U) != 0;
  switch (device_watch_.see(record.time, is_silent)) {
    case DeviceWatch::News::kNone:
      return;
    case DeviceWatch::News::kSilent:
      return tell(
          NoticeLevel::kWarning,
          fmt::format("{} does not answer, or with no pose: it is told zero, and looked for; check its cable and "
                      "its power.",
                      run_->interface().name));
    case DeviceWatch::News::kBack:
      return tell(
          NoticeLevel::kInfo,
          fmt::format("{} is back: let go of what you touch, and it is felt again from zero.", run_->interface().name));
  }
}

// A disk that is full ends the recording, and nothing else.
void LiveSession::watch_recording() {
  if (recording_ && !recording_->ok()) stop_recording();
}

}  // namespace tegotae
