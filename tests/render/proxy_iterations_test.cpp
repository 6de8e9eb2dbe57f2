// SPDX-License-Identifier: Apache-2.0
// How much work a tick takes, in iterations: what time measures, but repeatable.
#include <tests/random_shapes.hpp>
#include <tests/render/proxy_rig.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace tegotae::test {
namespace {

// A hull between ball and box, every point a corner, as a scanned tool.
Shape rounded_tool(int count) {
  std::mt19937_64 random(5);
  std::vector<Vector3> points;
  for (int i = 0; i < count; ++i) {
    const Vector3 u = random_unit(random);
    points.push_back(0.03 / std::pow(u.array().abs().pow(4.0).sum(), 0.25) * u);
  }
  return make_hull(points);
}

// Rolled and slid in a corner with friction, rows come and go in every tick.
TEST(ProxyIterations, OfARoundedToolInACornerStayFewAtTheWorstTick) {
  ProxyRig rig({rounded_tool(230)});
  rig.add_body(make_box({0.1, 0.1, 0.05}));
  rig.add_body(make_box({0.05, 0.1, 0.1}), at(0.0795, 0.0, 0.1));
  rig.parameters.friction = 0.5;
  rig.tick(at(-0.002, 0.0, 0.1));
  std::vector<int> iterations;
  int several = 0;
  for (int i = 0; i < 6000; ++i) {
    const double t = 1e-3 * i;
    const Vector3 p(1e-3 * std::sin(7.0 * t), 3e-3 * std::sin(11.0 * t), 0.0785 + 5e-4 * std::sin(5.0 * t));
    rig.tick(at(p, {0.05 * std::sin(9.0 * t), 0.04 * std::sin(6.0 * t), 0.05 * std::sin(8.0 * t)}));
    iterations.push_back(rig.output.solver_iterations);
    several += rig.output.linearisations > 1 ? 1 : 0;
    ASSERT_EQ(rig.output.status, RenderStatus::kOk) << i;
  }
  EXPECT_GT(several, 3000);
  std::sort(iterations.begin(), iterations.end());
  EXPECT_LE(iterations[iterations.size() / 2], 10);
  EXPECT_LE(iterations[iterations.size() * 999 / 1000], 50);
  EXPECT_LE(iterations.back(), 60) << "guesses of rows that are others by now took up to 70";
}

}  // namespace
}  // namespace tegotae::test
