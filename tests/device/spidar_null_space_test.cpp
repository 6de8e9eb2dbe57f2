// SPDX-License-Identifier: Apache-2.0
#include <tegotae/device/spidar_null_space.hpp>
#include <tegotae/device/spidar_presets.hpp>

#include <tests/device/spidar_poses.hpp>

#include <gtest/gtest.h>
#include <Eigen/SVD>

#include <algorithm>
#include <cmath>
#include <limits>

namespace tegotae {
namespace {

TEST(SpidarNullSpace, HoldsAllTensionsThatDisplayTheSame) {
  test::SpidarPoses random(31);
  for (const SpidarPreset& preset : spidar_presets()) {
    const double radius = knot_radius(preset.geometry);
    const SpidarWrenchMatrix W = spidar_strings(preset.geometry, random.pose(0.02, 0.5)).wrenches;
    const SpidarNullSpace space = spidar_null_space(W, radius);
    ASSERT_TRUE(space.full_rank) << preset.name;
    EXPECT_LT((W * space.null_space).cwiseAbs().maxCoeff(), 1e-14);
    EXPECT_LT((space.null_space.transpose() * space.null_space - Eigen::Matrix2d::Identity()).norm(), 1e-14);
    EXPECT_LT((W * space.pseudo_inverse - Eigen::Matrix<double, 6, 6>::Identity()).cwiseAbs().maxCoeff(), 1e-11);
    EXPECT_LT((space.null_space.transpose() * space.pseudo_inverse).cwiseAbs().maxCoeff(), 1e-12);
  }
}

TEST(SpidarNullSpace, SaysWhereTheStringsActOnFewerThanSixComponents) {
  const SpidarGeometry& geometry = spidar_preset("x3r").geometry;
  SpidarWrenchMatrix W = spidar_strings(geometry, {}).wrenches;
  W.row(4) = 0.3 * W.row(1) - 0.01 * W.row(5);
  EXPECT_FALSE(spidar_null_space(W, 0.0225).full_rank);
  W(4, 2) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(spidar_null_space(W, 0.0225).full_rank);
}

// The facets of a zonotope in six dimensions by their definition: directions perpendicular to five of its generators.
TEST(SpidarNullSpace, FacetsAreTheDirectionsPerpendicularToFiveStrings) {
  test::SpidarPoses random(32);
  const SpidarGeometry& geometry = spidar_preset("x4r").geometry;
  const SpidarWrenchMatrix W = spidar_strings(geometry, random.pose(0.02, 0.5)).wrenches;
  const SpidarFacets facets = spidar_facets(spidar_null_space(W, knot_radius(geometry)));
  EXPECT_EQ(facets.count, SpidarFacets::kCapacity);
  for (std::size_t k = 0; k < facets.count; ++k) {
    const SpidarFacet& facet = facets.facets[k];
    Eigen::MatrixXd others(5, 6);
    int row = 0;
    for (int i = 0; i < kSpidarStrings; ++i) {
      if (std::find(facet.strings.begin(), facet.strings.end(), i) == facet.strings.end()) {
        others.row(row++) = W.col(i).transpose();
      }
    }
    ASSERT_EQ(row, 5);
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(others, Eigen::ComputeFullV);
    const Vector6 n = svd.matrixV().col(5);
    const SpidarVector weights = W.transpose() * n;
    // Alike up to a factor.
    double scale = 0.0;
    for (std::size_t m = 0; m < 3; ++m) {
      if (std::abs(facet.weights[m]) > 0.01) scale = weights[facet.strings[m]] / facet.weights[m];
    }
    for (std::size_t m = 0; m < 3; ++m) {
      EXPECT_NEAR(weights[facet.strings[m]], scale * facet.weights[m], 1e-9 * std::abs(scale)) << k;
    }
  }
}

TEST(SpidarNullSpace, ReachOfAFacetTakesTheLimitThatPushesAlongIt) {
  const SpidarFacet facet{{1, 4, 6}, {0.5, -0.25, 0.0}};
  SpidarVector min = SpidarVector::Constant(1.0), max = SpidarVector::Constant(10.0);
  EXPECT_DOUBLE_EQ(facet_reach(facet, min, max), 0.5 * 10.0 - 0.25 * 1.0);
  EXPECT_DOUBLE_EQ(along(facet, max), 0.25 * 10.0);
}

}  // namespace
}  // namespace tegotae
