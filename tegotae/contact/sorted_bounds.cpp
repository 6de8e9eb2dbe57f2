// SPDX-License-Identifier: Apache-2.0
#include <tegotae/contact/sorted_bounds.hpp>

#include <algorithm>
#include <numeric>

namespace tegotae {
namespace {

bool is_number(const BoundingBox& box) noexcept {
  return !box.lower.array().isNaN().any() && !box.upper.array().isNaN().any();
}

// What is not a number cannot be sorted: such a box becomes the empty one.
BoundingBox sortable(const BoundingBox& box) noexcept { return is_number(box) ? box : BoundingBox{}; }

}  // namespace

int SortedBounds::add(const BoundingBox& box) {
  boxes_.push_back(sortable(box));
  sorted_ = false;
  return static_cast<int>(boxes_.size()) - 1;
}

void SortedBounds::update(int index, const BoundingBox& box) noexcept {
  const BoundingBox next = sortable(box);
  boxes_[static_cast<size_t>(index)] = next;
  if (!sorted_) return;
  for (size_t list = 0; list < lists_.size(); ++list) move_end(list, index, end_of(next, list));
}

std::span<const int> SortedBounds::overlapping(const BoundingBox& query) {
  if (!is_number(query)) return {};
  if (!sorted_) sort_all();
  query_ = query;
  for (size_t list = 0; list < lists_.size(); ++list) sweep(list);
  return overlapping_;
}

void SortedBounds::sort_all() {
  const size_t n = boxes_.size();
  for (size_t list = 0; list < lists_.size(); ++list) {
    Ends& ends = lists_[list];
    ends.boxes.resize(n);
    ends.values.resize(n);
    ends.positions.resize(n);
    std::iota(ends.boxes.begin(), ends.boxes.end(), 0);
    const auto value = [&](int box) { return end_of(boxes_[static_cast<size_t>(box)], list); };
    std::stable_sort(ends.boxes.begin(), ends.boxes.end(), [&](int a, int b) { return value(a) < value(b); });
    for (size_t i = 0; i < n; ++i) {
      ends.values[i] = value(ends.boxes[i]);
      ends.positions[static_cast<size_t>(ends.boxes[i])] = static_cast<int>(i);
    }
    ends.passed = 0;
  }
  // Nothing passed yet: no box begins before the query ends, every box ends after it begins.
  conditions_.assign(n, 0x38);
  overlapping_.clear();
  overlapping_.reserve(n);
  sorted_ = true;
}

// Moves the query's end to its new place among the ends of the boxes.
void SortedBounds::sweep(size_t list) noexcept {
  Ends& ends = lists_[list];
  while (ends.passed < ends.values.size() && lies_before_query(list, ends.values[ends.passed])) {
    set_condition(ends.boxes[ends.passed], list, true);
    ++ends.passed;
  }
  while (ends.passed > 0 && !lies_before_query(list, ends.values[ends.passed - 1])) {
    --ends.passed;
    set_condition(ends.boxes[ends.passed], list, false);
  }
}

void SortedBounds::move_end(size_t list, int index, double value) noexcept {
  Ends& ends = lists_[list];
  size_t i = static_cast<size_t>(ends.positions[static_cast<size_t>(index)]);
  const bool was_before = i < ends.passed, is_before = lies_before_query(list, value);
  const auto take = [&](size_t from, size_t to) {
    ends.values[to] = ends.values[from];
    ends.boxes[to] = ends.boxes[from];
    ends.positions[static_cast<size_t>(ends.boxes[to])] = static_cast<int>(to);
  };
  for (; i > 0 && ends.values[i - 1] > value; --i) take(i - 1, i);
  for (; i + 1 < ends.values.size() && ends.values[i + 1] < value; ++i) take(i + 1, i);
  ends.values[i] = value;
  ends.boxes[i] = index;
  ends.positions[static_cast<size_t>(index)] = static_cast<int>(i);
  if (was_before == is_before) return;
  ends.passed += is_before ? 1 : static_cast<size_t>(-1);
  set_condition(index, list, is_before);
}

void SortedBounds::set_condition(int box, size_t list, bool before) noexcept {
  std::uint8_t& conditions = conditions_[static_cast<size_t>(box)];
  const auto bit = static_cast<std::uint8_t>(1U << list);
  const bool overlapped = conditions == kAllConditions;
  // A box ends after the query begins while its upper end does not lie before.
  const bool holds = before != is_upper(list);
  conditions = static_cast<std::uint8_t>(holds ? conditions | bit : conditions & ~bit);
  const bool overlaps = conditions == kAllConditions;
  if (overlaps == overlapped) return;
  const auto place = std::lower_bound(overlapping_.begin(), overlapping_.end(), box);
  if (overlaps) {
    overlapping_.insert(place, box);
  } else {
    overlapping_.erase(place);
  }
}

}  // namespace tegotae
