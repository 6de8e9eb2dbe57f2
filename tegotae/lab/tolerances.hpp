// SPDX-License-Identifier: Apache-2.0
#pragma once

/// Tolerances and limits of this layer, each with its unit and reason.
namespace tegotae::tolerance {

/// Greatest deviation of a recorded quaternion's norm from 1 that is taken for rounding (three decimals written) and
/// normalised away. More is a fault of the recording.
inline constexpr double kQuaternionNorm = 1e-3;

/// Ticks of one run, above which a trajectory's time column is taken not to be in seconds: at 1 kHz this is a day.
inline constexpr double kMaxTicks = 1e8;

}  // namespace tegotae::tolerance
