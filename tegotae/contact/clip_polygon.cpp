// SPDX-License-Identifier: Apache-2.0
#include <tegotae/contact/clip_polygon.hpp>

#include <tegotae/contact/tolerances.hpp>
#include <tegotae/math/rotation.hpp>

#include <utility>

namespace tegotae {

ClipPolygon::ClipPolygon(int capacity) : corners_(static_cast<size_t>(capacity)), next_(corners_.size()) {}

void ClipPolygon::start(const Vector3& centre, const Vector3& n, double half_edge) noexcept {
  const Vector3 u = half_edge * any_perpendicular(n), v = n.cross(u);
  corners_[0] = {centre - u - v, kNoLabel};
  corners_[1] = {centre + u - v, kNoLabel};
  corners_[2] = {centre + u + v, kNoLabel};
  corners_[3] = {centre - u + v, kNoLabel};
  size_ = 4;
}

bool ClipPolygon::reaches_beyond(const Vector3& n, double d) const noexcept {
  for (int i = 0; i < size_; ++i) {
    if (n.dot((*this)[i].p) - d > tolerances::kOnPlane) return true;
  }
  return false;
}

void ClipPolygon::cut(const Vector3& n, double d, int label) noexcept {
  if (!reaches_beyond(n, d)) return;
  next_size_ = 0;
  for (int i = 0; i < size_; ++i) {
    const Corner& here = (*this)[i];
    const Corner& there = (*this)[i + 1 == size_ ? 0 : i + 1];
    const double s = n.dot(here.p) - d, s_there = n.dot(there.p) - d;
    const bool inside = s <= tolerances::kOnPlane, there_inside = s_there <= tolerances::kOnPlane;
    // A corner in the plane stays itself: no second one arises beside it.
    if (inside && there_inside) {
      push(here.p, here.side);
    } else if (inside) {
      const bool on_plane = s >= -tolerances::kOnPlane;
      push(here.p, on_plane ? label : here.side);
      if (!on_plane) push(here.p + s / (s - s_there) * (there.p - here.p), label);
    } else if (there_inside && s_there < -tolerances::kOnPlane) {
      push(here.p + s / (s - s_there) * (there.p - here.p), here.side);
    }
  }
  std::swap(corners_, next_);
  size_ = next_size_;
}

void ClipPolygon::push(const Vector3& p, int side) noexcept {
  if (next_size_ < static_cast<int>(next_.size())) next_[static_cast<size_t>(next_size_++)] = {p, side};
}

}  // namespace tegotae
