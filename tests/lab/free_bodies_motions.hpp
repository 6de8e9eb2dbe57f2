// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/math/pose.hpp>
#include <tegotae/math/rotation.hpp>

#include <algorithm>
#include <cstdint>
#include <numbers>
#include <random>
#include <string>
#include <vector>

namespace tegotae::test {

/// A way of the hand: from pose to pose at given speeds, then at rest.
class HandWay {
 public:
  HandWay(const Vector3& from, const Vector3& turn = Vector3::Zero()) : poses_{{from, turn}}, times_{0.0} {}

  HandWay& to(const Vector3& p, double speed, const Vector3& turn) {
    const double way = (p - poses_.back().p).norm() + 0.1 * (turn - poses_.back().turn).norm();
    times_.push_back(times_.back() + std::max(1e-3, way / speed));
    poses_.push_back({p, turn});
    return *this;
  }
  HandWay& to(const Vector3& p, double speed) { return to(p, speed, Vector3(poses_.back().turn)); }
  HandWay& rest(double duration) { return to(poses_.back().p, 1.0).extend(duration); }

  double duration() const { return times_.back(); }

  Pose operator()(double time) const {
    size_t i = 1;
    while (i < times_.size() && times_[i] < time) ++i;
    if (i == times_.size()) return pose(poses_.back().p, poses_.back().turn);
    const double s = std::max(0.0, (time - times_[i - 1]) / (times_[i] - times_[i - 1]));
    const Vector3 p = poses_[i - 1].p + s * (poses_[i].p - poses_[i - 1].p);
    const Vector3 turn = poses_[i - 1].turn + s * (poses_[i].turn - poses_[i - 1].turn);
    return pose(p, turn);
  }

 private:
  struct Stop {
    Vector3 p, turn;
  };
  static Pose pose(const Vector3& p, const Vector3& turn) { return {p, rotation_from_vector(turn)}; }
  HandWay& extend(double duration) {
    times_.back() += duration;
    return *this;
  }
  std::vector<Stop> poses_;
  std::vector<double> times_;
};

struct NamedWay {
  std::string name;
  HandWay way;
};

/// What a newcomer does to the boxes of table.xml with the probe.
inline std::vector<NamedWay> table_ways() {
  const double down = 0.5 * std::numbers::pi;
  std::vector<NamedWay> ways;
  const auto add = [&ways](const char* name, HandWay way) { ways.push_back({name, std::move(way)}); };
  add("push the stack at 0.1 m/s", HandWay({-0.22, 0.05, 0.49}).to({0.02, 0.05, 0.49}, 0.1).rest(1.0));
  add("push the stack at 1 m/s", HandWay({-0.30, 0.05, 0.49}).to({0.02, 0.05, 0.49}, 1.0).rest(1.0));
  add("hit the top of the stack at 1 m/s", HandWay({-0.30, 0.05, 0.575}).to({0.02, 0.05, 0.575}, 1.0).rest(1.0));
  add("topple box 6", HandWay({0.30, -0.08, 0.565}).to({0.20, -0.08, 0.565}, 0.1).rest(1.0));
  add("press box 4 and slide",
      HandWay({0.10, 0.08, 0.56}).to({0.10, 0.08, 0.46}, 0.2).rest(0.3).to({0.0, 0.08, 0.46}, 0.1).rest(1.0));
  add("press the stack", HandWay({-0.12, 0.05, 0.61}).to({-0.12, 0.05, 0.58}, 0.1).rest(1.5));
  add("press the stack with all force", HandWay({-0.12, 0.05, 0.61}).to({-0.12, 0.05, 0.53}, 0.3).rest(1.5));
  add("press box 5 at its end", HandWay({0.07, -0.118, 0.51}).to({0.07, -0.118, 0.44}, 0.1).rest(1.0));
  add("press box 4 at its edge", HandWay({0.135, 0.10, 0.56}).to({0.135, 0.10, 0.50}, 0.1).rest(1.0));
  add("knock boxes off", HandWay({-0.30, 0.05, 0.47})
                             .to({0.50, 0.05, 0.47}, 1.0)
                             .to({0.50, -0.10, 0.47}, 1.0)
                             .to({-0.5, -0.10, 0.47}, 1.0)
                             .rest(1.0));
  add("push box 4 off slowly", HandWay({0.03, 0.08, 0.50}).to({0.45, 0.08, 0.50}, 0.2).rest(0.7));
  add("press box 5 with the side",
      HandWay({0.02, -0.10, 0.47}, {down, 0.0, 0.0}).to({0.02, -0.10, 0.40}, 0.1).rest(1.0));
  add("wedge box 5 under the tilted tool", HandWay({0.02, -0.20, 0.47}, {0.8, 0.0, 0.0})
                                               .to({0.02, -0.16, 0.42}, 0.1)
                                               .to({0.02, -0.05, 0.40}, 0.1)
                                               .rest(1.0));
  add("press box 3 aside",
      HandWay({-0.12, 0.05, 0.61}).to({-0.12, 0.05, 0.58}, 0.1).to({-0.05, 0.05, 0.55}, 0.1).rest(1.0));
  return ways;
}

/// Through all boxes, hither and thither, turning.
inline HandWay random_way(int seed, double duration) {
  std::mt19937_64 random(static_cast<std::uint64_t>(seed));
  const auto between = [&random](double least, double most) {
    return least + (most - least) * static_cast<double>(random() >> 11) * 0x1.0p-53;
  };
  HandWay way({0.0, -0.02, 0.60});
  while (way.duration() < duration) {
    const Vector3 p(between(-0.30, 0.35), between(-0.22, 0.20), between(0.40, 0.57));
    const Vector3 turn(between(-0.9, 0.9), between(-0.9, 0.9), between(-0.9, 0.9));
    way.to(p, between(0.1, 1.0), turn);
    if (between(0.0, 1.0) < 0.2) way.rest(0.3);
  }
  return way;
}

}  // namespace tegotae::test
