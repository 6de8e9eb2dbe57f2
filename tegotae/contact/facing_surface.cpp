// SPDX-License-Identifier: Apache-2.0
#include <tegotae/contact/facing_surface.hpp>

#include <tegotae/contact/tolerances.hpp>
#include <tegotae/math/rotation.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tegotae {

OverlayFrame::OverlayFrame(const Vector3& origin, const Vector3& n) noexcept
    : origin_W(origin), x_W(any_perpendicular(n)), y_W(n.cross(x_W)), n_W(n) {}

/// The frame's axes seen from the shape, up being towards the other shape.
struct FacingSurface::Axes {
  Vector3 x, y, up;       // unit, shape's frame
  double x0, y0, h0;      // of the shape frame's origin, m
  double xc = 0, yc = 0;  // of a point strictly inside the shape, m

  Axes(const PlacedShape& placed, const OverlayFrame& frame, GapSide side) noexcept {
    const Matrix3 R_SW = placed.R_WS.transpose();
    const Vector3 up_W = side == GapSide::kObject ? frame.n_W : Vector3(-frame.n_W);
    const Vector3 offset = placed.p_WS - frame.origin_W;
    x = R_SW * frame.x_W;
    y = R_SW * frame.y_W;
    up = R_SW * up_W;
    x0 = frame.x_W.dot(offset);
    y0 = frame.y_W.dot(offset);
    h0 = up_W.dot(offset);
  }

  Vertex vertex(const Vector3& p_S, int feature, bool faces) const noexcept {
    return {x.dot(p_S) + x0, y.dot(p_S) + y0, up.dot(p_S) + h0, feature, faces};
  }
};

FacingSurface::FacingSurface(int max_vertices) {
  // Euler: a polytope of v vertices has at most 3 v - 6 edges and 2 v - 4 faces. A cylinder's cap needs its corners.
  const auto v = static_cast<size_t>(std::max(max_vertices, kCapCorners + 2));
  vertices_.reserve(v);
  pending_.reserve(v);
  edges_.reserve(3 * v);
  rims_.reserve(v + 2);
  faces_.reserve(2 * v);
  vertex_marks_.resize(v);
  edge_marks_.resize(3 * v);
  face_marks_.resize(2 * v);
}

void FacingSurface::fill(const PlacedShape& placed, const OverlayFrame& frame, GapSide side, const Vector3& p_W_nearest,
                         double depth, int hint, const FacingSurface* other) noexcept {
  vertices_.clear();
  edges_.clear();
  faces_.clear();
  rims_.clear();
  dropped_ = 0;
  has_ridge_ = false;
  const Shape& shape = *placed.shape;
  Axes axes(placed, frame, side);
  switch (shape.kind) {
    case ShapeKind::kBox:
    case ShapeKind::kHull:
      fill_polytope(*shape.polytope, axes, depth, hint, other);
      break;
    case ShapeKind::kCapsule:
      fill_capsule(shape, axes, depth);
      break;
    case ShapeKind::kCylinder:
      fill_cylinder(shape, axes, depth);
      break;
    case ShapeKind::kSphere:
    case ShapeKind::kEllipsoid:
      vertices_.push_back(axes.vertex(placed.to_shape(p_W_nearest), 0, true));
      break;
    case ShapeKind::kPlane:
      faces_.push_back({axes.h0, 0.0, 0.0});
      break;
  }
}

bool FacingSurface::height_at(double x, double y, double& h) const noexcept {
  if (faces_.empty()) return false;
  for (const Rim& rim : rims_) {
    if (rim.nx * x + rim.ny * y > rim.c + tolerances::kOutline) return false;
  }
  h = 1e300;
  for (const Face& face : faces_) h = std::min(h, face.h0 + face.gx * x + face.gy * y);
  return true;
}

