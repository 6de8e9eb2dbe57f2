// SPDX-License-Identifier: Apache-2.0
#include <tegotae/world/scene_summary.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace tegotae {
namespace {

// "2 boxes" is beyond what the kinds' names need: "2 box".
std::string kinds_of(const std::vector<Shape>& pieces) {
  std::map<ShapeKind, int> counts;
  for (const Shape& piece : pieces) ++counts[piece.kind];
  std::string text;
  for (const auto& [kind, count] : counts) {
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, name_of(kind));
  }
  return text;
}

size_t vertex_count(const std::vector<Shape>& pieces) {
  size_t count = 0;
  for (const Shape& piece : pieces) count += piece.is_polytope() ? piece.polytope->vertices.size() : 0;
  return count;
}

}  // namespace

std::string scene_summary(const SceneGeometry& scene) {
  std::vector<Shape> pieces;
  for (const Body& body : scene.bodies) pieces.insert(pieces.end(), body.pieces.begin(), body.pieces.end());
  const size_t vertices = vertex_count(scene.tool.pieces);
  return fmt::format("tool '{}': {}{}; {:.4g} kg, gyration length {:.4g} m\nworld: {} bodies, {} of them moving; {}\n",
                     scene.tool.name, kinds_of(scene.tool.pieces),
                     vertices > 0 ? fmt::format(" ({} vertices)", vertices) : "", scene.tool.mass.mass,
                     scene.tool.mass.gyration_length(), scene.bodies.size(), scene.moving_count, kinds_of(pieces));
}

}  // namespace tegotae
