// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/lab/reference.hpp>

namespace tegotae {

// Right answers of tools that rub on the floor z = 0, from statics and Coulomb's law. They hold where the tool touches
// as the name says; the stiffness and the metric length are the task's settings.

/// A face that stays flat on the floor, dragged and turned about the vertical. The tool follows the hand in height and
/// tilt; sideways it stays behind, held by a force of at most `friction` times the normal force, and in rotation by a
/// torque of at most that times `mean_distance` (m, of the face's places from its centre, under uniform pressure). The
/// two limits are taken each for itself: drag or twist, not both at once.
Reference flat_face_reference(double friction, double mean_distance);

/// A tool on one point `p_T` (m, in its frame; the middle of an edge that is dragged across itself), dragged along a
/// straight line. Force and torque balance at the turned pose, which is found by fixed-point iteration: with r the
/// point's place about the centre of mass and e the direction of the drag,
///
///     N = k (height of the point over the hand's),  f = N (z - friction e),  k l^2 theta = r x f
///
/// Not defined until the hand has gone far enough since it touched or turned around for the slip to be steady.
Reference dragged_point_reference(const Vector3& p_T, double friction);

}  // namespace tegotae