void FacingSurface::fill_polytope(const Polytope& polytope, const Axes& axes, double depth, int hint,
                                  const FacingSurface* other) noexcept {
  if (polytope.vertices.size() > vertex_marks_.size()) {
    dropped_ = static_cast<int>(polytope.vertices.size());
    return;
  }
  ++stamp_;
  const int count = static_cast<int>(polytope.vertices.size());
  const int start = support_vertex(polytope, axes.up, std::clamp(hint, 0, count - 1));
  Axes own = axes;
  const Vertex inside = axes.vertex(polytope.centroid, 0, false);
  own.xc = inside.x;
  own.yc = inside.y;
  const double highest = axes.vertex(polytope.vertices[static_cast<size_t>(start)], start, true).h;
  const double lowest = highest - depth;
  walk(polytope, own, lowest, start);
  if (other != nullptr && other->is_one_face_over(vertices_)) {
    for (Vertex& vertex : vertices_) vertex.faces = vertex.h >= lowest;
    return;
  }
  const size_t found = vertices_.size();
  for (size_t i = 0; i < found; ++i) {
    if (!(vertices_[i].h >= lowest)) continue;
    for (const int edge : polytope.edges_of(vertices_[i].feature)) visit_edge(polytope, own, lowest, edge);
  }
}

bool FacingSurface::is_one_face_over(const std::vector<Vertex>& places) const noexcept {
  if (faces_.size() != 1) return false;
  double x_low = 1e300, x_high = -1e300, y_low = 1e300, y_high = -1e300;
  for (const Vertex& place : places) {
    x_low = std::min(x_low, place.x), x_high = std::max(x_high, place.x);
    y_low = std::min(y_low, place.y), y_high = std::max(y_high, place.y);
  }
  return std::all_of(rims_.begin(), rims_.end(), [=](const Rim& rim) {
    return rim.nx * (rim.nx > 0.0 ? x_high : x_low) + rim.ny * (rim.ny > 0.0 ? y_high : y_low) < rim.c;
  });
}

// Vertices above `lowest` hang together over edges, as the part of a convex polytope above a plane is convex.
void FacingSurface::walk(const Polytope& polytope, const Axes& axes, double lowest, int start) noexcept {
  pending_.clear();
  local_vertex(polytope, axes, lowest, start);
  while (!pending_.empty()) {
    const int vertex = pending_.back();
    pending_.pop_back();
    for (const int neighbor : polytope.neighbors_of(vertex)) local_vertex(polytope, axes, lowest, neighbor);
  }
}

int FacingSurface::local_vertex(const Polytope& polytope, const Axes& axes, double lowest, int vertex) noexcept {
  Mark& mark = vertex_marks_[static_cast<size_t>(vertex)];
  if (mark.stamp == stamp_) return mark.local;
  mark = {stamp_, static_cast<int>(vertices_.size())};
  vertices_.push_back(axes.vertex(polytope.vertices[static_cast<size_t>(vertex)], vertex, false));
  if (vertices_.back().h >= lowest) pending_.push_back(vertex);
  return mark.local;
}

void FacingSurface::visit_edge(const Polytope& polytope, const Axes& axes, double lowest, int edge) noexcept {
  Mark& mark = edge_marks_[static_cast<size_t>(edge)];
  if (mark.stamp == stamp_) return;
  mark.stamp = stamp_;
  const Polytope::Edge& ends = polytope.edges[static_cast<size_t>(edge)];
  const int a = local_vertex(polytope, axes, lowest, ends.vertex[0]);
  const int b = local_vertex(polytope, axes, lowest, ends.vertex[1]);
  int seen = 0;
  for (const int face : ends.face) {
    const Polytope::Face& plane = polytope.faces[static_cast<size_t>(face)];
    const double rise = plane.normal.dot(axes.up);
    if (rise <= tolerances::kUpright) continue;
    ++seen;
    Mark& face_mark = face_marks_[static_cast<size_t>(face)];
    if (face_mark.stamp == stamp_) continue;
    face_mark.stamp = stamp_;
    add_face(plane.normal, plane.offset, rise, axes);
  }
  if (seen == 0) return;
  Vertex& from = vertices_[static_cast<size_t>(a)];
  Vertex& to = vertices_[static_cast<size_t>(b)];
  from.faces = from.faces || from.h >= lowest;
  to.faces = to.faces || to.h >= lowest;
  add_edge(from, to, edge);
  if (seen == 1) add_rim(from, to, axes.xc, axes.yc);
}

// The plane normal . p = offset (shape's frame) solved for the height; `rise` is normal . up.
void FacingSurface::add_face(const Vector3& normal, double offset, double rise, const Axes& axes) noexcept {
  const double gx = -normal.dot(axes.x) / rise;
  const double gy = -normal.dot(axes.y) / rise;
  faces_.push_back({offset / rise + axes.h0 - gx * axes.x0 - gy * axes.y0, gx, gy});
}

