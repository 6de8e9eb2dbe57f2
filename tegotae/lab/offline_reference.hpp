// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/lab/reference.hpp>

namespace tegotae {

/// m that the farthest point of the tool moves, with the hand, from one solution of the offline reference to the next.
/// Where there is one answer alone a twentyfold step gives the same; where there are several, near each other (a knob
/// of many facets on an edge), the tool must not leap from one to the next before the one where it is ends.
inline constexpr double kReferenceHandStep = 5e-6;

/// The frictionless, quasi-static right answer of any motion on any static scene, solved offline: the tool's pose
/// nearest to the hand's in the metric of the settings (about the centre of mass), every pair of a tool piece and a
/// body piece at least the skin of `proxy` apart, followed as a local minimum from the first pose on, so that nothing
/// is jumped. Two convex polytopes are apart by the skin exactly when a plane separates their vertices by it
/// (Farkas), so the planes are unknowns beside the pose and neither distances nor contact points are computed. Walls
/// that contradict each other get the pose of least sum of squared deepest violations. Spheres and capsules are exact;
/// cylinders and ellipsoids are their inscribed polytopes; moving bodies stay where they are first.
/// What the hand starts less than 1 mm inside pushes the tool out; starting deeper, the ticks are undefined until the
/// hand is outside. So is a tick at which the solution did not converge.
/// A tick is said to snap where the tool moves, in one of its steps, five times the hand's way and 10 um more.
/// `hand_step` (m): the hand's way from solution to solution. Allocates; takes about a millisecond a tick of 20 um.
Reference offline_reference(double hand_step = kReferenceHandStep);

}  // namespace tegotae
