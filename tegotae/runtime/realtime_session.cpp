// SPDX-License-Identifier: Apache-2.0
#include <tegotae/runtime/realtime_session.hpp>

#include <tegotae/runtime/latest_value.hpp>
#include <tegotae/runtime/periodic_timer.hpp>
#include <tegotae/runtime/spsc_ring.hpp>

#include <chrono>
#include <exception>
#include <memory>
#include <thread>

namespace tegotae {
namespace {

// Ticks between the haptic thread and the observer: 8 s of a stalled observer at 1 kHz.
constexpr std::size_t kRingCapacity = 8192;
// Between the observer's looks at the ring: nobody wakes it, as that would take a system call in the haptic thread.
constexpr std::chrono::milliseconds kObserverPause{5};

// All that the threads of one run share.
struct Run {
  Run(PhysicsLoop& the_physics, HapticTick& the_haptics, HapticInterface& the_interface,
      const std::atomic<bool>& the_stop, LiveLink* the_link)
      : physics(the_physics), haptics(the_haptics), interface(the_interface), stop(the_stop), live(the_link) {}

  // s since the run began, but for the time that it stood still.
  double now() const noexcept {
    return seconds_between(start + stood_still.load(std::memory_order_relaxed), monotonic_nanoseconds());
  }
  // Looked at by the haptic thread itself: an observer that is stuck (a full disk, a terminal that stands still) must
  // not keep a force on the hand.
  bool is_ending() const noexcept {
    return ending.load(std::memory_order_acquire) || stop.load(std::memory_order_relaxed) ||
           (live != nullptr && live->ending.load(std::memory_order_relaxed));
  }
  bool is_paused() const noexcept { return live != nullptr && live->paused.load(std::memory_order_relaxed); }

