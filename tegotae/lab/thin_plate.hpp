// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/lab/experiment.hpp>

namespace tegotae {

// A plate of 1 mm that a flat box must not pop through. No friction.

/// Pressed 50 mm deep at several tilts.
Experiment thin_plate_press_experiment();

/// Struck at 1 m/s at several tilts, through to 50 mm, held, and back.
Experiment thin_plate_strike_experiment();

}  // namespace tegotae
