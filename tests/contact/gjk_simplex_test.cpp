// SPDX-License-Identifier: Apache-2.0
#include <tegotae/contact/gjk_simplex.hpp>

#include <tests/random_shapes.hpp>
#include <tests/sweep_size.hpp>

#include <gtest/gtest.h>
#include <Eigen/LU>

namespace tegotae::gjk {
namespace {

using tegotae::test::random_unit;
using tegotae::test::random_vector;
using tegotae::test::sweep_size;

Simplex simplex_of(const std::vector<Vector3>& points) {
  Simplex simplex;
  for (const Vector3& p : points) {
    MinkowskiPoint point;
    point.w = p;
    point.tool = 2.0 * p;
    point.object = p;
    simplex.add(point);
  }
  return simplex;
}

// Distance of the origin from the hull of the points: over all their subsets, the least norm of a point of the
// subset's affine hull that has no negative weight, in long double.
double distance_by_enumeration(const std::vector<Vector3>& points) {
  using LongMatrix = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;
  using LongVector = Eigen::Matrix<long double, Eigen::Dynamic, 1>;
  long double least = 1e300L;
  for (unsigned subset = 1; subset < 1U << points.size(); ++subset) {
    std::vector<Eigen::Matrix<long double, 3, 1>> chosen;
    for (size_t k = 0; k < points.size(); ++k) {
      if ((subset >> k & 1U) != 0) chosen.push_back(points[k].cast<long double>());
    }
    const auto count = static_cast<Eigen::Index>(chosen.size());
    LongMatrix A = LongMatrix::Ones(count + 1, count + 1);
    A(count, count) = 0.0L;
    for (Eigen::Index i = 0; i < count; ++i) {
      for (Eigen::Index j = 0; j < count; ++j) A(i, j) = chosen[size_t(i)].dot(chosen[size_t(j)]);
    }
    LongVector rhs = LongVector::Zero(count + 1);
    rhs[count] = 1.0L;
    const Eigen::FullPivLU<LongMatrix> lu(A);
    if (!lu.isInvertible()) continue;
    const LongVector solution = lu.solve(rhs);
    if (solution.head(count).minCoeff() < -1e-15L) continue;
    Eigen::Matrix<long double, 3, 1> v = Eigen::Matrix<long double, 3, 1>::Zero();
    for (Eigen::Index i = 0; i < count; ++i) v += solution[i] * chosen[size_t(i)];
    least = std::min(least, v.norm());
  }
  return static_cast<double>(least);
}

void expect_nearest(const std::vector<Vector3>& points, double tolerance) {
  Simplex simplex = simplex_of(points);
  const NearestPoint nearest = reduce_to_nearest(simplex);
  const double expected = distance_by_enumeration(points);
  ASSERT_NEAR(nearest.distance, expected, tolerance);
  if (nearest.inside) return;
  ASSERT_LE(simplex.count, 3);
  double sum = 0.0;
  for (size_t k = 0; k < static_cast<size_t>(simplex.count); ++k) {
    ASSERT_GE(simplex.weight[k], 0.0);
    sum += simplex.weight[k];
  }
  ASSERT_NEAR(sum, 1.0, 1e-12);
  ASSERT_LT((simplex.tool_point() - simplex.object_point() - nearest.v).norm(), tolerance);
  if (nearest.distance > 1e-3) {
    ASSERT_LT((nearest.n * nearest.distance - nearest.v).norm(), tolerance);
  }
}

TEST(GjkSimplex, RandomSimplicesOfEverySize) {
  std::mt19937_64 random(1);
  for (int i = 0; i < sweep_size(20000); ++i) {
    std::vector<Vector3> points;
    const Vector3 away = random_vector(random, 1.5);
    for (size_t k = 0; k < 1 + static_cast<size_t>(i % 4); ++k) points.push_back(away + random_unit(random));
    ASSERT_NO_FATAL_FAILURE(expect_nearest(points, 1e-12)) << "case " << i;
  }
}

TEST(GjkSimplex, FlatCollinearAndRepeatedPoints) {
  std::mt19937_64 random(2);
  for (int i = 0; i < sweep_size(8000); ++i) {
    const Vector3 base = random_unit(random);
    const Vector3 u = random_unit(random);
    const Vector3 v = random_unit(random);
    const auto number = [&] { return std::uniform_real_distribution<double>(-1.0, 1.0)(random); };
    std::vector<Vector3> points;
    for (int k = 0; k < 4; ++k) points.emplace_back(base + number() * u + (i % 2 == 0 ? number() : 0.0) * v);
    if (i % 3 == 0) points[3] = points[0];
    if (i % 6 == 0) points[2] = points[1];
    ASSERT_NO_FATAL_FAILURE(expect_nearest(points, 1e-7)) << "case " << i;
  }
}

TEST(GjkSimplex, OriginInside) {
  Simplex simplex = simplex_of({{1.0, 0.0, -0.5}, {-0.5, 0.8, -0.5}, {-0.5, -0.8, -0.5}, {0.0, 0.0, 1.0}});
  const NearestPoint nearest = reduce_to_nearest(simplex);
  EXPECT_TRUE(nearest.inside);
  EXPECT_EQ(simplex.count, 4);
  EXPECT_LT((simplex.tool_point() - simplex.object_point()).norm(), 1e-15);
}

TEST(GjkSimplex, NormalOfATriangleDoesNotSufferFromATinyDistance) {
  const double gap = 1e-12;
  Simplex simplex = simplex_of({{0.3, 0.1, gap}, {-0.2, 0.2, gap}, {0.0, -0.3, gap}});
  const NearestPoint nearest = reduce_to_nearest(simplex);
  EXPECT_NEAR(nearest.distance, gap, 1e-20);
  EXPECT_LT((nearest.n - Vector3::UnitZ()).norm(), 1e-15);
}

TEST(GjkSimplex, KnowsItsPointsByTheirVertices) {
  Simplex simplex;
  MinkowskiPoint point;
  point.tool_vertex = 3;
  point.object_vertex = 5;
  simplex.add(point);
  EXPECT_TRUE(simplex.contains(point));
  point.object_vertex = 6;
  EXPECT_FALSE(simplex.contains(point));
  point.object_vertex = -1;  // smooth: known by its place
  EXPECT_TRUE(simplex.contains(point));
  point.w.x() = 1e-9;
  EXPECT_FALSE(simplex.contains(point));
}

}  // namespace
}  // namespace tegotae::gjk
