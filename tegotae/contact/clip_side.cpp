// SPDX-License-Identifier: Apache-2.0
#include <tegotae/contact/clip_side.hpp>

#include <algorithm>

namespace tegotae {

ClipSide::ClipSide(int max_vertices)
    : points_(static_cast<size_t>(max_vertices)),
      outside_(points_.size()),
      plane_(points_.size()),
      stack_(points_.size()) {}

bool ClipSide::classify(std::span<const ClipPlane> planes, size_t count) noexcept {
  masked_ = true;
  std::fill_n(outside_.begin(), count, std::uint64_t{0});
  // Plane by plane: without a branch, the inner loop takes a few cycles a vertex.
  for (size_t k = 0; k < planes.size(); ++k) {
    const double x = planes[k].normal.x(), y = planes[k].normal.y(), z = planes[k].normal.z();
    const double limit = planes[k].offset + tolerances::kOnPlane;
    for (size_t i = 0; i < count; ++i) {
      const Vector3& p = points_[i];
      outside_[i] |= static_cast<std::uint64_t>(x * p.x() + y * p.y() + z * p.z() > limit) << k;
    }
  }
  std::uint64_t common = ~std::uint64_t{0};
  for (size_t i = 0; i < count; ++i) {
    common &= outside_[i];
    plane_[i] = std::countr_zero(outside_[i]) % static_cast<int>(kMaskBits);
  }
  return common == 0;
}

}  // namespace tegotae
