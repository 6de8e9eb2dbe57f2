// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/stability.hpp>

#include <tegotae/lab/closed_loop.hpp>
#include <tegotae/lab/decay_judge.hpp>
#include <tegotae/lab/input_error.hpp>
#include <tegotae/lab/tolerances.hpp>

#include <algorithm>
#include <cmath>

namespace tegotae {

bool touch_decays(const StabilitySetup& setup, const TouchedFeature& feature, double stiffness) {
  const SceneGeometry scene = cube_over_floor();
  SessionSettings settings = setup.settings;
  settings.stiffness = stiffness;
  const CubeTouch touch(setup.device.mechanics, setup.hand);
  SimulatedHandInterface interface(touch.motion(scene.tool, feature), setup.device, setup.hand);
  DecayJudge judge(touch.end());
  bool touched = false;
  const double gyration_length = scene.tool.mass.gyration_length();
  run_closed_loop(scene, settings, interface, touch.end() + DecayJudge::kDuration, [&](const TickRecord& record) {
    touched = touched || record.displayed.force.vector().norm() > tolerance::kFreeWrench;
    const Twist& V_WG = interface.grip().V_WG;
    return judge.add(record.time, std::hypot(V_WG.linear.norm(), gyration_length * V_WG.angular.norm()));
  });
  if (!touched) throw InputError("the method displayed no force when the hand touched: there is nothing to judge.");
  return judge.decayed();
}

StabilityRow measure_stability(const StabilitySetup& setup, const TouchedFeature& feature, const Progress& progress) {
  const SessionSettings& settings = setup.settings;
  StabilityRow row;
  row.method = settings.method;
  row.contact = feature.name;
  row.metric_length = settings.metric_length;
  row.bounds = stiffness_bounds(
      {setup.device, setup.hand, 1.0 / settings.haptic_rate, settings.damping, settings.metric_length});

  // Bracketing takes two to four runs, bisecting a factor of two to one part in a hundred seven.
  constexpr double kExpectedRuns = 10.0;
  double runs = 0.0;
  const auto is_stable = [&](double stiffness) {
    const bool stable = touch_decays(setup, feature, stiffness);
    progress(std::min(++runs / kExpectedRuns, 1.0));
    return stable;
  };
  const double guess = 0.75 * row.bounds.linear;
  row.limit = find_stability_limit(is_stable, guess, kStabilityWidth);
  return row;
}

}  // namespace tegotae
