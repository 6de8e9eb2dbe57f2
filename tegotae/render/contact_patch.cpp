// SPDX-License-Identifier: Apache-2.0
#include <tegotae/render/contact_patch.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace tegotae {
namespace {

using Corners = std::array<Vector2, 2 * kMaxPatchCorners + 2>;

double cross(const Vector2& a, const Vector2& b) noexcept { return a.x() * b.y() - a.y() * b.x(); }

bool turns_right(const Vector2& a, const Vector2& b, const Vector2& c) noexcept { return cross(b - a, c - a) <= 0.0; }

// Andrew's monotone chain (1979): the corners of the hull, counter-clockwise. `sorted` is sorted by x, then y.
int hull(std::span<const Vector2> sorted, Corners& corners) noexcept {
  const int n = static_cast<int>(sorted.size());
  int count = 0;
  const auto add = [&](const Vector2& p, int base) {
    while (count >= base + 2 &&
           turns_right(corners[static_cast<size_t>(count - 2)], corners[static_cast<size_t>(count - 1)], p)) {
      --count;
    }
    corners[static_cast<size_t>(count++)] = p;
  };
  for (int i = 0; i < n; ++i) add(sorted[static_cast<size_t>(i)], 0);
  const int base = count - 1;
  for (int i = n - 2; i >= 0; --i) add(sorted[static_cast<size_t>(i)], base);
  return count - 1;
}

// Integral of |r| from the foot of the perpendicular (length h) from the origin to s along an edge, over the triangle
// with the origin: the integral of (h sec)^3 / 3 over the angle.
double moment_to(double h, double s) noexcept {
  return h > 0.0 ? (h * s * std::hypot(h, s) + h * h * h * std::asinh(s / h)) / 6.0 : 0.0;
}

// Over the triangle of the origin and the edge a b, negative where the origin is to the edge's right.
double moment_of_edge(const Vector2& a, const Vector2& b) noexcept {
  const Vector2 d = b - a;
  const double length = d.norm();
  if (!(length > 0.0)) return 0.0;
  const double h = cross(a, b) / length;
  const double moment = moment_to(std::abs(h), b.dot(d) / length) - moment_to(std::abs(h), a.dot(d) / length);
  return h < 0.0 ? -moment : moment;
}

// Mean of |r| along the segment a b.
double mean_of_segment(const Vector2& a, const Vector2& b) noexcept {
  const Vector2 d = b - a;
  const double length = d.norm();
  if (!(length > 0.0)) return a.norm();
  const double h = std::abs(cross(a, b)) / length;
  const auto integral_to = [h](double s) {
    return 0.5 * (s * std::hypot(h, s) + (h > 0.0 ? h * h * std::asinh(s / h) : 0.0));
  };
  return (integral_to(b.dot(d) / length) - integral_to(a.dot(d) / length)) / length;
}

}  // namespace

double mean_distance(std::span<const Vector2> points, const Vector2& centre) noexcept {
  // A patch thinner than this part of its length is a line.
  constexpr double kThin = 1e-6;
  std::array<Vector2, kMaxPatchCorners> sorted;
  const size_t n = std::min(points.size(), sorted.size());
  if (n == 0) return 0.0;
  for (size_t i = 0; i < n; ++i) sorted[i] = points[i] - centre;
  std::sort(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(n),
            [](const Vector2& a, const Vector2& b) { return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y()); });
  Corners corners;
  const int count = hull({sorted.data(), n}, corners);
  double area = 0.0, moment = 0.0, longest = 0.0;
  int far = 0;
  for (int i = 0; i < count; ++i) {
    const Vector2& a = corners[static_cast<size_t>(i)];
    const Vector2& b = corners[static_cast<size_t>((i + 1) % count)];
    area += 0.5 * cross(a, b);
    moment += moment_of_edge(a, b);
    const double distance = (a - corners[0]).norm();
    if (distance > longest) longest = distance, far = i;
  }
  if (count < 2) return sorted[0].norm();
  if (area <= kThin * longest * longest) return mean_of_segment(corners[0], corners[static_cast<size_t>(far)]);
  return moment / area;
}

}  // namespace tegotae
