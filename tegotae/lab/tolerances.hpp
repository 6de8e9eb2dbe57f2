// SPDX-License-Identifier: Apache-2.0
#pragma once

/// Tolerances and limits of this layer, each with its unit and reason.
namespace tegotae::tolerance {

/// Greatest deviation of a recorded quaternion's norm from 1 that is taken for rounding (three decimals written) and
/// normalised away. More is a fault of the recording.
inline constexpr double kQuaternionNorm = 1e-3;

/// Ticks of one run, above which a trajectory's time column is taken not to be in seconds: at 1 kHz this is a day.
inline constexpr double kMaxTicks = 1e8;

/// Wrench (N, torque divided by the metric length) below which a tick counts as free of contact: above what rounding
/// leaves of a coupling of 1e6 N/m over lengths of a metre (2e-10 N), far below anything felt.
inline constexpr double kFreeWrench = 1e-9;

/// N m. Where a reference has less torque than this, it has none: rounding of forces up to 1e3 N at arms of a metre.
inline constexpr double kNoTorque = 1e-9;

/// N. The smallest force that a hand feels. A contact that is felt although nothing touches is a ghost; what the skin
/// of a method displays before contact is less.
inline constexpr double kFeltForce = 0.04;

}  // namespace tegotae::tolerance
