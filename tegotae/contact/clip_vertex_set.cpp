// SPDX-License-Identifier: Apache-2.0
#include <tegotae/contact/clip_vertex_set.hpp>

#include <tegotae/contact/tolerances.hpp>

#include <algorithm>
#include <bit>
#include <cmath>

namespace tegotae {
namespace {

// Wide against kSameVertex, so that few points lie near a cell's border; narrow against the distance of vertices.
constexpr double kCellsPerMetre = 1e5;

std::int64_t cell_index(double coordinate) noexcept {
  constexpr double kLimit = 9e18;
  return static_cast<std::int64_t>(std::clamp(coordinate * kCellsPerMetre, -kLimit, kLimit));
}

}  // namespace

ClipVertexSet::ClipVertexSet(int capacity)
    : members_(static_cast<size_t>(capacity)), slots_(std::bit_ceil(2 * static_cast<size_t>(capacity) + 2)) {}

void ClipVertexSet::clear() noexcept {
  size_ = 0;
  if (++generation_ == 0) {
    std::fill(slots_.begin(), slots_.end(), Slot{});
    generation_ = 1;
  }
}

ClipVertexSet::Cell ClipVertexSet::cell_of(const Vector3& p) noexcept {
  return {cell_index(p.x()), cell_index(p.y()), cell_index(p.z())};
}

size_t ClipVertexSet::slot_of(const Cell& cell) const noexcept {
  const std::uint64_t mixed = static_cast<std::uint64_t>(cell.x) * 0x9E3779B97F4A7C15ULL +
                              static_cast<std::uint64_t>(cell.y) * 0xC2B2AE3D27D4EB4FULL +
                              static_cast<std::uint64_t>(cell.z) * 0x165667B19E3779F9ULL;
  return static_cast<size_t>(mixed ^ (mixed >> 29)) & (slots_.size() - 1);
}

bool ClipVertexSet::cell_holds(const Cell& cell, const Vector3& p) const noexcept {
  constexpr double kSquare = tolerances::kSameVertex * tolerances::kSameVertex;
  for (size_t s = slot_of(cell); slots_[s].generation == generation_; s = (s + 1) & (slots_.size() - 1)) {
    if ((members_[static_cast<size_t>(slots_[s].member)].p - p).squaredNorm() <= kSquare) return true;
  }
  return false;
}

bool ClipVertexSet::contains(const Vector3& p) const noexcept {
  const Vector3 reach = Vector3::Constant(tolerances::kSameVertex);
  const Cell lower = cell_of(p - reach), upper = cell_of(p + reach);
  for (std::int64_t x = lower.x; x <= upper.x; ++x) {
    for (std::int64_t y = lower.y; y <= upper.y; ++y) {
      for (std::int64_t z = lower.z; z <= upper.z; ++z) {
        if (cell_holds({x, y, z}, p)) return true;
      }
    }
  }
  return false;
}

// The usual case: whatever might be the same point lies in the same cell.
bool ClipVertexSet::is_clear_of_borders(const Vector3& p, const Cell& cell) noexcept {
  constexpr double kReach = 2.0 * tolerances::kSameVertex * kCellsPerMetre;
  const auto clear = [](double coordinate, std::int64_t index) {
    const double part = std::abs(coordinate * kCellsPerMetre - static_cast<double>(index));
    return part > kReach && part < 1.0 - kReach;
  };
  return clear(p.x(), cell.x) && clear(p.y(), cell.y) && clear(p.z(), cell.z);
}

void ClipVertexSet::add(const Vector3& p, const IntersectionFeature& feature) noexcept {
  const Cell cell = cell_of(p);
  if (!(is_clear_of_borders(p, cell) ? cell_holds(cell, p) : contains(p))) insert(cell, p, feature);
}

void ClipVertexSet::add_new(const Vector3& p, const IntersectionFeature& feature) noexcept {
  insert(cell_of(p), p, feature);
}

void ClipVertexSet::insert(const Cell& cell, const Vector3& p, const IntersectionFeature& feature) noexcept {
  if (size_ == static_cast<int>(members_.size())) return;
  size_t s = slot_of(cell);
  while (slots_[s].generation == generation_) s = (s + 1) & (slots_.size() - 1);
  slots_[s] = {generation_, size_};
  members_[static_cast<size_t>(size_)] = {p, feature.packed()};
  ++size_;
}

}  // namespace tegotae
