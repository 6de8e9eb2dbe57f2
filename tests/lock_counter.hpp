// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace tegotae::test {

/// Locks that the calling thread has taken since it started: mutexes, reader-writer locks, semaphores and waits on
/// conditions, of C++ and of C. Linked into every test program, which it makes count. Under a sanitizer, which has its
/// own in their place, it stays 0.
std::uint64_t thread_locks() noexcept;

/// Counts the locks of the calling thread from here on.
class LockCounter {
 public:
  std::uint64_t count() const noexcept { return thread_locks() - start_; }

 private:
  std::uint64_t start_ = thread_locks();
};

}  // namespace tegotae::test
