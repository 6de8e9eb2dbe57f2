// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/doctor_measure.hpp>

#include <tegotae/lab/scene_file.hpp>
#include <tegotae/lab/scripted_motion.hpp>
#include <tegotae/lab/session.hpp>
#include <tegotae/runtime/periodic_timer.hpp>

#include <fmt/format.h>

#include <atomic>
#include <chrono>
#include <memory>
#include <thread>
#include <utility>
#include <vector>

namespace tegotae {
namespace {

constexpr double kOneMicrosecond = 1e-6;  // s

std::string percentiles(const DurationHistogram& durations) {
  const auto us = [](double seconds) { return seconds / kOneMicrosecond; };
  return fmt::format("median {:.1f} us, 99 % {:.1f} us, 99.9 % {:.1f} us, worst {:.1f} us of {}",
                     us(durations.median()), us(durations.percentile(0.99)), us(durations.percentile(0.999)),
                     us(durations.max()), durations.count());
}

// Tells how far `done` has come until it has, from the thread that may tell.
void watch(const std::atomic<std::uint64_t>& done, std::uint64_t all, const Progress& progress) {
  constexpr std::chrono::milliseconds kPause{50};
  for (std::uint64_t count = 0; count < all; count = done.load(std::memory_order_acquire)) {
    progress(static_cast<double>(count) / static_cast<double>(all));
    std::this_thread::sleep_for(kPause);
  }
}

// The tool's poses in a scripted motion, which is told as displacements.
Trajectory motion_from(const Pose& X_WT, const Trajectory& script) {
  std::vector<Trajectory::Sample> samples = script.samples();
  for (Trajectory::Sample& sample : samples) {
    sample.X_WT = {X_WT.p + sample.X_WT.p, sample.X_WT.q * X_WT.q};
  }
  return Trajectory(std::move(samples));
}

}  // namespace

WakeUps measure_wake_ups(double period, double duration, const Progress& progress) {
  WakeUps result;
  const auto periods = static_cast<std::uint64_t>(duration / period);
  std::atomic<std::uint64_t> done{0};
  std::thread thread([&] {
    result.rights = request_realtime(kHapticPriority);
    PeriodicTimer timer(PeriodicTimer::period_of(1.0 / period));
    for (std::uint64_t i = 0; i < periods;) {
      const auto missed = static_cast<std::uint64_t>(timer.wait());
      result.missed += missed;
      result.late.add(seconds_between(timer.due(), timer.woken_at()) + static_cast<double>(missed) * period);
      i += 1 + missed;
      done.store(i, std::memory_order_release);
    }
    release_realtime();
  });
  watch(done, periods, progress);
  thread.join();
  return result;
}

Finding wake_up_finding(const WakeUps& wake_ups, double period) {
  const DurationHistogram& late = wake_ups.late;
  Finding finding{
      Verdict::kOk, "wake-ups",
      fmt::format("at {:g} Hz late by {}; {} missed periods.", 1.0 / period, percentiles(late), wake_ups.missed), ""};
  if (late.percentile(0.999) <= 0.1 * period) return finding;
  finding.verdict = late.percentile(0.99) <= 0.5 * period ? Verdict::kCouldBeBetter : Verdict::kNotPossible;
  finding.mend = wake_ups.rights.fifo
                     ? "close what else runs, plug in the mains, and mend kernel and clock rate above; in a virtual "
                       "machine, run on the hardware itself"
                     : "mend scheduling above first";
  return finding;
}

DurationHistogram measure_ticks(const Progress& progress) {
  const std::filesystem::path file = find_scene("table.xml");
  auto world = load_mujoco_world(file, "tool");
  const Tool& tool = world->geometry().tool;
  const SessionSettings settings = decide_settings(settings_of(world->haptic_settings(), file), tool);
  Trajectory motion = motion_from(tool.X_WT, find_scripted_motion("circle").motion(-world->gravity().normalized()));
  Session session(std::move(world), std::move(motion), settings);
  DurationHistogram ticks;
  session.run_simulated(
      [&](const TickRecord& record) {
        ticks.add(record.tick_us * kOneMicrosecond);
        return true;
      },
      progress);
  return ticks;
}

Finding tick_finding(const DurationHistogram& ticks, double period) {
  Finding finding{Verdict::kOk, "tick",
                  fmt::format("{}; the period is {:g} us.", percentiles(ticks), period / kOneMicrosecond), ""};
  if (ticks.percentile(0.999) <= 0.5 * period) return finding;
  finding.verdict = ticks.percentile(0.99) <= period ? Verdict::kCouldBeBetter : Verdict::kNotPossible;
  finding.mend =
      "close what else runs; build with -DCMAKE_BUILD_TYPE=Release; a slower --haptic-rate gives a tick time";
  return finding;
}

}  // namespace tegotae
