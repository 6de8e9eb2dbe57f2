// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/lab/cube_touch.hpp>
#include <tegotae/lab/session.hpp>
#include <tegotae/lab/stability_search.hpp>
#include <tegotae/lab/stiffness_bounds.hpp>

#include <string>

namespace tegotae {

/// Who holds the tool, and how it is rendered, while stability is measured.
struct StabilitySetup {
  SimulatedDevice device;
  HandImpedance hand;
  SessionSettings settings;  ///< stiffness: of the energy measurement; the search sets its own
};

/// One row of the table: how stiff a method may be at one contact.
struct StabilityRow {
  std::string method;
  std::string contact;
  double metric_length = 0.0;  ///< m
  StabilityLimit limit;
  StiffnessBounds bounds;

  double ratio_to_linear() const noexcept { return limit.largest_stable / bounds.linear; }
};

/// Part of the stiffness between the largest that was seen stable and the smallest that was not.
inline constexpr double kStabilityWidth = 0.01;

/// Whether the touch of `feature` (CubeTouch) decays (DecayJudge) at `stiffness` (N/m), in closed loop. The speed that
/// is judged is the grip's true one, sqrt(v^2 + l_g^2 w^2) with the cube's gyration length l_g. Throws InputError where
/// the method displays nothing.
bool touch_decays(const StabilitySetup& setup, const TouchedFeature& feature, double stiffness);

/// The largest stiffness at which it does, by bisection; tells progress from 0 to 1.
StabilityRow measure_stability(const StabilitySetup& setup, const TouchedFeature& feature, const Progress& progress);

}  // namespace tegotae
