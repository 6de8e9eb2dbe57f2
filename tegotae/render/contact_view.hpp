// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/math/plain.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

namespace tegotae {

/// Capacities of a contact view: what a person can take in at a glance. Beyond, the first are shown.
inline constexpr int kMaxViewedPlanes = 64;
inline constexpr int kMaxViewedPoints = 256;
inline constexpr int kMaxViewedAnchors = 16;

/// The plane between the tool and a near object.
struct ViewedPlane {
  PlainVector3 p_W;             ///< on the object, m
  PlainVector3 n_W;             ///< unit, out of the object
  double distance = 0.0;        ///< of the pieces, m; negative: penetration depth
  std::int32_t tool_piece = 0;  ///< pieces that it stands between
  std::int32_t body = 0;
  std::int32_t body_piece = 0;
};

/// A contact point.
struct ViewedPoint {
  PlainVector3 p_W;    ///< on the tool, m
  double gap = 0.0;    ///< m; negative: penetration
  double force = 0.0;  ///< N along the normal; > 0: it is active
};

/// Where friction holds the tool on an object.
struct ViewedAnchor {
  PlainVector3 p_W;           ///< on the object: where the surfaces would rub without stretch, m
  PlainVector3 stretch_W;     ///< from there to the centre of pressure on the tool, m
  double normal_force = 0.0;  ///< N
  std::uint8_t slipping = 0;  ///< 1: at the limit of friction
};

/// What a method worked with in a tick, for people to look at. Trivially copyable, so that it leaves the haptic thread
/// as a latest value.
struct ContactView {
  double time = 0.0;  ///< s, of the tick
  std::int32_t plane_count = 0;
  std::int32_t point_count = 0;
  std::int32_t anchor_count = 0;
  std::array<ViewedPlane, kMaxViewedPlanes> planes;
  std::array<ViewedPoint, kMaxViewedPoints> points;
  std::array<ViewedAnchor, kMaxViewedAnchors> anchors;

  std::span<const ViewedPlane> used_planes() const noexcept { return used(planes, plane_count); }
  std::span<const ViewedPoint> used_points() const noexcept { return used(points, point_count); }
  std::span<const ViewedAnchor> used_anchors() const noexcept { return used(anchors, anchor_count); }

  void clear() noexcept { plane_count = point_count = anchor_count = 0; }
  // What does not fit is left out.
  void add(const ViewedPlane& plane) noexcept { append(planes, plane_count, plane); }
  void add(const ViewedPoint& point) noexcept { append(points, point_count, point); }
  void add(const ViewedAnchor& anchor) noexcept { append(anchors, anchor_count, anchor); }

 private:
  template <class T, std::size_t kSize>
  static std::span<const T> used(const std::array<T, kSize>& all, std::int32_t count) noexcept {
    return {all.data(), static_cast<std::size_t>(count)};
  }
  template <class T, std::size_t kSize>
  static void append(std::array<T, kSize>& all, std::int32_t& count, const T& value) noexcept {
    if (static_cast<std::size_t>(count) < kSize) all[static_cast<std::size_t>(count++)] = value;
  }
};
static_assert(std::is_trivially_copyable_v<ContactView>);

}  // namespace tegotae
