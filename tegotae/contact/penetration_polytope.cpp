// SPDX-License-Identifier: Apache-2.0
#include <tegotae/contact/penetration_polytope.hpp>

#include <tegotae/contact/tolerances.hpp>

#include <cmath>
#include <utility>

namespace tegotae::gjk {
namespace {

size_t at(int index) noexcept { return static_cast<size_t>(index); }

}  // namespace

bool GrowingPolytope::add_face(int a, int b, int c, int& index) noexcept {
  if (free_count_ > 0) {
    index = free_[at(--free_count_)];
  } else if (face_count_ < kMaxFaces) {
    index = face_count_++;
  } else {
    return false;
  }
  const Vector3 ab = point_[at(b)] - point_[at(a)];
  const Vector3 ac = point_[at(c)] - point_[at(a)];
  const Vector3 normal = ab.cross(ac);
  const double length = normal.norm();
  Face& face = face_[at(index)];
  face = Face{};
  if (!(length > tolerances::kSliver * ab.norm() * ac.norm())) return false;
  face.vertex = {a, b, c};
  face.n = normal / length;
  face.d = face.n.dot(point_[at(a)]);
  face.alive = true;
  return true;
}

void GrowingPolytope::link(int inner, int from, int to, int outer) noexcept {
  for (size_t k = 0; k < 3; ++k) {
    Face& face = face_[at(outer)];
    if (face.vertex[k] == to && face.vertex[(k + 1) % 3] == from) face.across[k] = inner;
  }
}

bool GrowingPolytope::start(const std::array<Vector3, 4>& corner) noexcept {
  point_count_ = 4;
  for (size_t k = 0; k < 4; ++k) point_[k] = corner[k];
  const Vector3 ab = corner[1] - corner[0];
  const Vector3 ac = corner[2] - corner[0];
  if (ab.cross(ac).dot(corner[3] - corner[0]) > 0.0) std::swap(point_[1], point_[2]);
  // Corner 3 now lies below the face 0 1 2.
  constexpr int kFaces[4][3] = {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}};
  for (const auto& corners : kFaces) {
    int index = 0;
    if (!add_face(corners[0], corners[1], corners[2], index)) return false;
  }
  for (int f = 0; f < 4; ++f) {
    for (size_t k = 0; k < 3; ++k) {
      const int from = face_[at(f)].vertex[k];
      const int to = face_[at(f)].vertex[(k + 1) % 3];
      for (int g = 0; g < 4; ++g) link(f, from, to, g);
    }
  }
  return true;
}

const GrowingPolytope::Face& GrowingPolytope::nearest_face() const noexcept {
  int nearest = 0;
  double least = 1e300;
  for (int f = 0; f < face_count_; ++f) {
    if (face_[at(f)].alive && face_[at(f)].d < least) {
      least = face_[at(f)].d;
      nearest = f;
    }
  }
  return face_[at(nearest)];
}

// The faces that `p` sees, found by spreading over edges so that they hang together. Faces that p lies on are taken as
// seen: they are then replaced as a whole, and no triangle of the fan is flat.
void GrowingPolytope::collect_visible(int first, const Vector3& p) noexcept {
  visible_[0] = first;
  visible_count_ = 1;
  face_[at(first)].visible = true;
  for (int next = 0; next < visible_count_; ++next) {
    for (const int neighbor : face_[at(visible_[at(next)])].across) {
      Face& face = face_[at(neighbor)];
      if (face.visible || face.n.dot(p) - face.d <= -coplanar_) continue;
      face.visible = true;
      visible_[at(visible_count_++)] = neighbor;
    }
  }
}

bool GrowingPolytope::collect_horizon() noexcept {
  horizon_count_ = 0;
  for (int next = 0; next < visible_count_; ++next) {
    const Face& face = face_[at(visible_[at(next)])];
    for (size_t k = 0; k < 3; ++k) {
      if (face_[at(face.across[k])].visible) continue;
      if (horizon_count_ == kMaxFaces) return false;
      horizon_[at(horizon_count_++)] = {face.vertex[k], face.vertex[(k + 1) % 3], face.across[k]};
    }
  }
  return horizon_count_ >= 3;
}

// New faces from the apex to every edge of the horizon. False unless the horizon passes each of its points once.
bool GrowingPolytope::fan(int apex) noexcept {
  for (int e = 0; e < horizon_count_; ++e) fan_from_[at(horizon_[at(e)].from)] = fan_from_[at(horizon_[at(e)].to)] = -1;
  for (int e = 0; e < horizon_count_; ++e) {
    const HorizonEdge& edge = horizon_[at(e)];
    int index = 0;
    if (fan_from_[at(edge.from)] >= 0 || !add_face(edge.from, edge.to, apex, index)) return false;
    fan_from_[at(edge.from)] = index;
    face_[at(index)].across[0] = edge.outer_face;
    link(index, edge.from, edge.to, edge.outer_face);
  }
  for (int e = 0; e < horizon_count_; ++e) {
    const HorizonEdge& edge = horizon_[at(e)];
    const int here = fan_from_[at(edge.from)];
    const int next = fan_from_[at(edge.to)];
    if (next < 0) return false;
    face_[at(here)].across[1] = next;  // over the edge to -> apex
    face_[at(next)].across[2] = here;  // over the edge apex -> from
  }
  return true;
}

bool GrowingPolytope::grow(const Face& face, const Vector3& p) noexcept {
  if (point_count_ == kMaxPoints) return false;
  const int apex = point_count_++;
  point_[at(apex)] = p;
  collect_visible(static_cast<int>(&face - face_.data()), p);
  if (!collect_horizon()) return false;
  for (int next = 0; next < visible_count_; ++next) {
    const int dead = visible_[at(next)];
    face_[at(dead)].alive = face_[at(dead)].visible = false;
    free_[at(free_count_++)] = dead;
  }
  return fan(apex);
}

}  // namespace tegotae::gjk