  PhysicsLoop& physics;
  HapticTick& haptics;
  HapticInterface& interface;
  const std::atomic<bool>& stop;
  LiveLink* live;  ///< null: nobody steers
  std::int64_t start = 0;
  std::atomic<std::int64_t> stood_still{0};  ///< ns, the haptic thread's
  LatestValue<IntermediateRepresentation> models;
  LatestValue<ImpulseSums> messages;
  SpscRing<TickRecord> records{kRingCapacity};
  std::atomic<bool> ending{false};
  std::atomic<bool> haptics_done{false};
  std::atomic<bool> physics_failed{false};
  std::exception_ptr haptics_failed;               ///< of the haptic thread; read once it has ended
  bool zero_said = false;                          ///< the haptic thread's last command was its own zero; likewise
  std::atomic<int> rights_known{0};                ///< threads whose rights stand in the report
  InterfaceStatus written = InterfaceStatus::kOk;  ///< the haptic thread's: how the last command fared
  RealtimeReport report;
};

// One of those that somebody granted to a paused run.
bool take_granted(std::atomic<int>& granted) noexcept {
  if (granted.load(std::memory_order_relaxed) <= 0) return false;
  granted.fetch_sub(1, std::memory_order_relaxed);
  return true;
}

void show_bodies(Run& run, double began, double duration) noexcept {
  MovingBodies& shown = run.live->bodies.begin_write();
  const auto bodies = run.physics.bodies();
  shown.time = began;
  shown.period = run.physics.settings().period;
  shown.step_duration = duration;
  shown.steps = run.report.physics.count();
  shown.count = static_cast<std::int32_t>(bodies.size());
  for (std::size_t i = 0; i < bodies.size(); ++i) shown.poses[i] = bodies[i].X_WB;
  run.live->bodies.publish();
}

void physics_step(Run& run, std::uint64_t missed) {
  run.messages.update();
  const ImpulseSums& message = run.messages.get();
  const double began = run.now();
  run.physics.step(began, message, run.models.begin_write());
  run.models.publish();
  const double duration = run.now() - began;
  run.report.physics.add(duration, began - message.time, missed);
  if (run.live != nullptr) show_bodies(run, began, duration);
}

PeriodicTimer timer_of(const PhysicsLoop& physics) {
  return PeriodicTimer(PeriodicTimer::period_of(1.0 / physics.settings().period));
}

void physics_thread(Run& run) {
  run.report.physics_rights = request_realtime(kPhysicsPriority);
  run.rights_known.fetch_add(1, std::memory_order_release);
  PeriodicTimer timer = timer_of(run.physics);
  while (!run.ending.load(std::memory_order_acquire)) {
    const auto missed = static_cast<std::uint64_t>(timer.wait());
    if (run.live != nullptr && run.live->physics_updates.update()) {
      const PhysicsUpdate& update = run.live->physics_updates.get();
      run.physics.change(update.settings, update.needs);
      timer = timer_of(run.physics);
    }
    if (run.is_paused() && !take_granted(run.live->steps_granted)) continue;
    physics_step(run, missed);
  }
}

void guarded_physics_thread(Run& run) noexcept {
  try {
    physics_thread(run);
  } catch (const std::exception& error) {
    run.report.physics_error = error.what();
  } catch (...) {
    run.report.physics_error = "the physics threw what is no std::exception";
  }
  if (!run.report.physics_error.empty()) run.physics_failed.store(true, std::memory_order_release);
}

// One period of the haptic thread: the interface is read and commanded here, outside the tick.
void haptic_period(Run& run, const PeriodicTimer& timer, std::uint64_t missed, bool ending) noexcept {
  run.report.wake_up.add(seconds_between(timer.due(), timer.woken_at()));
  const double began = run.now();

  InterfaceState state;
  state.time = began;
  HapticTick::Circumstances circumstances;
  circumstances.interface_lost =
      run.interface.read(began, state) != InterfaceStatus::kOk || run.written != InterfaceStatus::kOk;
  circumstances.ending = ending;
  circumstances.pose_age = began - state.time;
  state.time = began;
  const IntermediateRepresentation* fresh = run.models.update() ? &run.models.get() : nullptr;
  TickRecord record;
  const double tick_began = run.now();
  const InterfaceCommand command = run.haptics(state, fresh, circumstances, record);
  const double duration = run.now() - tick_began;
  run.written = run.interface.write(command);

  run.haptics.fill(run.messages.begin_write(), run.physics.body_count());
  run.messages.publish();
  record.tick_us = 1e6 * duration;
  run.report.haptics.add(duration, record.model_age, missed);
  run.records.push(record);
}

// What steers a run and what shows it, about one haptic period.
class LivePeriods {
 public:
  explicit LivePeriods(Run& run) noexcept : run_(run), link_(*run.live), before_(monotonic_nanoseconds()) {}

  // False where time stands still: then this period has none.
  bool begin() noexcept {
    const std::int64_t now = monotonic_nanoseconds();
    const std::int64_t since = now - before_;
    before_ = now;
    if (run_.is_paused() && !take_granted(link_.ticks_granted)) {
      run_.stood_still.store(run_.stood_still.load(std::memory_order_relaxed) + since, std::memory_order_relaxed);
      return false;
    }
    if (auto* update = link_.haptic_updates.take()) {
      run_.haptics.adopt(update->content);
      link_.haptic_updates.give_back(update);
    }
    return true;
  }

  void end() noexcept {
    const double now = run_.now();
    if (now < next_view_) return;
    next_view_ = now + link_.view_period;
    run_.haptics.view(link_.contacts.begin_write());
    link_.contacts.publish();
  }

