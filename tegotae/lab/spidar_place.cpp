// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/spidar_place.hpp>

#include <tegotae/device/spidar_reach.hpp>
#include <tegotae/lab/input_error.hpp>
#include <tegotae/math/rotation.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace tegotae {
namespace {

using Sample = Trajectory::Sample;

constexpr size_t kMaxSamples = 300;  // of the motion that are looked at: a hand moves little between them
constexpr int kSides = 4;
constexpr double kWorthTurning = 1.01;  // times more reach that make another side the better one

// Of force and torque, as parts of what is reached at the centre: with less a motion counts as out of the frame.
constexpr double kLeastPart = 0.05;

std::vector<Sample> thinned_out(const Trajectory& motion) {
  const std::vector<Sample>& all = motion.samples();
  const size_t stride = std::max<size_t>(1, all.size() / kMaxSamples);
  std::vector<Sample> some;
  for (size_t i = 0; i < all.size(); i += stride) some.push_back(all[i]);
  if (some.back().time != all.back().time) some.push_back(all.back());
  return some;
}

// Badoiu and Clarkson's centre of the smallest ball, here among rotations: towards the farthest, by less each time.
Quaternion middle_rotation(const std::vector<Sample>& samples) {
  constexpr int kSteps = 200;
  Quaternion middle = samples.front().X_WT.q;
  for (int step = 0; step < kSteps; ++step) {
    Vector3 farthest = Vector3::Zero();
    for (const Sample& sample : samples) {
      const Vector3 way = rotation_vector(sample.X_WT.q * middle.conjugate());
      if (way.squaredNorm() > farthest.squaredNorm()) farthest = way;
    }
    middle = (rotation_from_vector(farthest / (step + 2.0)) * middle).normalized();
  }
  return middle;
}

Vector3 middle_position(const std::vector<Sample>& samples, const Quaternion& q_WS) {
  Vector3 least = Vector3::Constant(std::numeric_limits<double>::infinity()), greatest = -least;
  for (const Sample& sample : samples) {
    const Vector3 p_S = q_WS.conjugate() * sample.X_WT.p;
    least = least.cwiseMin(p_S);
    greatest = greatest.cwiseMax(p_S);
  }
  return q_WS * Vector3(0.5 * (least + greatest));
}

Quaternion standing(const Vector3& up_W, int side) {
  const Vector3 along = std::abs(up_W.x()) < 0.9 ? Vector3::UnitX() : Vector3::UnitY();
  const Vector3 x = (along - along.dot(up_W) * up_W).normalized();
  Matrix3 R_WS;
  R_WS << x, up_W.cross(x), up_W;
  return Quaternion(R_WS) * rotation_from_vector(0.5 * std::numbers::pi * side * Vector3::UnitZ());
}

struct Judged {
  SpidarPlace place;
  double part = std::numeric_limits<double>::infinity();  ///< of the reach at the centre, at the worst sample
  Sample worst;
};

Judged judged(const SpidarGeometry& geometry, const std::vector<Sample>& samples, const Quaternion& q_WS,
              const Quaternion& q_WT_middle) {
  Judged result;
  SpidarPlace& place = result.place;
  place.X_WS = {middle_position(samples, q_WS), q_WS};
  place.q_GT = (q_WS.conjugate() * q_WT_middle).normalized();
  place.force = place.torque = std::numeric_limits<double>::infinity();
  const SpidarReach at_centre = spidar_reach(geometry, {});
  const Pose X_TG{Vector3::Zero(), place.q_GT.conjugate()};
  for (const Sample& sample : samples) {
    const SpidarReach reach = spidar_reach(geometry, place.X_WS.inverse() * sample.X_WT * X_TG);
    const double part = std::min(reach.force / at_centre.force, reach.torque / at_centre.torque);
    place.force = std::min(place.force, reach.force);
    place.torque = std::min(place.torque, reach.torque);
    if (part < result.part) {
      result.part = part;
      result.worst = sample;
    }
  }
  return result;
}

[[noreturn]] void refuse(const SpidarGeometry& geometry, const Judged& best) {
  const Vector3 p_S = best.place.X_WS.inverse() * best.worst.X_WT.p;
  const double angle = rotation_vector(best.worst.X_WT.q * (best.place.X_WS.q * best.place.q_GT).conjugate()).norm();
  throw InputError(fmt::format(
      "the motion leaves the workspace of the SPIDAR '{}': at {:.2f} s its grip would be {:.0f} mm from the "
      "middle of the frame and turned by {:.0f} degrees, where the strings do not hold it; choose a smaller "
      "motion or a larger frame ('tegotae interfaces spidar-g6 --workspace' draws what one reaches).",
      geometry.name, best.worst.time, 1e3 * p_S.norm(), angle * 180.0 / std::numbers::pi));
}

}  // namespace

SpidarPlace place_spidar(const SpidarGeometry& geometry, const Trajectory& motion, const Vector3& up_W) {
  check_force_closure(geometry);
  const std::vector<Sample> samples = thinned_out(motion);
  const Quaternion q_WT_middle = middle_rotation(samples);
  Judged best = judged(geometry, samples, standing(up_W, 0), q_WT_middle);
  for (int side = 1; side < kSides; ++side) {
    const Judged other = judged(geometry, samples, standing(up_W, side), q_WT_middle);
    if (other.part > kWorthTurning * best.part) best = other;
  }
  if (best.part < kLeastPart) refuse(geometry, best);
  return best.place;
}

}  // namespace tegotae
