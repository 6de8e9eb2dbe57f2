// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/lab/experiment.hpp>

namespace tegotae {

// The tools of the paper's section 6 (figure 7), pressed on a floor until all vertices below are in it, then rolled to
// one side and to the other, and lifted.

/// The tool of 18 vertices, denser at one end.
Experiment tool_18_experiment();

/// The round tool of 230 vertices.
Experiment tool_230_round_experiment();

/// The flat-ended tool of 230 vertices: 115 coplanar ones on each end, the hard case.
Experiment tool_230_flat_experiment();

}  // namespace tegotae
