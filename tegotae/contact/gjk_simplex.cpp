// SPDX-License-Identifier: Apache-2.0
#include <tegotae/contact/gjk_simplex.hpp>

#include <tegotae/contact/tolerances.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace tegotae::gjk {
namespace {

// The part of a simplex that carries its point nearest the origin: up to three of its vertices.
struct Feature {
  std::array<int, 3> vertex{};
  std::array<double, 3> weight{};
  int count = 0;
  Vector3 v = Vector3::Zero();
  Vector3 normal = Vector3::Zero();  // of a triangle, any length and sign; zero where v is the better direction
  double squared_distance = 0.0;
};

const Vector3& point(const Simplex& simplex, int i) noexcept { return simplex.point[static_cast<size_t>(i)].w; }

Feature nearest_on_point(const Simplex& simplex, int i) noexcept {
  Feature feature;
  feature.vertex[0] = i;
  feature.weight[0] = 1.0;
  feature.count = 1;
  feature.v = point(simplex, i);
  feature.squared_distance = feature.v.squaredNorm();
  return feature;
}

Feature nearest_on_segment(const Simplex& simplex, int i, int j) noexcept {
  const Vector3& p = point(simplex, i);
  const Vector3 edge = point(simplex, j) - p;
  const double length2 = edge.squaredNorm();
  const double along = -p.dot(edge);
  if (!(along > 0.0)) return nearest_on_point(simplex, i);
  if (!(along < length2)) return nearest_on_point(simplex, j);
  const double t = along / length2;
  Feature feature;
  feature.vertex = {i, j, 0};
  feature.weight = {1.0 - t, t, 0.0};
  feature.count = 2;
  feature.v = p + t * edge;
  feature.v -= edge * (edge.dot(feature.v) / length2);  // what rounding left along the edge
  feature.squared_distance = feature.v.squaredNorm();
  return feature;
}

void keep_nearer(Feature& best, const Feature& other) noexcept {
  if (other.squared_distance < best.squared_distance) best = other;
}

Feature nearest_on_edges(const Simplex& simplex, const std::array<int, 3>& vertex,
                         const std::array<double, 3>& area) noexcept {
  Feature best;
  best.squared_distance = 1e300;
  for (size_t k = 0; k < 3; ++k) {
    if (area[k] <= 0.0) {
      keep_nearer(best, nearest_on_segment(simplex, vertex[(k + 1) % 3], vertex[(k + 2) % 3]));
    }
  }
  return best;
}

Feature nearest_on_triangle(const Simplex& simplex, int i, int j, int k) noexcept {
  const Vector3& a = point(simplex, i);
  const Vector3& b = point(simplex, j);
  const Vector3& c = point(simplex, k);
  const Vector3 ab = b - a;
  const Vector3 ac = c - a;
  const Vector3 normal = ab.cross(ac);
  const double normal2 = normal.squaredNorm();
  if (!(normal2 > tolerances::kSliver * tolerances::kSliver * ab.squaredNorm() * ac.squaredNorm())) {
    return nearest_on_edges(simplex, {i, j, k}, {0.0, 0.0, 0.0});
  }
  // Signed areas (times |normal|) of the triangles that the origin, projected, makes with the opposite edges.
  std::array<double, 3> area = {normal.dot(b.cross(c)), normal.dot(c.cross(a)), normal.dot(a.cross(b))};
  // Within rounding of an edge the triangle is taken: its normal does not suffer from a small distance.
  for (double& part : area) {
    if (std::abs(part) <= tolerances::kBarycentric * normal2) part = std::numeric_limits<double>::min();
  }
  if (area[0] <= 0.0 || area[1] <= 0.0 || area[2] <= 0.0) return nearest_on_edges(simplex, {i, j, k}, area);
  const double sum = area[0] + area[1] + area[2];
  Feature feature;
  feature.vertex = {i, j, k};
  feature.weight = {area[0] / sum, area[1] / sum, area[2] / sum};
  feature.count = 3;
  // Across the triangle's length rounding turns the normal by rounding / height of the triangle, and the sum of the
  // weighted vertices by rounding / distance: the better of the two, the normal for a contact, the sum for slivers far
  // away (curved shapes). Along its length both are made as good as the longer edge.
  const Vector3& length = ab.squaredNorm() > ac.squaredNorm() ? ab : ac;
  const double length2 = length.squaredNorm();
  const double over_plane = normal.dot(a);
  if (normal2 * normal2 > over_plane * over_plane * length2) {
    feature.normal = normal;
    feature.v = normal * (over_plane / normal2);
  } else {
    feature.v = a + feature.weight[1] * ab + feature.weight[2] * ac;
    feature.v -= length * (length.dot(feature.v) / length2);
  }
  feature.squared_distance = feature.v.squaredNorm();
  return feature;
}

double determinant(const Vector3& a, const Vector3& b, const Vector3& c) noexcept { return a.dot(b.cross(c)); }

// Sets the weights and returns true if the origin lies strictly inside.
bool origin_inside(Simplex& simplex, std::array<double, 4>& volume) noexcept {
  const Vector3 &a = point(simplex, 0), &b = point(simplex, 1), &c = point(simplex, 2), &d = point(simplex, 3);
  const Vector3 ab = b - a;
  const Vector3 ac = c - a;
  const Vector3 ad = d - a;
  const double total = determinant(ab, ac, ad);
  if (!(std::abs(total) > tolerances::kSliver * ab.norm() * ac.norm() * ad.norm())) {
    volume.fill(0.0);
    return false;
  }
  volume = {determinant(b, c, d) / total, -determinant(a, c, d) / total, determinant(a, b, d) / total,
            -determinant(a, b, c) / total};
  simplex.weight = volume;
  return volume[0] > 0.0 && volume[1] > 0.0 && volume[2] > 0.0 && volume[3] > 0.0;
}

// Among triangles that are equally near (faces that face each other give four points of one plane) the largest has
// the best normal.
void keep_nearer_or_larger(Feature& best, const Feature& other) noexcept {
  const double slack = tolerances::kSliver * best.squared_distance;
  const bool tie = std::abs(other.squared_distance - best.squared_distance) <= slack;
  if (tie ? other.normal.squaredNorm() > best.normal.squaredNorm() : other.squared_distance < best.squared_distance) {
    best = other;
  }
}

Feature nearest_on_tetrahedron(const Simplex& simplex, const std::array<double, 4>& volume) noexcept {
  Feature best;
  best.squared_distance = 1e300;
  for (int k = 0; k < 4; ++k) {
    if (volume[static_cast<size_t>(k)] > 0.0) continue;
    keep_nearer_or_larger(best, nearest_on_triangle(simplex, (k + 1) % 4, (k + 2) % 4, (k + 3) % 4));
  }
  return best;
}

void keep(Simplex& simplex, const Feature& feature) noexcept {
  const bool unchanged = feature.count == simplex.count;
  if (!unchanged) {
    const std::array<MinkowskiPoint, 4> old = simplex.point;
    for (size_t k = 0; k < static_cast<size_t>(feature.count); ++k) {
      simplex.point[k] = old[static_cast<size_t>(feature.vertex[k])];
    }
  }
  for (size_t k = 0; k < static_cast<size_t>(feature.count); ++k) {
    const auto slot = unchanged ? static_cast<size_t>(feature.vertex[k]) : k;
    simplex.weight[slot] = feature.weight[k];
  }
  simplex.count = feature.count;
}

NearestPoint nearest_of(const Feature& feature) noexcept {
  NearestPoint nearest;
  nearest.v = feature.v;
  nearest.distance = std::sqrt(feature.squared_distance);
  if (feature.normal != Vector3::Zero()) {
    nearest.n = feature.normal.normalized();
    if (nearest.n.dot(feature.v) < 0.0) nearest.n = -nearest.n;
  } else if (nearest.distance > 0.0) {
    nearest.n = feature.v / nearest.distance;
  }
  return nearest;
}

}  // namespace

