// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/math/types.hpp>

#include <array>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace tegotae {

/// A surface of triangles: indices into `vertices`, counter-clockwise seen from outside.
struct Mesh {
  std::vector<Vector3> vertices;  ///< m (or whatever the file's unit is)
  std::vector<std::array<int, 3>> triangles;
};

/// A mesh file that cannot be used. `what()` is one sentence that names the file, the line where it is known, what is
/// wrong, and the mend.
struct MeshError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Reads a Wavefront OBJ (faces of more corners are fanned; everything but `v` and `f` is passed over) or an STL, as
/// text or binary (corners of equal coordinates become one vertex), by the file's ending. Throws MeshError.
Mesh read_mesh(const std::filesystem::path& file);

/// Why the mesh is not the surface of a solid, as the end of a sentence "the mesh ..."; empty where it is: every edge
/// joins two triangles that run through it in opposite directions, and the volume is positive.
std::string flaw_of(const Mesh& mesh);

/// Volume that the closed mesh encloses, m^3; negative where it is inside out.
double volume_of(const Mesh& mesh) noexcept;

}  // namespace tegotae
