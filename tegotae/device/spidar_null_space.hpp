// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/device/spidar_geometry.hpp>

#include <array>
#include <cstddef>

namespace tegotae {

/// What eight strings can do with six components of wrench: tensions t display W t, and all that display the same w are
/// pseudo_inverse w + null_space z, z in the plane.
struct SpidarNullSpace {
  bool full_rank = false;  ///< else nothing below is set
  Eigen::Matrix<double, kSpidarStrings, 6, Eigen::DontAlign> pseudo_inverse;
  Eigen::Matrix<double, kSpidarStrings, 2, Eigen::DontAlign> null_space;  ///< orthonormal columns
};

/// By a QR factorisation of W^T with column pivoting, torques divided by `radius` (m) for its decision on the rank.
/// Does not allocate.
SpidarNullSpace spidar_null_space(const SpidarWrenchMatrix& W, double radius) noexcept;

/// A direction n among wrenches that at most three strings push along, the others displaying nothing along it:
/// weights = W^T n of those three, at most 1.
struct SpidarFacet {
  std::array<int, 3> strings{};
  std::array<double, 3> weights{};
};

/// All of them: the wrenches that tensions within limits display, a zonotope, are those w with
/// n . w <= facet_reach for each.
struct SpidarFacets {
  static constexpr std::size_t kCapacity = 112;  ///< both signs of each three of eight strings
  std::array<SpidarFacet, kCapacity> facets;
  std::size_t count = 0;
};

/// The weights of strings i, j, k are the areas N_j x N_k, N_k x N_i and N_i x N_j of rows of the null space N, as up
/// to scale these alone have N^T weights = 0. Threes of parallel rows make none. Does not allocate.
SpidarFacets spidar_facets(const SpidarNullSpace& space) noexcept;

/// Greatest of weights . t over tensions t within the limits.
double facet_reach(const SpidarFacet& facet, const SpidarVector& min, const SpidarVector& max) noexcept;

/// weights . t
double along(const SpidarFacet& facet, const SpidarVector& tensions) noexcept;

}  // namespace tegotae
