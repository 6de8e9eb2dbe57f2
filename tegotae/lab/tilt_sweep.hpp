// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/lab/experiment.hpp>

namespace tegotae {

/// The paper's cube, its centre a little too low for its face, swept slowly through the flat pose: whether the force is
/// continuous while contact points come and go. Rendered with the penetrating points only (the paper) and with all near
/// ones, metric length of gyration.
Experiment tilt_sweep_experiment();

}  // namespace tegotae
