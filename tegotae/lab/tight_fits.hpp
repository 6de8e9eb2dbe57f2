// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/lab/experiment.hpp>

namespace tegotae {

// Tools between walls that oppose each other. No friction.

/// A block of 20.1 mm, found in a slot of 20 mm; moved in it, pulled out and pressed onto its rims.
Experiment slot_narrow_experiment();

/// A block of 20 mm put into a slot of 20.02 mm and wobbled.
Experiment slot_play_experiment();

/// A block pressed between two walls 5 degrees off the vertical.
Experiment wedge_experiment();

/// A square peg put into a hole with 0.1 mm of clearance: a tilt of 10 degrees is taken out before entry, then it is
/// pushed to the bottom and wobbled.
Experiment peg_in_hole_experiment();

}  // namespace tegotae
