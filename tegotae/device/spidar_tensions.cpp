// SPDX-License-Identifier: Apache-2.0
#include <tegotae/device/spidar_tensions.hpp>

#include <tegotae/device/spidar_nearest.hpp>
#include <tegotae/device/spidar_null_space.hpp>
#include <tegotae/device/tolerances.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace tegotae {
namespace {

using Vector2 = Eigen::Matrix<double, 2, 1, Eigen::DontAlign>;

/// The multiples s of a wrench that the motors reach: least to greatest.
struct Multiples {
  double least = -std::numeric_limits<double>::infinity();
  double greatest = std::numeric_limits<double>::infinity();
};

/// `t_wrench`: any tensions, also negative, that display the wrench.
Multiples reachable_multiples(const SpidarFacets& facets, const SpidarVector& t_wrench, const SpidarVector& min,
                              const SpidarVector& max) noexcept {
  Multiples result;
  for (std::size_t k = 0; k < facets.count; ++k) {
    const SpidarFacet& facet = facets.facets[k];
    const double reach = facet_reach(facet, min, max), needed = along(facet, t_wrench);
    if (needed > 0.0) {
      result.greatest = std::min(result.greatest, reach / needed);
    } else if (needed < 0.0) {
      result.least = std::max(result.least, reach / needed);
    } else if (reach < 0.0) {
      result.least = std::numeric_limits<double>::infinity();
    }
  }
  return result;
}

/// normal . y <= bound, normal of length 1.
struct HalfPlane {
  Vector2 normal;
  double bound = 0.0;
};
struct HalfPlanes {
  std::array<HalfPlane, 2 * std::size_t{kSpidarStrings}> each;
  std::size_t count = 0;

  void add(const Vector2& normal, double bound) noexcept {
    const double length = normal.norm();
    // A string that the null space leaves alone: its limits are those of the multiples.
    if (length > tolerance::kSpidarWeight) each[count++] = {normal / length, bound / length};
  }
};

/// The point of the line of half-plane `index` nearest to 0 that lies within the half-planes before it; where rounding
/// leaves none, the one that breaks the two worst alike.
Vector2 nearest_on_line(const HalfPlanes& planes, std::size_t index) noexcept {
  const HalfPlane& line = planes.each[index];
  const Vector2 direction(-line.normal.y(), line.normal.x());
  const Vector2 foot = line.bound * line.normal;
  double low = -std::numeric_limits<double>::infinity(), high = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < index; ++k) {
    const double slope = planes.each[k].normal.dot(direction);
    const double room = planes.each[k].bound - planes.each[k].normal.dot(foot);
    if (slope > tolerance::kSpidarWeight) high = std::min(high, room / slope);
    if (slope < -tolerance::kSpidarWeight) low = std::max(low, room / slope);
  }
  const double place = low <= high ? std::clamp(0.0, low, high) : 0.5 * (low + high);
  return foot + place * direction;
}

Vector2 nearest_to_origin(const HalfPlanes& planes) noexcept {
  Vector2 y = Vector2::Zero();
  for (std::size_t k = 0; k < planes.count; ++k) {
    if (planes.each[k].normal.dot(y) > planes.each[k].bound) y = nearest_on_line(planes, k);
  }
  return y;
}

/// Of the tensions t_wrench + N z within the limits those nearest to `min`. `t_wrench` has no part along N.
SpidarVector least_tensions(const SpidarNullSpace& space, const SpidarVector& t_wrench, const SpidarVector& min,
                            const SpidarVector& max) noexcept {
  const auto& N = space.null_space;
  const SpidarVector free = t_wrench + N * (N.transpose() * min);
  HalfPlanes planes;
  for (int i = 0; i < kSpidarStrings; ++i) {
    const Vector2 row = N.row(i).transpose();
    planes.add(-row, free[i] - min[i] + tolerance::kSpidarTensionSlack);
    planes.add(row, max[i] - free[i] + tolerance::kSpidarTensionSlack);
  }
  return (free + N * nearest_to_origin(planes)).cwiseMax(min).cwiseMin(max);
}

SpidarTensions finished(SpidarTensions result, const SpidarWrenchMatrix& W, const Wrench& wrench) noexcept {
  const Vector6 displayed = W * result.tensions;
  result.displayed = {displayed.head<3>(), displayed.tail<3>()};
  result.shortfall = wrench - result.displayed;
  return result;
}

}  // namespace

SpidarTensions spidar_tensions(const SpidarWrenchMatrix& W, double radius, const SpidarVector& min,
                               const SpidarVector& max, const Wrench& wrench) noexcept {
  SpidarTensions result;
  result.tensions = min;
  if (!wrench.is_finite() || !W.allFinite()) return result;
  const SpidarNullSpace space = spidar_null_space(W, radius);
  if (!space.full_rank) {
    result.display = SpidarDisplay::kSingular;
    return finished(result, W, wrench);
  }
  Vector6 w;
  w << wrench.force, wrench.torque;
  const SpidarVector t_wrench = space.pseudo_inverse * w;
  const Multiples multiples = reachable_multiples(spidar_facets(space), t_wrench, min, max);
  const double scale = std::min(1.0, multiples.greatest);
  if (!(scale >= std::max(0.0, multiples.least))) {
    const SpidarNearest nearest = nearest_tensions(W, radius, min, max, wrench);
    result.display = SpidarDisplay::kNearest;
    result.scale = nearest.scale;
    result.tensions = nearest.tensions;
    return finished(result, W, wrench);
  }
  result.scale = scale;
  result.display = scale < 1.0 ? SpidarDisplay::kScaled : SpidarDisplay::kExact;
  result.tensions = least_tensions(space, scale * t_wrench, min, max);
  return finished(result, W, wrench);
}

}  // namespace tegotae
