// SPDX-License-Identifier: Apache-2.0
#pragma once

/// Tolerances of this layer, each with its unit and reason.
namespace tegotae::tolerance {

/// Stationarity at which the constraint solver stops: |K (x - x_free) - J^T lambda| in the norm of K^-1, relative to
/// |x - x_free| in the norm of K. Leaves room below the 1e-10 that the problem promises.
inline constexpr double kStationarity = 1e-12;

/// The part of the stationarity that rounding alone leaves, relative to the sum of all pushing forces (opposed walls
/// push against each other with forces far above the resulting one): about sixty units in the last place.
inline constexpr double kStationarityRounding = 1.5e-14;

/// Violation of a hard row at which it counts as kept, relative to the greatest violation at x_free (each divided by
/// the row's norm): below the 1e-10
/// that the problem promises, above what rounding of gaps a thousand times larger leaves.
inline constexpr double kHardRowViolation = 1e-12;

/// Violation of hard rows, relative to the greatest at x_free, above which the set counts as infeasible: what the
/// last proximal stage cannot remove. At 1 mm of violation this is 0.1 pm.
inline constexpr double kInfeasibleViolation = 1e-10;

/// Violation, relative as above, above which two proximal stages without progress already prove infeasibility: at 1 mm
/// this is 1 nm. Below it slowly converging near-parallel rows look alike and get all stages.
inline constexpr double kClearlyInfeasibleViolation = 1e-6;

/// Compliance of a row, relative to the greatest compliance J K^-1 J^T that the coupling itself has at any row, below
/// which the row is treated as hard, by proximal stages: with a thousand such rows Newton's matrix in double precision
/// would keep only half of its digits. The usual rows are thirty times softer.
inline constexpr double kDirectCompliance = 3e-7;

/// Compliance of a contact row, relative to the coupling's own at the same point, (1 + (r x n)^2 / l^2) / k. Makes the
/// multipliers unique, so that the load on a face does not flip between its corners under noise, and the problem never
/// infeasible; biases the force by this part, ten thousand times less than a hand tells apart.
inline constexpr double kRowCompliance = 1e-5;

/// Violation that is left of a contact row, as a part of the deepest penetration, above which the constraints
/// contradict each other: a compliant row that is obeyed leaves a hundred-thousandth.
inline constexpr double kCompromise = 0.01;

/// Share of the slope at its start at which a line search ends: the direction is renewed anyway, so more is wasted.
inline constexpr double kLineSearchSlope = 1e-2;

/// m. Distance that the proxy keeps from the world, so that the closest pair has a direction. Times the stiffness it is
/// the force felt too early: where that would exceed `kSkinForce` the skin is thinner.
inline constexpr double kSkin = 2e-6;

/// N. The least force that a hand feels.
inline constexpr double kSkinForce = 0.04;

/// m. A step that moves no point of the tool further ends a tick: at 9000 N/m it is 3 mN.
inline constexpr double kSettledStep = 0.3e-6;

/// m. The same of what the loads' arms, turned by the step, would still move: at 1000 N/m, with a metric length of the
/// tool's size, it is 1 mN.
inline constexpr double kSettledArms = 1e-6;

/// N. A friction limit that changed by less since the last linearisation does not ask for another one: half the least
/// force that a hand feels.
inline constexpr double kSettledLoad = 0.02;

/// m. Least margin of a linearisation: a hand at rest trembles by less in a millisecond.
inline constexpr double kLeastMargin = 20e-6;

/// How many times the way of hand and bodies in a tick the first linearisation of the tick may move the tool. Where
/// that does not suffice the margin of the next one grows.
inline constexpr double kMarginOfWay = 1.25;

/// The factor by which it grows.
inline constexpr double kMarginGrowth = 5.0;

/// How many times the way of hand and bodies in a tick any linearisation may move the tool, even if that exceeds the
/// margin: the linearisations of a tick together go twice as far as those.
inline constexpr double kMarginLimitOfWay = 0.5;

/// Linearisations of a tick: faces need one, edges on edges and the way over an edge two to four.
inline constexpr int kLinearisations = 4;

/// Halvings of a step that the geometry refuses, before the tool stays where it is.
inline constexpr int kHalvings = 8;

/// m/s at which a tool that is inside something is brought out: at 9000 N/m the force rises by 0.09 N a millisecond.
inline constexpr double kPushOutSpeed = 0.01;

/// m. What a pair between opposed walls may be deeper than the linear model says.
inline constexpr double kGuardSlack = 1e-7;

/// m. What rounding leaves in a gap, ten times over for bodies of a metre: a pair that a step does not change may not
/// refuse it.
inline constexpr double kGuardRounding = 1e-12;

/// Compliance of a friction bristle, relative to the coupling's own 1/k: under the force that stretches the coupling by
/// 3 mm the tool creeps by 30 nm before it slips.
inline constexpr double kBristleCompliance = 1e-5;

/// Distance queries that one tick may ask for refreshing pairs: at half a microsecond each a tenth of a tick.
inline constexpr int kDistanceBudget = 200;

/// Distance queries that one tick may ask for examining poses, each of up to four linearisations: twice as many.
inline constexpr int kTrialBudget = 400;

}  // namespace tegotae::tolerance
