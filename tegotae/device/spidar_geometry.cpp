// SPDX-License-Identifier: Apache-2.0
#include <tegotae/device/spidar_geometry.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace tegotae {
namespace {

constexpr double kShortestString = 1e-3;  // m at the centre: shorter has no direction that an encoder could resolve

[[noreturn]] void refuse(const SpidarGeometry& geometry, const std::string& what) {
  throw std::invalid_argument("the SPIDAR '" + geometry.name + "': " + what);
}

void check_string(const SpidarGeometry& geometry, int index) {
  const SpidarString& string = geometry.strings[static_cast<std::size_t>(index)];
  const std::string name = "string " + std::to_string(index);
  if (!string.motor_S.allFinite() || !string.knot_G.allFinite()) {
    refuse(geometry, name + " has a motor or a knot that is not at finite coordinates; give them in metres.");
  }
  if (!((string.motor_S - string.knot_G).norm() >= kShortestString)) {
    refuse(geometry, name + " is shorter than 1 mm with the grip at the centre; check its motor and its knot.");
  }
  if (!std::isfinite(string.metres_per_pulse) || string.metres_per_pulse == 0.0) {
    refuse(geometry, name + " has no length a pulse; give metres a pulse, negative where the count runs backwards.");
  }
  if (!std::isfinite(string.volts_per_newton) || string.volts_per_newton == 0.0) {
    refuse(geometry, name + " has no volts a newton; give them, negative where the motor runs backwards.");
  }
  if (!(string.min_tension > 0.0 && string.min_tension < string.max_tension) || !std::isfinite(string.max_tension)) {
    refuse(geometry, name + " needs tensions 0 < least < greatest, in newtons.");
  }
}

}  // namespace

SpidarStrings spidar_strings(const SpidarGeometry& geometry, const Pose& X_SG) noexcept {
  SpidarStrings result;
  const Matrix3 R_SG = X_SG.rotation();
  for (int i = 0; i < kSpidarStrings; ++i) {
    const SpidarString& string = geometry.strings[static_cast<std::size_t>(i)];
    const Vector3 arm = R_SG * string.knot_G;
    const Vector3 to_motor = string.motor_S - arm - X_SG.p;
    const double length = to_motor.norm();
    const Vector3 u = to_motor / length;
    result.lengths[i] = length;
    result.wrenches.col(i) << u, arm.cross(u);
  }
  return result;
}

double knot_radius(const SpidarGeometry& geometry) noexcept {
  double radius = 0.0;
  for (const SpidarString& string : geometry.strings) radius = std::max(radius, string.knot_G.norm());
  return radius;
}

SpidarVector min_tensions(const SpidarGeometry& geometry) noexcept {
  SpidarVector result;
  for (int i = 0; i < kSpidarStrings; ++i) result[i] = geometry.strings[static_cast<std::size_t>(i)].min_tension;
  return result;
}

SpidarVector max_tensions(const SpidarGeometry& geometry) noexcept {
  SpidarVector result;
  for (int i = 0; i < kSpidarStrings; ++i) result[i] = geometry.strings[static_cast<std::size_t>(i)].max_tension;
  return result;
}

SpidarVector spidar_volts(const SpidarGeometry& geometry, const SpidarVector& tensions) noexcept {
  SpidarVector result;
  for (int i = 0; i < kSpidarStrings; ++i) {
    result[i] = geometry.strings[static_cast<std::size_t>(i)].volts_per_newton * tensions[i];
  }
  return result;
}

void check_numbers(const SpidarGeometry& geometry) {
  for (int i = 0; i < kSpidarStrings; ++i) check_string(geometry, i);
  if (!(geometry.axial_stiffness > 0.0)) {
    refuse(geometry,
           "the axial stiffness of its strings must be above 0 N; leave it out for strings that do not give.");
  }
  if (!(knot_radius(geometry) > 0.0)) {
    refuse(geometry, "all knots are at the grip's origin, so no string turns it; give the knots' places on the grip.");
  }
}

}  // namespace tegotae
