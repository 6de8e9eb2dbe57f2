// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/math/types.hpp>

#include <cstdint>

namespace tegotae {

/// Which features of the two shapes meet in a vertex of their intersection.
enum class IntersectionVertexKind : std::uint8_t {
  kUnknown,             ///< the dual form does not name features
  kToolVertex,          ///< a: vertex of the tool
  kObjectVertex,        ///< a: vertex of the object
  kObjectCorner,        ///< a < b < c: faces of the object; dilation splits a vertex of four or more faces into such
  kToolEdgeObjectFace,  ///< a: edge of the tool; b: face of the object (0 for a plane)
  kObjectEdgeToolFace   ///< a < b: faces that meet in the edge of the object; c: face of the tool
};

/// Indices into the polytope of each shape: into that of the shape itself or, for curved shapes, of its stand-in.
struct IntersectionFeature {
  static constexpr int kIndexBits = 20;
  static constexpr int kIndexLimit = 1 << kIndexBits;  ///< indices are below

  IntersectionVertexKind kind = IntersectionVertexKind::kUnknown;
  int a = 0, b = 0, c = 0;

  /// All in one number that is never 0 for a known kind.
  constexpr std::uint64_t packed() const noexcept {
    return (static_cast<std::uint64_t>(kind) << (3 * kIndexBits)) |
           (static_cast<std::uint64_t>(a) << (2 * kIndexBits)) | (static_cast<std::uint64_t>(b) << kIndexBits) |
           static_cast<std::uint64_t>(c);
  }
  static constexpr IntersectionFeature unpacked(std::uint64_t feature) noexcept {
    constexpr std::uint64_t kMask = kIndexLimit - 1;
    return {static_cast<IntersectionVertexKind>(feature >> (3 * kIndexBits)),
            static_cast<int>((feature >> (2 * kIndexBits)) & kMask), static_cast<int>((feature >> kIndexBits) & kMask),
            static_cast<int>(feature & kMask)};
  }
};

/// One vertex of an intersection. `feature` is an IntersectionFeature, packed: the same features give the same value
/// while the shapes move, so it matches contact points from one step to the next.
struct IntersectionVertex {
  Vector3 p_W = Vector3::Zero();  ///< m
  std::uint64_t feature = 0;      ///< 0 = unknown
};

}  // namespace tegotae
