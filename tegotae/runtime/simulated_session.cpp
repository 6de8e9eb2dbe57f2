// SPDX-License-Identifier: Apache-2.0
#include <tegotae/runtime/simulated_session.hpp>

#include <chrono>
#include <cmath>
#include <memory>

namespace tegotae {
namespace {

using Clock = std::chrono::steady_clock;

double microseconds_since(Clock::time_point start) {
  return std::chrono::duration<double, std::micro>(Clock::now() - start).count();
}

// The physics side in simulated time: models that are being made and the one that is ready.
class SimulatedPhysics {
 public:
  SimulatedPhysics(PhysicsLoop& loop, const ToolState& tool)
      : loop_(loop),
        ready_(std::make_unique<IntermediateRepresentation>()),
        pending_(std::make_unique<IntermediateRepresentation>()) {
    loop_.build(-loop_.settings().period, tool, *ready_);
  }

  /// The model that becomes visible at `time`, or null.
  const IntermediateRepresentation* advance_to(double time, const ImpulseSums& haptics) {
    // Half a nanosecond: sums of periods are not exact.
    constexpr double kRounding = 5e-10;
    bool stepped = false;
    for (; time + kRounding >= next_step(); ++steps_) {
      if (steps_ > 0) std::swap(ready_, pending_);
      loop_.step(next_step(), haptics, *pending_);
      stepped = true;
    }
    return stepped ? ready_.get() : nullptr;
  }

 private:
  double next_step() const { return static_cast<double>(steps_) * loop_.settings().period; }

  PhysicsLoop& loop_;
  std::unique_ptr<IntermediateRepresentation> ready_, pending_;
  long steps_ = 0;
};

}  // namespace

void run_simulated(PhysicsLoop& physics, HapticTick& haptics, HapticInterface& interface, double haptic_period,
                   double duration, const TickObserver& observer) {
  InterfaceState state;
  InterfaceStatus read = interface.read(0.0, state);
  InterfaceStatus written = InterfaceStatus::kOk;
  const ToolState tool = haptics.begin(state, read != InterfaceStatus::kOk);
  SimulatedPhysics simulated(physics, tool);
  auto message = std::make_unique<ImpulseSums>();
  message->X_WT = tool.X_WT;
  message->V_WT = tool.V_WT;
  message->X_WP = tool.X_WP;

  const long ticks = static_cast<long>(std::floor(duration / haptic_period * (1.0 + 1e-12))) + 1;
  for (long tick = 0; tick < ticks; ++tick) {
    const double time = static_cast<double>(tick) * haptic_period;
    if (tick > 0) {
      state.time = time;
      read = interface.read(time, state);
    }
    HapticTick::Circumstances circumstances;
    circumstances.pose_age = time - state.time;
    state.time = time;
    circumstances.interface_lost = read != InterfaceStatus::kOk || written != InterfaceStatus::kOk;
    const IntermediateRepresentation* fresh = simulated.advance_to(time, *message);
    TickRecord record;
    const Clock::time_point start = Clock::now();
    const InterfaceCommand command = haptics(state, fresh, circumstances, record);
    record.tick_us = microseconds_since(start);
    written = interface.write(command);
    haptics.fill(*message, physics.body_count());
    if (!observer(record)) return;
  }
}

}  // namespace tegotae
