// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/shape/bounding_box.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace tegotae {

/// A set of boxes and one query box, with the end points of the boxes sorted along each axis. For each box six
/// conditions are kept: on each axis, that it begins before the query ends and that it ends after the query begins. It
/// overlaps the query when all six hold.
class SortedBounds {
 public:
  /// Adds a box and returns its index (0, 1, 2 ...); the lists are sorted at the next query. Allocates.
  int add(const BoundingBox& box);
  /// Repairs the lists by insertion: fast when the box moved past few others. Does not allocate.
  void update(int index, const BoundingBox& box) noexcept;
  /// Indices of all boxes that overlap `query`, ascending, valid until the next call. Allocates only after `add`.
  std::span<const int> overlapping(const BoundingBox& query);

 private:
  static constexpr std::uint8_t kAllConditions = 0x3f;

  /// The lower or the upper ends on one axis, ascending. `passed` counts the ends that lie before the query's opposite
  /// end: the lower ends <= its upper end, or the upper ends < its lower end.
  struct Ends {
    std::vector<double> values;
    std::vector<int> boxes;      ///< which box each value belongs to
    std::vector<int> positions;  ///< where each box' value stands
    size_t passed = 0;
  };
  static bool is_upper(size_t list) noexcept { return list >= 3; }
  static double end_of(const BoundingBox& box, size_t list) noexcept {
    return is_upper(list) ? box.upper(static_cast<Eigen::Index>(list - 3)) : box.lower(static_cast<Eigen::Index>(list));
  }
  double query_end(size_t list) const noexcept { return end_of(query_, (list + 3) % 6); }
  bool lies_before_query(size_t list, double value) const noexcept {
    return is_upper(list) ? value < query_end(list) : value <= query_end(list);
  }

  void sort_all();
  void sweep(size_t list) noexcept;
  void move_end(size_t list, int index, double value) noexcept;
  void set_condition(int box, size_t list, bool before) noexcept;

  std::array<Ends, 6> lists_;  ///< lower x, y, z, upper x, y, z
  std::vector<BoundingBox> boxes_;
  std::vector<std::uint8_t> conditions_;  ///< by box: a bit for each list
  std::vector<int> overlapping_;          ///< ascending
  BoundingBox query_;
  bool sorted_ = true;
};

}  // namespace tegotae
