// SPDX-License-Identifier: Apache-2.0
#include <tegotae/contact/sweep_and_prune.hpp>

#include <algorithm>
#include <stdexcept>
#include <string>

namespace tegotae {

int SweepAndPrune::add(SortedBounds& set, std::vector<int>& handles, const BoundingBox& box, bool moving) {
  const int handle = static_cast<int>(places_.size());
  places_.push_back({moving, set.add(box)});
  handles.push_back(handle);
  candidates_.reserve(places_.size());
  return handle;
}

int SweepAndPrune::add_static(const BoundingBox& box) { return add(static_, static_handles_, box, false); }

int SweepAndPrune::add_moving(const BoundingBox& box) { return add(moving_, moving_handles_, box, true); }

void SweepAndPrune::update(int handle, const BoundingBox& box) {
  if (handle < 0 || handle >= static_cast<int>(places_.size()) || !places_[static_cast<size_t>(handle)].moving) {
    throw std::invalid_argument("box " + std::to_string(handle) + " of a sweep and prune is not a moving one");
  }
  moving_.update(places_[static_cast<size_t>(handle)].index, box);
}

std::span<const int> SweepAndPrune::candidates(const BoundingBox& query) {
  candidates_.clear();
  for (const int index : static_.overlapping(query)) {
    candidates_.push_back(static_handles_[static_cast<size_t>(index)]);
  }
  const auto middle = static_cast<std::ptrdiff_t>(candidates_.size());
  for (const int index : moving_.overlapping(query)) {
    candidates_.push_back(moving_handles_[static_cast<size_t>(index)]);
  }
  // Both halves are few and sorted. std::inplace_merge might allocate; sorting does not.
  if (middle > 0) std::sort(candidates_.begin(), candidates_.end());
  return candidates_;
}

}  // namespace tegotae
