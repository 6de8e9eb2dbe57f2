// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/contact/intersection_vertex.hpp>

#include <cstdint>
#include <vector>

namespace tegotae {

/// Points, none of them twice: what lies within `tolerances::kSameVertex` of a member is that member, and the first one
/// to come gives the name. A hash grid of fixed memory, cleared in constant time.
class ClipVertexSet {
 public:
  struct Member {
    Vector3 p = Vector3::Zero();  ///< m, in a frame near the shapes
    std::uint64_t feature = 0;
  };

  /// Allocates; nothing else does.
  explicit ClipVertexSet(int capacity);

  void clear() noexcept;
  /// Adds a point unless it is there already.
  void add(const Vector3& p, const IntersectionFeature& feature) noexcept;
  /// Adds a point that is known to be new.
  void add_new(const Vector3& p, const IntersectionFeature& feature) noexcept;

  int size() const noexcept { return size_; }
  const Member& operator[](int i) const noexcept { return members_[static_cast<size_t>(i)]; }

 private:
  struct Cell {
    std::int64_t x, y, z;
  };
  struct Slot {
    std::uint32_t generation = 0;
    int member = 0;
  };
  static Cell cell_of(const Vector3& p) noexcept;
  static bool is_clear_of_borders(const Vector3& p, const Cell& cell) noexcept;
  void insert(const Cell& cell, const Vector3& p, const IntersectionFeature& feature) noexcept;
  size_t slot_of(const Cell& cell) const noexcept;
  bool cell_holds(const Cell& cell, const Vector3& p) const noexcept;
  bool contains(const Vector3& p) const noexcept;

  std::vector<Member> members_;
  std::vector<Slot> slots_;
  std::uint32_t generation_ = 0;
  int size_ = 0;
};

}  // namespace tegotae
