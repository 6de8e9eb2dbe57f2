// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/lab/experiment.hpp>

namespace tegotae {

// Tasks on a floor with a coefficient of friction of 0.5.

/// A face pressed with a force that leans from 0 to 40 degrees and back: it sticks, then slips at atan 0.5.
Experiment slope_experiment();

/// A cube dragged over the floor to and fro, on a face, on an edge across itself, on a vertex.
Experiment drag_face_experiment();
Experiment drag_edge_experiment();
Experiment drag_vertex_experiment();

/// A face pressed and twisted to and fro: a square, a disc.
Experiment twist_square_experiment();
Experiment twist_disc_experiment();

/// Mean distance of the places of a square of edge `edge` (m), and of a disc of radius `radius` (m), from its centre.
double mean_distance_in_square(double edge);
double mean_distance_in_disc(double radius);

}  // namespace tegotae
