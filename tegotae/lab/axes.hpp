// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/lab/experiment.hpp>

#include <numbers>

namespace tegotae {

inline constexpr double kDegree = std::numbers::pi / 180.0;  ///< rad

// The axes along which experiments report.

inline const ReportedAxis kAlongX{"x", Vector3::UnitX()}, kAlongY{"y", Vector3::UnitY()},
    kAlongZ{"z", Vector3::UnitZ()};

}  // namespace tegotae
