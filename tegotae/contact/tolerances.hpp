// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace tegotae::tolerances {

// Every tolerance of the contact layer, with its unit and its reason. Lengths are at haptic scale: at a stiffness of
// 9000 N/m, 4.4e-6 m is the smallest force that a hand feels (0.04 N).

/// Dimensionless. A distance is reported only if the support planes prove at least this part of it.
inline constexpr double kCertificate = 0.999;

}  // namespace tegotae::tolerances
