// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/scripted_motion.hpp>

#include <tegotae/lab/axes.hpp>
#include <tegotae/lab/input_error.hpp>
#include <tegotae/lab/motion.hpp>
#include <tegotae/lab/smooth_path.hpp>
#include <tegotae/math/rotation.hpp>

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <string>

namespace tegotae {
namespace {

// A direction across, the same for every scene of one up axis.
Vector3 across(const Vector3& up_W) { return any_perpendicular(up_W); }

Trajectory press(const Vector3& up_W) {
  const SmoothPath depth({{0.0, 0.0}, {1.5, 0.06}, {2.5, 0.06}, {4.0, 0.0}});
  return sampled(0.0, 4.0, [&](double time) { return Pose{-depth.at(time) * up_W, Quaternion::Identity()}; });
}

Trajectory tap(const Vector3& up_W) {
  constexpr double kTap = 0.5;  // s
  const SmoothPath depth({{0.0, 0.0}, {0.15, 0.05}, {0.3, 0.0}});
  return sampled(0.0, 3.0 * kTap, [&](double time) {
    return Pose{-depth.at(std::fmod(time, kTap)) * up_W, Quaternion::Identity()};
  });
}

Trajectory circle(const Vector3& up_W) {
  constexpr double kRadius = 0.05;  // m
  const SmoothPath depth({{0.0, 0.0}, {1.0, 0.05}, {7.0, 0.05}, {8.0, 0.0}});
  const SmoothPath angle({{1.0, 0.0}, {7.0, 4.0 * std::numbers::pi}});
  const Vector3 x = across(up_W), y = up_W.cross(x);
  return sampled(0.0, 8.0, [&](double time) {
    const double a = angle.at(time);
    const Vector3 around = kRadius * ((std::cos(a) - 1.0) * x + std::sin(a) * y);
    return Pose{around - depth.at(time) * up_W, Quaternion::Identity()};
  });
}

Trajectory sway(const Vector3& up_W) {
  const SmoothPath first({{0.0, 0.0}, {1.0, 25.0}, {2.5, -25.0}, {3.5, 0.0}});
  const SmoothPath second({{3.5, 0.0}, {4.5, 25.0}, {6.0, -25.0}, {7.0, 0.0}});
  const Vector3 x = across(up_W), y = up_W.cross(x);
  return sampled(0.0, 7.0, [&](double time) {
    return Pose{Vector3::Zero(), rotation_from_vector(kDegree * (first.at(time) * x + second.at(time) * y))};
  });
}

Trajectory push(const Vector3& up_W) {
  const SmoothPath way({{0.0, 0.0}, {2.0, 0.2}, {2.5, 0.2}, {4.5, 0.0}});
  const Vector3 x = across(up_W);
  return sampled(0.0, 4.5, [&](double time) { return Pose{way.at(time) * x, Quaternion::Identity()}; });
}

constexpr ScriptedMotion kMotions[] = {
    {"press", "down 6 cm, hold, and back", press},
    {"tap", "three quick taps, 5 cm down", tap},
    {"circle", "down 5 cm, two rounds of 10 cm across, and back", circle},
    {"sway", "tilt by 25 degrees to all four sides", sway},
    {"push", "sideways 20 cm, and back", push},
};

}  // namespace

std::span<const ScriptedMotion> scripted_motions() noexcept { return kMotions; }

const ScriptedMotion& find_scripted_motion(std::string_view name) {
  std::string names;
  for (const ScriptedMotion& motion : kMotions) {
    if (motion.name == name) return motion;
    names.append(names.empty() ? "" : ", ").append(motion.name);
  }
  throw InputError(fmt::format("there is no motion '{}'; there are: {}.", name, names));
}

}  // namespace tegotae
