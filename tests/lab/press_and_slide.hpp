// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/device/trajectory.hpp>
#include <tegotae/lab/cube_touch.hpp>
#include <tegotae/lab/motion.hpp>
#include <tegotae/math/rotation.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

namespace tegotae::test {

/// What a hand means to do with a cube over the floor z = 0, at random: in each episode of three seconds it takes the
/// cube by a face, an edge or a vertex downwards, taps with it three times, presses, slides while it presses, and lifts
/// it. The same seed gives the same motion.
class PressAndSlide {
 public:
  static constexpr double kEpisode = 3.0;               ///< s
  static constexpr double kHold = 2.0, kHoldEnd = 2.6;  ///< s into an episode: pressed, and settled for 0.8 s
  static constexpr double kLift = 0.02;                 ///< m between episodes

  PressAndSlide(const Tool& tool, double duration, std::uint32_t seed) : tool_(tool), duration_(duration) {
    std::mt19937 random(seed);
    const auto uniform = [&random](double least, double most) {
      return least + (most - least) * static_cast<double>(random()) / 4294967296.0;
    };
    Vector3 place = Vector3::Zero();
    for (int i = 0; i * kEpisode < duration; ++i) {
      Episode& episode = episodes_.emplace_back();
      const auto features = touched_features();
      const Quaternion spin = rotation_from_vector({0.0, 0.0, uniform(-3.0, 3.0)});
      const Quaternion tilt = rotation_from_vector({uniform(-0.05, 0.05), uniform(-0.05, 0.05), 0.0});
      episode.q_WT = spin * tilt * features[random() % features.size()].q_WT;
      episode.depth = uniform(1e-3, 5e-3);
      episode.begin = place;
      place = Vector3(uniform(-0.1, 0.1), uniform(-0.1, 0.1), 0.0);
      episode.end = episode.begin + (place - episode.begin).normalized() * uniform(0.0, 0.05);
      place = episode.end;
    }
  }

  Trajectory motion() const {
    return sampled(0.0, duration_, [this](double time) { return pose(time); });
  }

  /// Whether the hand presses at `time` (s), and has for a while.
  static bool is_held(double time) {
    const double t = std::fmod(time, kEpisode);
    return t > kHold && t < kHoldEnd;
  }

 private:
  struct Episode {
    Quaternion q_WT;
    double depth = 0.0;  // m under the floor that the hand means to go
    Vector3 begin, end;
  };

  static double ease(double t) { return 0.5 - 0.5 * std::cos(M_PI * std::clamp(t, 0.0, 1.0)); }

  // 1: lifted, 0: at the floor, -1: pressed.
  static double height(double t) {
    if (t < 0.3) return 1.0 - 0.8 * ease(t / 0.3);
    if (t < 0.9) return 0.2 - 0.4 * std::pow(std::sin(M_PI * (t - 0.3) / 0.2), 2);  // taps: 100 mm/s or so
    if (t < 2.7) return 0.2 - 1.2 * ease((t - 0.9) / 0.3);
    return -1.0 + 2.0 * ease((t - 2.7) / 0.3);
  }

  Pose pose(double time) const {
    const auto i = std::min(static_cast<std::size_t>(time / kEpisode), episodes_.size() - 1);
    const Episode& now = episodes_[i];
    const Episode& before = episodes_[i > 0 ? i - 1 : 0];
    const double t = time - kEpisode * static_cast<double>(i);
    const Quaternion q_WT = before.q_WT.slerp(ease(t / 0.25), now.q_WT);
    const double h = height(t);
    Vector3 p = now.begin + ease((t - 1.2) / 1.4) * (now.end - now.begin);
    p.z() = -lowest_height(tool_, q_WT, Vector3::UnitZ()) + (h > 0.0 ? kLift : now.depth) * h;
    return {p, q_WT};
  }

  Tool tool_;
  double duration_;
  std::vector<Episode> episodes_;
};

}  // namespace tegotae::test
