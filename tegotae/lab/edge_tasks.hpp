// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/lab/experiment.hpp>

namespace tegotae {

// Frictionless tasks on the edges of things.

/// A flat box slides over a table's edge and drops; once flat, once turned and rolled, so that edges meet edges.
Experiment table_edge_experiment();

/// A plate on a pillar smaller than itself: its centre goes beyond one edge, then beyond a corner, tilting to and fro.
Experiment overhang_experiment();

/// A knob of 5000 vertices rolls over a table's edge.
Experiment knurl_experiment();

}  // namespace tegotae
