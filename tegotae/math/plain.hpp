// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/math/pose.hpp>
#include <tegotae/math/twist.hpp>
#include <tegotae/math/wrench.hpp>

#include <type_traits>

namespace tegotae {

// Trivially copyable twins of the types above, for data that crosses threads, processes and machines
// (Eigen's types have copy constructors of their own and so may not be copied byte by byte).

struct PlainVector3 {
  double x = 0.0, y = 0.0, z = 0.0;

  PlainVector3() = default;
  PlainVector3(const Vector3& v) noexcept : x(v.x()), y(v.y()), z(v.z()) {}  // NOLINT(google-explicit-constructor)
  operator Vector3() const noexcept { return {x, y, z}; }                    // NOLINT(google-explicit-constructor)
  Vector3 vector() const noexcept { return {x, y, z}; }
};

struct PlainPose {
  PlainVector3 p;                             ///< m
  double w = 1.0, x = 0.0, y = 0.0, z = 0.0;  ///< unit quaternion

  PlainPose() = default;
  PlainPose(const Pose& X) noexcept  // NOLINT(google-explicit-constructor)
      : p(X.p), w(X.q.w()), x(X.q.x()), y(X.q.y()), z(X.q.z()) {}
  operator Pose() const noexcept { return {p, Quaternion(w, x, y, z)}; }  // NOLINT(google-explicit-constructor)
  Pose pose() const noexcept { return {p, Quaternion(w, x, y, z)}; }
};

struct PlainTwist {
  PlainVector3 linear;   ///< m/s
  PlainVector3 angular;  ///< rad/s

  PlainTwist() = default;
  PlainTwist(const Twist& V) noexcept : linear(V.linear), angular(V.angular) {}  // NOLINT(google-explicit-constructor)
  operator Twist() const noexcept { return {linear, angular}; }                  // NOLINT(google-explicit-constructor)
};

struct PlainWrench {
  PlainVector3 force;   ///< N
  PlainVector3 torque;  ///< N m

  PlainWrench() = default;
  PlainWrench(const Wrench& F) noexcept : force(F.force), torque(F.torque) {}  // NOLINT(google-explicit-constructor)
  operator Wrench() const noexcept { return {force, torque}; }                 // NOLINT(google-explicit-constructor)
};

static_assert(std::is_trivially_copyable_v<PlainVector3> && std::is_trivially_copyable_v<PlainPose> &&
              std::is_trivially_copyable_v<PlainTwist> && std::is_trivially_copyable_v<PlainWrench>);

}  // namespace tegotae
