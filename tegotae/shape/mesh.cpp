// SPDX-License-Identifier: Apache-2.0
#include <tegotae/shape/mesh.hpp>

#include <fmt/format.h>

#include <map>
#include <utility>

namespace tegotae {

std::string flaw_of(const Mesh& mesh) {
  if (mesh.triangles.empty()) return "has no triangle";
  std::map<std::pair<int, int>, int> runs;  // directed edge, and how many triangles run through it
  for (const auto& triangle : mesh.triangles) {
    for (size_t k = 0; k < 3; ++k) ++runs[{triangle[k], triangle[(k + 1) % 3]}];
  }
  for (const auto& [edge, count] : runs) {
    const Vector3& p = mesh.vertices[static_cast<size_t>(edge.first)];
    const auto at = fmt::format("at ({:.6g}, {:.6g}, {:.6g})", p.x(), p.y(), p.z());
    const auto back = runs.find({edge.second, edge.first});
    if (count > 1) return "has an edge that two triangles run through in the same direction, " + at;
    if (back == runs.end()) return "has a hole or a border: an edge with one triangle only, " + at;
  }
  const double volume = volume_of(mesh);
  if (!(volume > 0.0)) return fmt::format("is inside out: it encloses a volume of {:.3g}", volume);
  return {};
}

double volume_of(const Mesh& mesh) noexcept {
  double volume = 0.0;
  // About a vertex of the mesh, so that one far from the origin loses no digits.
  const Vector3 origin = mesh.vertices.empty() ? Vector3(Vector3::Zero()) : mesh.vertices.front();
  for (const auto& triangle : mesh.triangles) {
    const auto corner = [&](size_t k) { return Vector3(mesh.vertices[static_cast<size_t>(triangle[k])] - origin); };
    volume += corner(0).dot(corner(1).cross(corner(2))) / 6.0;
  }
  return volume;
}

}  // namespace tegotae
