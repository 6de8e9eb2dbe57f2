// SPDX-License-Identifier: Apache-2.0
#include <tegotae/contact/clip_workspace.hpp>

#include <stdexcept>

namespace tegotae {
namespace {

int checked(int count) {
  if (count <= 0 || count >= IntersectionFeature::kIndexLimit / 2) {
    throw std::invalid_argument("a clip workspace holds polytopes of 1 to 524287 vertices and faces");
  }
  return count;
}

// A convex polytope of f faces has at most 2 f - 4 vertices.
int most_vertices(int max_faces) { return 4 * checked(max_faces); }

}  // namespace

ClipWorkspace::ClipWorkspace(int max_vertices, int max_faces)
    : max_vertices_(checked(max_vertices)),
      max_faces_(checked(max_faces)),
      tool_(max_vertices),
      object_(max_vertices),
      dilation_(max_vertices, max_faces),
      tool_planes_(static_cast<size_t>(max_faces)),
      object_planes_(static_cast<size_t>(max_faces)),
      polygon_(2 * max_faces + 8),
      vertices_(most_vertices(max_faces)) {}

bool ClipWorkspace::holds(const Shape& shape) const noexcept {
  if (shape.polytope == nullptr) return true;
  return static_cast<int>(shape.polytope->vertices.size()) <= max_vertices_ &&
         static_cast<int>(shape.polytope->faces.size()) <= max_faces_;
}

}  // namespace tegotae
