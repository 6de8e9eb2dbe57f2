// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/thin_plate.hpp>

#include <tegotae/lab/axes.hpp>
#include <tegotae/lab/contact_experiment.hpp>
#include <tegotae/lab/motion.hpp>
#include <tegotae/lab/offline_reference.hpp>
#include <tegotae/lab/smooth_path.hpp>
#include <tegotae/math/rotation.hpp>

#include <algorithm>
#include <cmath>

namespace tegotae {
namespace {

constexpr double kDeepest = 0.05;  // m, of the lowest point

// Tilts of the presses, as rotation vectors in degrees: flat, on an edge, on a corner, steep.
const Vector3 kTilts[] = {{0.0, 0.0, 0.0}, {0.0, 5.0, 0.0}, {12.0, 9.0, 0.0}, {0.0, 30.0, 10.0}};
constexpr double kPress = 1.5;  // s a press

Pose at_depth(const Tool& tool, const Vector3& tilt, double depth) {
  const Quaternion q_WT = rotation_from_vector(kDegree * tilt);
  return {{0.0, 0.0, -lowest_height(tool, q_WT, Vector3::UnitZ()) - depth}, q_WT};
}

// The tilt of each press; between presses it changes in the air.
Vector3 tilt_at(double time, double duration, double change) {
  const auto last = static_cast<long>(std::size(kTilts)) - 1;
  const long press = std::clamp(std::lround(std::floor(time / duration)), 0L, last);
  const SmoothPath share({{(static_cast<double>(press) + 1.0) * duration - change, 0.0},
                          {(static_cast<double>(press) + 1.0) * duration, 1.0}});
  return kTilts[press] + share.at(time) * (kTilts[std::min(press + 1, last)] - kTilts[press]);
}

Trajectory pressed(const Tool& tool) {
  const SmoothPath depth({{0.0, -0.01}, {0.6, kDeepest}, {0.8, kDeepest}, {1.3, -0.01}});
  return sampled(0.0, kPress * static_cast<double>(std::size(kTilts)), [=, &tool](double time) {
    return at_depth(tool, tilt_at(time, kPress, 0.2), depth.at(std::fmod(time, kPress)));
  });
}

// A strike: from rest 0.15 m above, 1 m/s from 0.05 m above to 0.03 m below, stopped by 0.05 m, held, and back.
constexpr double kSpeed = 1.0, kGather = 0.2, kStop = 0.04, kAbove = 0.15;  // m/s, s, s, m
constexpr double kFast = 0.08, kStrike = 1.2;                               // s at full speed, s a strike

// The way (m) of a speed that rises from 0 to 1 m/s as a SmoothStep within `duration` (s), after the part u of it.
double way_of_gathering(double u, double duration) {
  u = std::clamp(u, 0.0, 1.0);
  return kSpeed * duration * u * u * u * u * (2.5 - 3.0 * u + u * u);
}

double strike_depth(double time) {
  const double reached = kGather + kFast, held = reached + kStop + 0.3;
  if (time > held) return SmoothStep{held, held + 0.4, kDeepest, -kAbove}.at(time);
  const double fast = kSpeed * std::clamp(time - kGather, 0.0, kFast);
  // Stopping is gathering backwards in time.
  const double stopping = way_of_gathering(1.0, kStop) - way_of_gathering(1.0 - (time - reached) / kStop, kStop);
  return -kAbove + way_of_gathering(time / kGather, kGather) + fast + stopping;
}

Trajectory struck(const Tool& tool) {
  return sampled(0.0, kStrike * static_cast<double>(std::size(kTilts)), [&tool](double time) {
    return at_depth(tool, tilt_at(time, kStrike, 0.15), strike_depth(std::fmod(time, kStrike)));
  });
}

std::vector<Phase> phases(double duration) {
  const char* const summaries[] = {"flat", "tilted by 5 degrees", "tilted by 15 degrees onto a corner",
                                   "tilted by 32 degrees"};
  std::vector<Phase> all;
  for (const char* const summary : summaries) {
    const double begin = duration * static_cast<double>(all.size());
    all.push_back({std::string(1, static_cast<char>('a' + all.size())), summary, begin, begin + duration});
  }
  return all;
}

}  // namespace

Experiment thin_plate_press_experiment() {
  Experiment experiment = contact_experiment("thin-plate-press", "a plate of 1 mm pressed 50 mm deep at several tilts",
                                             "thin-plate.xml", 0.0);
  experiment.motion = pressed;
  experiment.phases = phases(kPress);
  experiment.figures = {wrench_over_time(experiment, "A thin plate pressed", kAlongZ)};
  experiment.reference = offline_reference();
  experiment.notes =
      "The tool stays above the plate however deep the hand goes. A tilted tool is turned onto its face on the way. A "
      "method that sees only where the hand is pops through.";
  return experiment;
}

Experiment thin_plate_strike_experiment() {
  Experiment experiment = contact_experiment("thin-plate-strike", "a plate of 1 mm struck at 1 m/s at several tilts",
                                             "thin-plate.xml", 0.0);
  experiment.motion = struck;
  experiment.phases = phases(kStrike);
  experiment.figures = {wrench_over_time(experiment, "A thin plate struck", kAlongZ)};
  experiment.reference = offline_reference();
  experiment.notes =
      "At 1 m/s the hand passes the plate within one tick, and goes on for 50 ms, a physics period. The tool stays "
      "above, and the force grows by 1 N a tick as the hand goes on.";
  return experiment;
}

}  // namespace tegotae
