// SPDX-License-Identifier: Apache-2.0
#include <tests/lock_counter.hpp>

#include <dlfcn.h>
#include <pthread.h>
#include <semaphore.h>

namespace {
thread_local std::uint64_t locks = 0;
}  // namespace

namespace tegotae::test {
std::uint64_t thread_locks() noexcept { return locks; }
}  // namespace tegotae::test

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)

namespace {

// The C library's own function of that name.
template <class Function>
Function* own(const char* name) noexcept {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

}  // namespace

// The C library's entry points, counted and handed on.
extern "C" {

int pthread_mutex_lock(pthread_mutex_t* mutex) noexcept {
  static auto* const function = own<int(pthread_mutex_t*)>("pthread_mutex_lock");
  ++locks;
  return function(mutex);
}

int pthread_mutex_trylock(pthread_mutex_t* mutex) noexcept {
  static auto* const function = own<int(pthread_mutex_t*)>("pthread_mutex_trylock");
  ++locks;
  return function(mutex);
}

int pthread_rwlock_rdlock(pthread_rwlock_t* lock) noexcept {
  static auto* const function = own<int(pthread_rwlock_t*)>("pthread_rwlock_rdlock");
  ++locks;
  return function(lock);
}

int pthread_rwlock_wrlock(pthread_rwlock_t* lock) noexcept {
  static auto* const function = own<int(pthread_rwlock_t*)>("pthread_rwlock_wrlock");
  ++locks;
  return function(lock);
}

int pthread_cond_wait(pthread_cond_t* condition, pthread_mutex_t* mutex) {
  static auto* const function = own<int(pthread_cond_t*, pthread_mutex_t*)>("pthread_cond_wait");
  ++locks;
  return function(condition, mutex);
}

int sem_wait(sem_t* semaphore) {
  static auto* const function = own<int(sem_t*)>("sem_wait");
  ++locks;
  return function(semaphore);
}

}  // extern "C"

#endif