 private:
  Run& run_;
  LiveLink& link_;
  std::int64_t before_;      // ns, beginning of the period before
  double next_view_ = -1.0;  // s
};

void live_haptic_periods(Run& run, PeriodicTimer& timer) noexcept {
  LivePeriods periods(run);
  while (!run.is_ending()) {
    const auto missed = static_cast<std::uint64_t>(timer.wait());
    const bool goes_on = periods.begin();
    if (goes_on || !run.live->interface_waits) haptic_period(run, timer, missed, !goes_on);
    periods.end();
  }
}

void haptic_thread(Run& run, double period) {
  run.report.haptic_rights = request_realtime(kHapticPriority);
  run.rights_known.fetch_add(1, std::memory_order_release);
  PeriodicTimer timer(PeriodicTimer::period_of(1.0 / period));
  if (run.live != nullptr) live_haptic_periods(run, timer);
  while (!run.is_ending()) {
    haptic_period(run, timer, static_cast<std::uint64_t>(timer.wait()), false);
  }
  haptic_period(run, timer, static_cast<std::uint64_t>(timer.wait()), true);  // the last command: zero
  run.zero_said = run.written == InterfaceStatus::kOk;
}

void guarded_haptic_thread(Run& run, double period) noexcept {
  try {
    haptic_thread(run, period);
  } catch (...) {
    run.haptics_failed = std::current_exception();
    run.interface.write({});
  }
  run.haptics_done.store(true, std::memory_order_release);
}

void tell_live(Run& run, bool& rights_told) {
  if (!rights_told && run.rights_known.load(std::memory_order_acquire) == 2) {
    rights_told = true;
    if (run.live->on_rights) run.live->on_rights(run.report.haptic_rights, run.report.physics_rights);
  }
  if (run.live->on_pass) run.live->on_pass();
}

// Hands the records to the observer until the run ends.
void observe(Run& run, double duration, const RealtimeObserver& observer) {
  bool wanted = true, rights_told = false;
  for (;;) {
    const bool last = run.haptics_done.load(std::memory_order_acquire);
    TickRecord record;
    while (run.records.pop(record)) wanted = wanted && observer(record);
    if (run.live != nullptr) tell_live(run, rights_told);
    if (last) return;
    if (run.live != nullptr && run.physics_failed.load(std::memory_order_acquire)) wanted = false;
    if (!wanted || run.is_ending() || run.now() >= duration) {
      run.ending.store(true, std::memory_order_release);
    }
    std::this_thread::sleep_for(kObserverPause);
  }
}

// Threads that end and are joined however the scope is left.
class Threads {
 public:
  explicit Threads(Run& run) : run_(run) {}
  Threads(const Threads&) = delete;
  Threads& operator=(const Threads&) = delete;
  ~Threads() {
    run_.ending.store(true, std::memory_order_release);
    for (std::thread* thread : {&haptics, &physics}) {
      if (thread->joinable()) thread->join();
    }
  }

  std::thread physics, haptics;

 private:
  Run& run_;
};

// Says zero to the interface when the scope is left, however it is left, where the haptic thread has not.
class LastCommand {
 public:
  explicit LastCommand(Run& run) : run_(run) {}
  LastCommand(const LastCommand&) = delete;
  LastCommand& operator=(const LastCommand&) = delete;
  ~LastCommand() {
    if (!run_.zero_said) run_.interface.write({});
  }

 private:
  Run& run_;
};

// The first model and the first message, so that neither thread starts from nothing.
void prime(Run& run) {
  InterfaceState state;
  const bool lost = run.interface.read(0.0, state) != InterfaceStatus::kOk;
  const ToolState tool = run.haptics.begin(state, lost);
  run.physics.build(0.0, tool, run.models.begin_write());
  run.models.publish();
  ImpulseSums& message = run.messages.begin_write();
  message = {};
  message.X_WT = tool.X_WT;
  message.V_WT = tool.V_WT;
  message.X_WP = tool.X_WP;
  run.messages.publish();
}

}  // namespace

RealtimeReport run_realtime(PhysicsLoop& physics, HapticTick& haptics, HapticInterface& interface,
                            double haptic_period_seconds, double duration, const std::atomic<bool>& stop,
                            const RealtimeObserver& observer, LiveLink* live) {
  const auto run = std::make_unique<Run>(physics, haptics, interface, stop, live);
  run->start = monotonic_nanoseconds();
  {
    // Left in the other order: the threads end first.
    const LastCommand last_command(*run);
    Threads threads(*run);
    prime(*run);
    run->start = monotonic_nanoseconds();
    threads.haptics =
        std::thread([&run, haptic_period_seconds] { guarded_haptic_thread(*run, haptic_period_seconds); });
    threads.physics = std::thread([&run] { guarded_physics_thread(*run); });
    observe(*run, duration, observer);
  }
  if (run->haptics_failed != nullptr) std::rethrow_exception(run->haptics_failed);
  run->report.dropped_records = run->records.dropped();
  return run->report;
}

}  // namespace tegotae
