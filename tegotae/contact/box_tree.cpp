// SPDX-License-Identifier: Apache-2.0
#include <tegotae/contact/box_tree.hpp>

#include <algorithm>
#include <limits>
#include <numeric>

namespace tegotae {
namespace {

// m. Unbounded boxes are sorted as if they ended here.
constexpr double kFarAway = 1e30;

Vector3 centre_of(const BoundingBox& box) {
  return 0.5 * (box.lower.cwiseMax(-kFarAway) + box.upper.cwiseMin(kFarAway));
}

}  // namespace

BoxTree::BoxTree(std::span<const BoundingBox> boxes) {
  std::vector<int> indices(boxes.size());
  std::iota(indices.begin(), indices.end(), 0);
  nodes_.reserve(2 * boxes.size());
  if (!boxes.empty()) add(boxes, indices);
}

void BoxTree::add(std::span<const BoundingBox> boxes, std::span<int> indices) {
  const size_t place = nodes_.size();
  nodes_.emplace_back();
  BoundingBox centres;
  for (const int index : indices) {
    const BoundingBox& box = boxes[static_cast<size_t>(index)];
    nodes_[place].box = nodes_[place].box.united(box);
    const Vector3 centre = centre_of(box);
    centres = centres.united({centre, centre});
  }
  if (indices.size() == 1) {
    nodes_[place].index = indices.front();
  } else {
    Eigen::Index axis = 0;
    (centres.upper - centres.lower).maxCoeff(&axis);
    const auto before = [&](int a, int b) {
      const double p = centre_of(boxes[static_cast<size_t>(a)])(axis),
                   q = centre_of(boxes[static_cast<size_t>(b)])(axis);
      return p != q ? p < q : a < b;
    };
    const size_t half = indices.size() / 2;
    std::nth_element(indices.begin(), indices.begin() + static_cast<std::ptrdiff_t>(half), indices.end(), before);
    add(boxes, indices.first(half));
    add(boxes, indices.subspan(half));
  }
  nodes_[place].next = nodes_.size();
}

BoundingBox turned_box(const BoundingBox& box_B, const Pose& X_AB) noexcept {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const Vector3 half = 0.5 * (box_B.upper - box_B.lower);
  if (!half.allFinite()) return {Vector3::Constant(-kInfinity), Vector3::Constant(kInfinity)};
  const Vector3 centre = X_AB * (0.5 * (box_B.lower + box_B.upper));
  const Vector3 reach = X_AB.rotation().cwiseAbs() * half;
  return {centre - reach, centre + reach};
}

}  // namespace tegotae
