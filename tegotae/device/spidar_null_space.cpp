// SPDX-License-Identifier: Apache-2.0
#include <tegotae/device/spidar_null_space.hpp>

#include <tegotae/device/tolerances.hpp>

#include <Eigen/QR>

#include <algorithm>
#include <cmath>

namespace tegotae {
namespace {

using Transposed = Eigen::Matrix<double, kSpidarStrings, 6>;

double area(const SpidarNullSpace& space, int i, int j) noexcept {
  const auto& N = space.null_space;
  return N(i, 0) * N(j, 1) - N(i, 1) * N(j, 0);
}

}  // namespace

SpidarNullSpace spidar_null_space(const SpidarWrenchMatrix& W, double radius) noexcept {
  SpidarNullSpace result;
  if (!W.allFinite()) return result;
  Transposed scaled = W.transpose();
  scaled.rightCols<3>() /= radius;
  Eigen::ColPivHouseholderQR<Transposed> qr(scaled);
  qr.setThreshold(tolerance::kSpidarWrenchPivot);
  result.full_rank = qr.rank() == 6;
  if (!result.full_rank) return result;

  // With scaled^T = P R^T Q1^T the least-norm t of scaled^T t = b is Q1 R^-T P^T b.
  const Eigen::Matrix<double, kSpidarStrings, kSpidarStrings> Q = qr.householderQ();
  Eigen::Matrix<double, 6, 6> right = qr.colsPermutation().transpose();
  qr.matrixQR().topRows<6>().triangularView<Eigen::Upper>().transpose().solveInPlace(right);
  result.pseudo_inverse.noalias() = Q.leftCols<6>() * right;
  result.pseudo_inverse.rightCols<3>() /= radius;
  result.null_space = Q.rightCols<2>();
  return result;
}

SpidarFacets spidar_facets(const SpidarNullSpace& space) noexcept {
  SpidarFacets result;
  for (int i = 0; i < kSpidarStrings; ++i) {
    for (int j = i + 1; j < kSpidarStrings; ++j) {
      const double ij = area(space, i, j);
      for (int k = j + 1; k < kSpidarStrings; ++k) {
        const double jk = area(space, j, k), ki = area(space, k, i);
        if (std::max({std::abs(ij), std::abs(jk), std::abs(ki)}) <= tolerance::kSpidarWeight) continue;
        result.facets[result.count++] = {{i, j, k}, {jk, ki, ij}};
        result.facets[result.count++] = {{i, j, k}, {-jk, -ki, -ij}};
      }
    }
  }
  return result;
}

double facet_reach(const SpidarFacet& facet, const SpidarVector& min, const SpidarVector& max) noexcept {
  double sum = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    const int i = facet.strings[k];
    sum += facet.weights[k] * (facet.weights[k] > 0.0 ? max[i] : min[i]);
  }
  return sum;
}

double along(const SpidarFacet& facet, const SpidarVector& tensions) noexcept {
  double sum = 0.0;
  for (std::size_t k = 0; k < 3; ++k) sum += facet.weights[k] * tensions[facet.strings[k]];
  return sum;
}

}  // namespace tegotae
