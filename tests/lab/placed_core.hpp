// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/lab/convex_core.hpp>

namespace tegotae::test {

inline ConvexCore placed_core(const Shape& shape, const Pose& X_WB) {
  ConvexCore placed;
  place(core_of(shape), X_WB, placed);
  return placed;
}

}  // namespace tegotae::test
