// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/shape/convex_hull.hpp>
#include <tegotae/shape/mesh.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace tegotae {

struct SplitSettings {
  int pieces = 32;          ///< at most so many
  int resolution = 100000;  ///< voxels that the mesh is filled with
  int vertices = 64;        ///< of a piece, at most
};

/// A mesh as convex pieces, each a hull of its own (Qhull).
struct ConvexSplit {
  std::vector<Polytope> pieces;
  double mesh_volume = 0.0;   ///< m^3
  double sum_volume = 0.0;    ///< of the pieces
  double union_volume = 0.0;  ///< of what they fill together, on a grid of points: to about 1 %
};

/// Splits a mesh; one that is convex stays whole. By V-HACD (Mamou), which runs in Node.js as the npm package vhacd-js.
/// The same mesh and settings give the same pieces. Takes seconds to minutes. Throws InputError where Node.js or the
/// package is missing, or where the mesh is not the surface of a solid; `file` is named in the message.
ConvexSplit split_convex(const Mesh& mesh, const SplitSettings& settings, const std::filesystem::path& file);

/// Writes each piece to `folder` as STEM-1.obj, STEM-2.obj, ..., and what a scene includes to use them:
/// STEM-assets.xml for <asset> and STEM-geoms.xml for a <body>. Returns the files. Throws InputError.
std::vector<std::filesystem::path> write_pieces(const ConvexSplit& split, const std::filesystem::path& folder,
                                                const std::string& stem);

/// Volume of what the hulls fill together, from `points_per_axis`^3 points evenly spread over their box, m^3.
double union_volume(const std::vector<Polytope>& pieces, int points_per_axis);

}  // namespace tegotae
