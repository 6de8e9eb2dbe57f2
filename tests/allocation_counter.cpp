// SPDX-License-Identifier: Apache-2.0
#include <tests/allocation_counter.hpp>

#include <cerrno>
#include <cstddef>

#if defined(__has_feature)
#define TEGOTAE_HAS_FEATURE(name) __has_feature(name)
#else
#define TEGOTAE_HAS_FEATURE(name) 0
#endif
#if defined(__SANITIZE_THREAD__) || TEGOTAE_HAS_FEATURE(thread_sanitizer)
#define TEGOTAE_THREAD_SANITIZER 1
#else
#define TEGOTAE_THREAD_SANITIZER 0
#endif
#if TEGOTAE_THREAD_SANITIZER || defined(__SANITIZE_ADDRESS__) || TEGOTAE_HAS_FEATURE(address_sanitizer)
#define TEGOTAE_SANITIZED_HEAP 1
#else
#define TEGOTAE_SANITIZED_HEAP 0
#endif

namespace {
thread_local std::uint64_t allocations = 0;
}  // namespace

namespace tegotae::test {
std::uint64_t thread_allocations() noexcept { return allocations; }
bool counts_aligned_alloc() noexcept { return TEGOTAE_THREAD_SANITIZER == 0; }
}  // namespace tegotae::test

#if TEGOTAE_SANITIZED_HEAP

// Of the sanitizers' runtime; g++'s packages come without the header that declares it.
// NOLINTNEXTLINE(bugprone-reserved-identifier,readability-identifier-naming)
extern "C" int __sanitizer_install_malloc_and_free_hooks(void (*on_malloc)(const volatile void*, std::size_t),
                                                         void (*on_free)(const volatile void*));

// The sanitizer's own heap must stay in place; it tells of each allocation.
namespace {
const int installed = __sanitizer_install_malloc_and_free_hooks(
    [](const volatile void*, std::size_t) { ++allocations; }, [](const volatile void*) {});
}  // namespace

#else

// The C library's entry points, counted and handed on to its own implementation. Names and signatures are the
// library's. NOLINTBEGIN(bugprone-reserved-identifier,readability-identifier-naming,misc-definitions-in-headers)
extern "C" {
void* __libc_malloc(std::size_t size) noexcept;
void* __libc_calloc(std::size_t count, std::size_t size) noexcept;
void* __libc_realloc(void* old, std::size_t size) noexcept;
void* __libc_memalign(std::size_t alignment, std::size_t size) noexcept;

void* malloc(std::size_t size) noexcept {
  ++allocations;
  return __libc_malloc(size);
}

void* calloc(std::size_t count, std::size_t size) noexcept {
  ++allocations;
  return __libc_calloc(count, size);
}

void* realloc(void* old, std::size_t size) noexcept {
  ++allocations;
  return __libc_realloc(old, size);
}

void* memalign(std::size_t alignment, std::size_t size) noexcept {
  ++allocations;
  return __libc_memalign(alignment, size);
}

void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept { return memalign(alignment, size); }

int posix_memalign(void** result, std::size_t alignment, std::size_t size) noexcept {
  void* memory = memalign(alignment, size);
  if (memory == nullptr) return ENOMEM;
  *result = memory;
  return 0;
}
}
// NOLINTEND(bugprone-reserved-identifier,readability-identifier-naming,misc-definitions-in-headers)

#endif