bool Simplex::contains(const MinkowskiPoint& p) const noexcept {
  for (size_t k = 0; k < static_cast<size_t>(count); ++k) {
    if (p.tool_vertex >= 0 && p.object_vertex >= 0) {
      if (point[k].tool_vertex == p.tool_vertex && point[k].object_vertex == p.object_vertex) return true;
    } else if (point[k].w == p.w) {
      return true;
    }
  }
  return false;
}

Vector3 Simplex::tool_point() const noexcept {
  Vector3 p = Vector3::Zero();
  for (size_t k = 0; k < static_cast<size_t>(count); ++k) p += weight[k] * point[k].tool;
  return p;
}

Vector3 Simplex::object_point() const noexcept {
  Vector3 p = Vector3::Zero();
  for (size_t k = 0; k < static_cast<size_t>(count); ++k) p += weight[k] * point[k].object;
  return p;
}

NearestPoint reduce_to_nearest(Simplex& simplex) noexcept {
  Feature feature;
  if (simplex.count == 1) {
    feature = nearest_on_point(simplex, 0);
  } else if (simplex.count == 2) {
    feature = nearest_on_segment(simplex, 0, 1);
  } else if (simplex.count == 3) {
    feature = nearest_on_triangle(simplex, 0, 1, 2);
  } else {
    std::array<double, 4> volume{};
    if (origin_inside(simplex, volume)) {
      NearestPoint inside;
      inside.inside = true;
      return inside;
    }
    feature = nearest_on_tetrahedron(simplex, volume);
  }
  keep(simplex, feature);
  return nearest_of(feature);
}

}  // namespace tegotae::gjk
