// SPDX-License-Identifier: Apache-2.0
#include <tegotae/model/representation_builder.hpp>

#include <algorithm>
#include <set>

namespace tegotae {
namespace {

// m. Vertices within this height of the dilated object's plane lie on it: rounding of coordinates of a few metres, far
// below what is felt.
constexpr double kOnPlane = 1e-9;

// Feature of the closest point of curved pieces. Features of intersection vertices are packed kinds and indices, which
// stay far below.
constexpr std::uint64_t kClosestPointFeature = ~std::uint64_t{0};

bool is_curved(const Shape& shape) { return shape.is_bounded() && !shape.is_polytope(); }

// Of pieces that are a ball swept along a point or a line: whichever way they turn until the next model, they touch
// that far from it.
double rolling_radius(const Shape& shape) {
  return shape.kind == ShapeKind::kSphere || shape.kind == ShapeKind::kCapsule ? shape.size.x() : 0.0;
}

// Bodies that the pairs belong to.
std::int32_t count_bodies(std::span<const NearPair> pairs) {
  std::set<int> bodies;
  for (const NearPair& pair : pairs) bodies.insert(pair.body);
  return static_cast<std::int32_t>(bodies.size());
}

// Most vertices and faces of a piece.
struct LargestPiece {
  int vertices = 1;
  int faces = 1;

  void include(const std::vector<Shape>& pieces) {
    for (const Shape& piece : pieces) {
      if (!piece.polytope) continue;
      vertices = std::max(vertices, static_cast<int>(piece.polytope->vertices.size()));
      faces = std::max(faces, static_cast<int>(piece.polytope->faces.size()));
    }
  }
};

LargestPiece largest_piece(const SceneGeometry& geometry) {
  LargestPiece largest;
  largest.include(geometry.tool.pieces);
  for (const Body& body : geometry.bodies) largest.include(body.pieces);
  return largest;
}

}  // namespace

RepresentationBuilder::RepresentationBuilder(const SceneGeometry& geometry)
    : RepresentationBuilder(geometry, largest_piece(geometry).vertices, largest_piece(geometry).faces) {}

// Two convex polytopes of V and F vertices and faces meet in at most a few times as many vertices: an edge of one
// crosses the other's surface at most twice.
RepresentationBuilder::RepresentationBuilder(const SceneGeometry& geometry, int vertices, int faces)
    : geometry_(geometry), workspace_(vertices, faces), vertices_(static_cast<size_t>(6 * (vertices + faces))) {}

void RepresentationBuilder::build(std::span<const NearPair> pairs, const Pose& X_WT, std::span<const BodyState> bodies,
                                  IntermediateRepresentation& model) {
  model.near_object_count = count_bodies(pairs);
  model.plane_count = model.point_count = model.dropped_planes = model.dropped_points = 0;
  for (const NearPair& pair : pairs) {
    if (model.plane_count == kMaxPlanes) {
      ++model.dropped_planes;
      continue;
    }
    add_plane(pair, bodies, model);
    find_points(pair, X_WT, bodies);
    const int planes_left = std::min(static_cast<int>(pairs.size()), kMaxPlanes) - model.plane_count;
    add_points((kMaxContactPoints - model.point_count) / planes_left, model);
    ++model.plane_count;
  }
}

void RepresentationBuilder::add_plane(const NearPair& pair, std::span<const BodyState> bodies,
                                      IntermediateRepresentation& model) const {
  const Body& body = geometry_.bodies[static_cast<size_t>(pair.body)];
  ContactPlane& plane = model.planes[static_cast<size_t>(model.plane_count)];
  plane = {};
  plane.n_W = pair.n_W;
  plane.p_W = pair.p_WB;
  plane.tool_piece = pair.tool_piece;
  plane.body = pair.body;
  plane.body_piece = pair.body_piece;
  plane.moving_index = body.moving_index;
  plane.distance = pair.distance;
  if (body.moving_index >= 0) plane.p_WC = bodies[static_cast<size_t>(body.moving_index)].X_WB * body.p_BC;
}

// The intersection's vertices that are not on the object's plane, lowest first.
void RepresentationBuilder::find_points(const NearPair& pair, const Pose& X_WT, std::span<const BodyState> bodies) {
  const Body& body = geometry_.bodies[static_cast<size_t>(pair.body)];
  const Pose& X_WB = body.moving_index >= 0 ? bodies[static_cast<size_t>(body.moving_index)].X_WB : body.X_WB;
  const Shape& tool_shape = geometry_.tool.pieces[static_cast<size_t>(pair.tool_piece)];
  const Shape& object_shape = body.pieces[static_cast<size_t>(pair.body_piece)];
  const double dilation = std::max(0.0, pair.distance) + pair.reach;
  const int count = intersection_by_clipping(PlacedShape(tool_shape, X_WT), PlacedShape(object_shape, X_WB),
                                             dilation * pair.n_W, workspace_, vertices_);
  const Pose X_TW = X_WT.inverse();
  points_.clear();
  for (int i = 0; i < std::min(count, static_cast<int>(vertices_.size())); ++i) {
    const IntersectionVertex& vertex = vertices_[static_cast<size_t>(i)];
    if (pair.n_W.dot(vertex.p_W - pair.p_WB) < dilation - kOnPlane) {
      points_.push_back({X_TW * vertex.p_W, vertex.feature});
    }
  }
  if (is_curved(tool_shape) || is_curved(object_shape)) {
    const double radius = rolling_radius(tool_shape);
    points_.push_back({X_TW * (pair.p_WA + radius * pair.n_W), kClosestPointFeature, radius});
  }
  const Vector3 n_T = X_TW.q * pair.n_W;
  const auto height = [&n_T](const ContactPoint& point) { return n_T.dot(point.p_T.vector()) - point.radius; };
  std::stable_sort(points_.begin(), points_.end(),
                   [&](const ContactPoint& a, const ContactPoint& b) { return height(a) < height(b); });
}

// Each plane has its part of the capacity that is left; where its points do not all fit the lowest stay. In order of
// their features, as the interpolation matches them.
void RepresentationBuilder::add_points(int room, IntermediateRepresentation& model) {
  ContactPlane& plane = model.planes[static_cast<size_t>(model.plane_count)];
  const size_t kept = std::min(points_.size(), static_cast<size_t>(room));
  model.dropped_points += static_cast<std::int32_t>(points_.size() - kept);
  std::sort(points_.begin(), points_.begin() + static_cast<std::ptrdiff_t>(kept),
            [](const ContactPoint& a, const ContactPoint& b) { return a.feature < b.feature; });
  plane.first_point = model.point_count;
  plane.point_count = static_cast<std::int32_t>(kept);
  std::copy_n(points_.begin(), kept, model.points.begin() + model.point_count);
  model.point_count += plane.point_count;
}

}  // namespace tegotae
