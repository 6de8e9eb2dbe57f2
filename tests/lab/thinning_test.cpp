// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/thinning.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace tegotae {
namespace {

std::vector<PlotPoint> wave(int count) {
  std::vector<PlotPoint> points;
  for (int i = 0; i < count; ++i) points.push_back({i * 1e-3, std::sin(i * 1e-2)});
  return points;
}

TEST(Thinning, KeepsShortCurvesAsTheyAre) {
  const std::vector<PlotPoint> points = wave(50);
  const std::vector<PlotPoint> kept = thinned(points, 50);
  ASSERT_EQ(kept.size(), points.size());
  EXPECT_EQ(kept.back().x, points.back().x);
}

TEST(Thinning, KeepsTheEndsAndASingleSpike) {
  std::vector<PlotPoint> points = wave(10000);
  points[4321].y = 100.0;
  points[8765].y = -100.0;
  const std::vector<PlotPoint> kept = thinned(points, 100);
  EXPECT_LE(kept.size(), 102U);
  EXPECT_EQ(kept.front().x, points.front().x);
  EXPECT_EQ(kept.back().x, points.back().x);
  const auto has = [&kept](double x, double y) {
    return std::any_of(kept.begin(), kept.end(), [&](const PlotPoint& p) { return p.x == x && p.y == y; });
  };
  EXPECT_TRUE(has(points[4321].x, 100.0));
  EXPECT_TRUE(has(points[8765].x, -100.0));
}

TEST(Thinning, KeepsTheOrder) {
  const std::vector<PlotPoint> kept = thinned(wave(10000), 200);
  EXPECT_TRUE(std::is_sorted(kept.begin(), kept.end(), [](const auto& a, const auto& b) { return a.x < b.x; }));
}

TEST(Thinning, LeavesOutWhatIsNotFinite) {
  std::vector<PlotPoint> points = wave(10);
  points[3].y = std::numeric_limits<double>::quiet_NaN();
  points[4].x = std::numeric_limits<double>::infinity();
  EXPECT_EQ(thinned(points, 100).size(), 8U);
  EXPECT_TRUE(thinned({}, 100).empty());
}

}  // namespace
}  // namespace tegotae
