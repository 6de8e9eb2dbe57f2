// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/math/pose.hpp>
#include <tegotae/math/rotation.hpp>
#include <tegotae/math/wrench.hpp>

#include <random>

namespace tegotae::test {

/// Random poses and wrenches for the SPIDAR's tests, from a fixed seed.
class SpidarPoses {
 public:
  explicit SpidarPoses(unsigned seed) : generator_(seed) {}

  Vector3 direction() {
    Vector3 v;
    do v = {unit_(generator_), unit_(generator_), unit_(generator_)};
    while (v.squaredNorm() > 1.0 || v.squaredNorm() < 1e-4);
    return v.normalized();
  }

  /// Each coordinate within `way` (m), turned about any axis by at most `turn` (rad).
  Pose pose(double way, double turn) {
    const Vector3 p(unit_(generator_), unit_(generator_), unit_(generator_));
    return {way * p, rotation_from_vector(turn * unit_(generator_) * direction())};
  }

  /// Up to `force` (N) and `torque` (N m).
  Wrench wrench(double force, double torque) {
    const double f = force * unit_(generator_), t = torque * unit_(generator_);
    return {f * direction(), t * direction()};
  }

 private:
  std::mt19937 generator_;
  std::uniform_real_distribution<double> unit_{-1.0, 1.0};
};

}  // namespace tegotae::test
