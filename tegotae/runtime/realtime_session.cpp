// SPDX-License-Identifier: Apache-2.0
#include <tegotae/runtime/latest_value.hpp>
#include <tegotae/runtime/periodic_timer.hpp>
#include <tegotae/runtime/realtime_session.hpp>
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
  Run(PhysicsLoop& the_physics, HapticTick& the_haptics, HapticInterface& the_interface)
      : physics(the_physics), haptics(the_haptics), interface(the_interface) {}

  double now() const noexcept { return seconds_between(start, monotonic_nanoseconds()); }

  PhysicsLoop& physics;
  HapticTick& haptics;
  HapticInterface& interface;
  std::int64_t start = 0;
  LatestValue<IntermediateRepresentation> models;
  LatestValue<ImpulseSums> messages;
  SpscRing<TickRecord> records{kRingCapacity};
  std::atomic<bool> ending{false};
  std::atomic<bool> haptics_done{false};
  InterfaceStatus written = InterfaceStatus::kOk;  ///< the haptic thread's: how the last command fared
  RealtimeReport report;
};

void physics_thread(Run& run) {
  run.report.physics_rights = request_realtime(kPhysicsPriority);
  PeriodicTimer timer(PeriodicTimer::period_of(1.0 / run.physics.settings().period));
  while (!run.ending.load(std::memory_order_acquire)) {
    const auto missed = static_cast<std::uint64_t>(timer.wait());
    run.messages.update();
    const ImpulseSums& message = run.messages.get();
    const double began = run.now();
    run.physics.step(began, message, run.models.begin_write());
    run.models.publish();
    run.report.physics.add(run.now() - began, began - message.time, missed);
  }
}

void guarded_physics_thread(Run& run) noexcept {
  try {
    physics_thread(run);
  } catch (const std::exception& error) {
    run.report.physics_error = error.what();
  }
}

// One period of the haptic thread: the interface is read and commanded here, outside the tick.
void haptic_period(Run& run, PeriodicTimer& timer, bool ending) noexcept {
  const auto missed = static_cast<std::uint64_t>(timer.wait());
  run.report.wake_up.add(seconds_between(timer.due(), timer.woken_at()));
  const double began = run.now();

  InterfaceState state;
  const bool lost = run.interface.read(began, state) != InterfaceStatus::kOk || run.written != InterfaceStatus::kOk;
  state.time = began;
  const IntermediateRepresentation* fresh = run.models.update() ? &run.models.get() : nullptr;
  TickRecord record;
  const double tick_began = run.now();
  const InterfaceCommand command = run.haptics(state, fresh, {lost, ending}, record);
  const double duration = run.now() - tick_began;
  run.written = run.interface.write(command);

  run.haptics.fill(run.messages.begin_write(), run.physics.body_count());
  run.messages.publish();
  record.tick_us = 1e6 * duration;
  run.report.haptics.add(duration, record.model_age, missed);
  run.records.push(record);
}

void haptic_thread(Run& run, double period) {
  run.report.haptic_rights = request_realtime(kHapticPriority);
  PeriodicTimer timer(PeriodicTimer::period_of(1.0 / period));
  while (!run.ending.load(std::memory_order_acquire)) haptic_period(run, timer, false);
  haptic_period(run, timer, true);  // the last command: zero
  run.haptics_done.store(true, std::memory_order_release);
}

// Hands the records to the observer until the run ends.
void observe(Run& run, double duration, const std::atomic<bool>& stop, const RealtimeObserver& observer) {
  bool wanted = true;
  for (;;) {
    const bool last = run.haptics_done.load(std::memory_order_acquire);
    TickRecord record;
    while (run.records.pop(record)) wanted = wanted && observer(record);
    if (last) return;
    if (!wanted || stop.load(std::memory_order_relaxed) || run.now() >= duration) {
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

// The first model and the first message, so that neither thread starts from nothing.
void prime(Run& run) {
  InterfaceState state;
  run.interface.read(0.0, state);
  run.physics.build(0.0, {state.X_WT, state.V_WT}, run.models.begin_write());
  run.models.publish();
  ImpulseSums& message = run.messages.begin_write();
  message = {};
  message.X_WT = state.X_WT;
  message.V_WT = state.V_WT;
  run.messages.publish();
}

}  // namespace

RealtimeReport run_realtime(PhysicsLoop& physics, HapticTick& haptics, HapticInterface& interface,
                            double haptic_period_seconds, double duration, const std::atomic<bool>& stop,
                            const RealtimeObserver& observer) {
  const auto run = std::make_unique<Run>(physics, haptics, interface);
  run->start = monotonic_nanoseconds();
  prime(*run);
  {
    Threads threads(*run);
    run->start = monotonic_nanoseconds();
    threads.haptics = std::thread([&run, haptic_period_seconds] { haptic_thread(*run, haptic_period_seconds); });
    threads.physics = std::thread([&run] { guarded_physics_thread(*run); });
    observe(*run, duration, stop, observer);
  }
  run->report.dropped_records = run->records.dropped();
  return run->report;
}

}  // namespace tegotae