void FacingSurface::add_edge(const Vertex& a, const Vertex& b, int feature) noexcept {
  const double dx = b.x - a.x, dy = b.y - a.y;
  edges_.push_back({a.x, a.y, a.h, dx, dy, b.h - a.h, dx * dx + dy * dy, feature});
}

// Along the first two vertices.
void FacingSurface::add_ridge(double radius, int feature) noexcept {
  vertices_[0].radius = vertices_[1].radius = radius;
  add_edge(vertices_[0], vertices_[1], feature);
  edges_.back().radius = radius;
  has_ridge_ = true;
}

void FacingSurface::add_rim(const Vertex& a, const Vertex& b, double x_inside, double y_inside) noexcept {
  const double dx = b.x - a.x, dy = b.y - a.y;
  const double length = std::hypot(dx, dy);
  if (length < 0.5 * tolerances::kOutline) return;
  Rim rim{dy / length, -dx / length, 0.0};
  rim.c = rim.nx * a.x + rim.ny * a.y;
  if (rim.nx * x_inside + rim.ny * y_inside > rim.c) rim = {-rim.nx, -rim.ny, -rim.c};
  rims_.push_back(rim);
}

// The line of points nearest to the other shape: the axis shifted by the radius.
void FacingSurface::fill_capsule(const Shape& shape, const Axes& axes, double depth) noexcept {
  const Vector3 end(0.0, 0.0, shape.size.y());
  const Vector3 shift = shape.size.x() * axes.up;
  vertices_.push_back(axes.vertex(shift - end, 0, true));
  vertices_.push_back(axes.vertex(shift + end, 1, true));
  const double lowest = std::max(vertices_[0].h, vertices_[1].h) - depth;
  for (Vertex& vertex : vertices_) vertex.faces = vertex.h >= lowest;
  add_ridge(shape.size.x(), 0);
}

void FacingSurface::fill_cylinder(const Shape& shape, const Axes& axes, double depth) noexcept {
  const double radius = shape.size.x();
  Vector3 across(axes.up.x(), axes.up.y(), 0.0);
  const double sine = across.norm();
  across = sine > tolerances::kUpright ? Vector3(across / sine) : Vector3::UnitX();
  const Vector3 end(0.0, 0.0, axes.up.z() > 0.0 ? shape.size.y() : -shape.size.y());
  vertices_.push_back(axes.vertex(radius * across + end, 0, true));
  const double lowest = vertices_[0].h - depth;
  if (sine > tolerances::kUpright) {
    vertices_.push_back(axes.vertex(radius * across - end, kCapCorners, true));
    vertices_[1].faces = vertices_[1].h >= lowest;
    add_ridge(radius, kCapCorners);
  }
  if (std::abs(axes.up.z()) > tolerances::kUpright) fill_cap(shape, axes, lowest);
}

// The facing cap. Its first corner, the nearest, is vertex 0 already.
void FacingSurface::fill_cap(const Shape& shape, const Axes& axes, double lowest) noexcept {
  const double side = axes.up.z() > 0.0 ? 1.0 : -1.0;
  const Vector3 centre(0.0, 0.0, side * shape.size.y());
  const Vector3 first(std::hypot(axes.up.x(), axes.up.y()) > tolerances::kUpright
                          ? Vector3(axes.up.x(), axes.up.y(), 0.0).normalized()
                          : Vector3::UnitX());
  const Vector3 second = Vector3::UnitZ().cross(first);
  const Vertex inside = axes.vertex(centre, 0, false);
  add_face(side * Vector3::UnitZ(), shape.size.y(), side * axes.up.z(), axes);
  int previous = 0;
  for (int k = 1; k <= kCapCorners; ++k) {
    int current = 0;
    if (k < kCapCorners) {
      const double turn = 2.0 * std::numbers::pi * k / kCapCorners;
      const Vector3 p = centre + shape.size.x() * (std::cos(turn) * first + std::sin(turn) * second);
      current = static_cast<int>(vertices_.size());
      vertices_.push_back(axes.vertex(p, k, true));
      vertices_.back().faces = vertices_.back().h >= lowest;
    }
    const Vertex& a = vertices_[static_cast<size_t>(previous)];
    const Vertex& b = vertices_[static_cast<size_t>(current)];
    if (a.faces || b.faces) {
      add_edge(a, b, k - 1);
      add_rim(a, b, inside.x, inside.y);
    }
    previous = current;
  }
}

}  // namespace tegotae
