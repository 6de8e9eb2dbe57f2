// SPDX-License-Identifier: Apache-2.0
#include <tegotae/render/contact_patch.hpp>

#include <tests/allocation_counter.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace tegotae {
namespace {

// Mean distance over a fine grid of the rectangle's cells.
double by_sum(double x0, double x1, double y0, double y1, const Vector2& centre) {
  constexpr int kCells = 1000;
  double sum = 0.0;
  for (int i = 0; i < kCells; ++i) {
    for (int j = 0; j < kCells; ++j) {
      const Vector2 p(x0 + (x1 - x0) * (i + 0.5) / kCells, y0 + (y1 - y0) * (j + 0.5) / kCells);
      sum += (p - centre).norm();
    }
  }
  return sum / (kCells * kCells);
}

TEST(ContactPatch, SquareAboutItsCentreIsTheClosedForm) {
  const std::vector<Vector2> square{{-1.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}, {0.3, 0.2}, {1.0, 0.0}};
  EXPECT_NEAR(mean_distance(square, Vector2::Zero()), (std::sqrt(2.0) + std::asinh(1.0)) / 3.0, 1e-14);
}

TEST(ContactPatch, RectanglesAboutAnyPointAreTheSumOverTheirCells) {
  const std::vector<Vector2> rectangle{{2.0, 3.0}, {-1.0, 0.5}, {2.0, 0.5}, {-1.0, 3.0}};
  for (const Vector2& centre : {Vector2(0.0, 1.0), Vector2(-1.0, 0.5), Vector2(-3.0, 7.0), Vector2(2.0, 1.0)}) {
    EXPECT_NEAR(mean_distance(rectangle, centre), by_sum(-1.0, 2.0, 0.5, 3.0, centre), 1e-5) << centre.transpose();
  }
}

TEST(ContactPatch, DiscIsTwoThirdsOfItsRadius) {
  std::vector<Vector2> disc;
  for (int i = 0; i < 100; ++i) {
    const double turn = 2.0 * std::numbers::pi * i / 100.0;
    disc.emplace_back(0.3 * std::cos(turn), 0.3 * std::sin(turn));
  }
  EXPECT_NEAR(mean_distance(disc, Vector2::Zero()), 0.2, 2e-4);
}

TEST(ContactPatch, LinesAndPointsAreTheirOwnMeans) {
  const std::vector<Vector2> line{{-1.0, -1.0}, {2.0, 2.0}, {0.5, 0.5}};
  EXPECT_NEAR(mean_distance(line, Vector2::Zero()), (2.0 + 8.0) / 2.0 / (3.0 * std::sqrt(2.0)), 1e-12);
  // Off the line: the mean of sqrt(h^2 + s^2) from -2 to 2.
  const std::vector<Vector2> off{{-2.0, 1.0}, {2.0, 1.0}};
  EXPECT_NEAR(mean_distance(off, Vector2::Zero()), (2.0 * std::sqrt(5.0) + std::asinh(2.0)) / 4.0, 1e-12);
  const std::vector<Vector2> point{{3.0, 4.0}, {3.0, 4.0}};
  EXPECT_NEAR(mean_distance(point, Vector2::Zero()), 5.0, 1e-12);
  EXPECT_EQ(mean_distance({}, Vector2::Zero()), 0.0);
}

TEST(ContactPatch, AllocatesNothingAndLeavesOutWhatIsTooMuch) {
  std::array<Vector2, kMaxPatchCorners + 50> points;
  for (size_t i = 0; i < points.size(); ++i) {
    points[i] = Vector2(std::cos(static_cast<double>(i)), std::sin(static_cast<double>(i)));
  }
  const test::AllocationCounter counter;
  EXPECT_NEAR(mean_distance(points, Vector2::Zero()), 2.0 / 3.0, 0.01);
  EXPECT_EQ(counter.count(), 0u);
}

}  // namespace
}  // namespace tegotae
