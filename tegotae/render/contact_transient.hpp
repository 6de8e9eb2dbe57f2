// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/math/types.hpp>

namespace tegotae {

/// The short vibration of an impact, added to the force at the moment of contact: A v exp(-b t) sin(2 pi f t) along the
/// contact normal, v the speed of the impact (after Okamura, Cutkosky and Dennerlein 2001: tapping on materials is told
/// apart by it). A value type; no heap.
class ContactTransient {
 public:
  struct Parameters {
    double amplitude = 0.0;    ///< A, N s/m; 0: off
    double frequency = 150.0;  ///< f, Hz
    double decay = 60.0;       ///< b, 1/s
  };

  explicit ContactTransient(const Parameters& parameters) noexcept : parameters_(parameters) {}

  /// An impact along `n_W` (unit, towards the tool) at `speed` (m/s, > 0).
  void strike(const Vector3& n_W, double speed) noexcept;

  /// Force on the interface now, N; then goes on by `dt` (s).
  Vector3 advance(double dt) noexcept;

  void reset() noexcept { speed_ = 0.0; }

 private:
  Parameters parameters_;
  Vector3 n_W_ = Vector3::UnitZ();
  double speed_ = 0.0;
  double elapsed_ = 0.0;
};

}  // namespace tegotae
