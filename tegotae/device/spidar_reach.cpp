// SPDX-License-Identifier: Apache-2.0
#include <tegotae/device/spidar_reach.hpp>

#include <tegotae/device/spidar_null_space.hpp>
#include <tegotae/device/tolerances.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>

namespace tegotae {
namespace {

Vector6 normal_of(const SpidarFacet& facet, const SpidarNullSpace& space) noexcept {
  Vector6 n = Vector6::Zero();
  for (std::size_t k = 0; k < 3; ++k) n += facet.weights[k] * space.pseudo_inverse.row(facet.strings[k]).transpose();
  return n;
}

/// A direction for a sentence: numbers that are rounding of zero written so.
std::string direction_text(const Vector6& direction) {
  constexpr double kRounding = 1e-9;
  const Vector6 clean = direction.unaryExpr([](double v) { return v < kRounding && v > -kRounding ? 0.0 : v; });
  return fmt::format(
      "force ({:.3g}, {:.3g}, {:.3g}) N with torque ({:.3g}, {:.3g}, {:.3g}) N at the knots' radius (x right, y away, "
      "z "
      "up)",
      clean[0], clean[1], clean[2], clean[3], clean[4], clean[5]);
}

}  // namespace

SpidarReach spidar_reach(const SpidarGeometry& geometry, const Pose& X_SG) noexcept {
  SpidarReach result;
  const double radius = knot_radius(geometry);
  const SpidarNullSpace space = spidar_null_space(spidar_strings(geometry, X_SG).wrenches, radius);
  if (!space.full_rank) return result;
  const SpidarVector min = min_tensions(geometry), max = max_tensions(geometry);
  const SpidarFacets facets = spidar_facets(space);
  double force = std::numeric_limits<double>::infinity(), torque = force, least = force;
  for (std::size_t k = 0; k < facets.count; ++k) {
    const double unclamped = facet_reach(facets.facets[k], min, max), reach = std::max(0.0, unclamped);
    const Vector6 n = normal_of(facets.facets[k], space);
    // A facet that forces (or torques) run along does not limit them, unless nothing is reachable beyond it at all.
    const auto limit = [reach](double size) {
      constexpr double kAlong = 1e-9;
      return size > kAlong || reach == 0.0 ? reach / std::max(size, kAlong) : std::numeric_limits<double>::infinity();
    };
    Vector6 at_knots = n;
    at_knots.tail<3>() *= radius;
    force = std::min(force, limit(n.head<3>().norm()));
    torque = std::min(torque, limit(n.tail<3>().norm()));
    if (unclamped / at_knots.norm() < least) {
      least = unclamped / at_knots.norm();
      result.weakest = at_knots.normalized();
    }
  }
  result.force = force;
  result.torque = torque;
  return result;
}

void check_force_closure(const SpidarGeometry& geometry) {
  check_numbers(geometry);
  const SpidarReach reach = spidar_reach(geometry, {});
  if (reach.force >= tolerance::kSpidarLeastForce && reach.torque >= tolerance::kSpidarLeastTorque) return;
  const std::string what = reach.weakest.isZero()
                               ? "they do not act on all six components of force and torque"
                               : "no tensions within the motors' limits push along " + direction_text(reach.weakest);
  throw std::invalid_argument(fmt::format(
      "the strings of the SPIDAR '{}' do not hold its grip at the centre ({}): check which motor holds which knot, and "
      "the tensions.",
      geometry.name, what));
}

}  // namespace tegotae
