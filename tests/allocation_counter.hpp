// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace tegotae::test {

/// Heap allocations of the calling thread since it started: every malloc, calloc, realloc and aligned allocation, and
/// so operator new and Eigen's dynamic matrices. Linked into every test program, which it makes count.
std::uint64_t thread_allocations() noexcept;

/// False under ThreadSanitizer, whose heap does not tell of aligned_alloc and its kin: those are then not counted.
bool counts_aligned_alloc() noexcept;

/// Counts the allocations of the calling thread from here on.
class AllocationCounter {
 public:
  std::uint64_t count() const noexcept { return thread_allocations() - start_; }

 private:
  std::uint64_t start_ = thread_allocations();
};

}  // namespace tegotae::test
