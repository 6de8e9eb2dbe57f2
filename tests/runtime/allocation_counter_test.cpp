// SPDX-License-Identifier: Apache-2.0
#include <tests/allocation_counter.hpp>

#include <gtest/gtest.h>
#include <Eigen/Core>

#include <cstdlib>
#include <memory>
#include <new>
#include <thread>
#include <vector>

namespace tegotae::test {
namespace {

// Where the compiler cannot see that the memory is not used.
void* volatile sink = nullptr;

TEST(AllocationCounter, CountsEveryWayToTheHeap) {
  const AllocationCounter counter;
  EXPECT_EQ(counter.count(), 0U);
  void* plain = std::malloc(100);
  sink = plain;
  EXPECT_EQ(counter.count(), 1U);
  void* zeroed = std::calloc(10, 10);
  sink = zeroed;
  EXPECT_EQ(counter.count(), 2U);
  auto object = std::make_unique<double>(1.0);
  sink = object.get();
  EXPECT_EQ(counter.count(), 3U);
  Eigen::VectorXd vector(100);
  sink = vector.data();
  EXPECT_EQ(counter.count(), 4U);
  std::vector<int> numbers(100);
  sink = numbers.data();
  EXPECT_EQ(counter.count(), 5U);
  std::free(plain);
  std::free(zeroed);
}

TEST(AllocationCounter, CountsAlignedAllocations) {
  struct alignas(512) Wide {
    char byte = 0;
  };
  const AllocationCounter counter;
  void* aligned = std::aligned_alloc(256, 256);
  sink = aligned;
  const std::uint64_t first = counts_aligned_alloc() ? 1 : 0;
  EXPECT_EQ(counter.count(), first);
  auto wide = std::make_unique<Wide>();
  sink = wide.get();
  EXPECT_EQ(counter.count(), first + 1);
  std::free(aligned);
}

TEST(AllocationCounter, CountsTheCallingThreadOnly) {
  std::thread other([] {
    for (int i = 0; i < 100; ++i) sink = std::make_unique<int>(i).get();
  });
  const AllocationCounter counter;
  other.join();
  EXPECT_EQ(counter.count(), 0U);
}

TEST(AllocationCounter, StackIsNotTheHeap) {
  const AllocationCounter counter;
  const Eigen::Matrix<double, 6, 6> matrix = Eigen::Matrix<double, 6, 6>::Random();
  volatile double number = (matrix * matrix).trace();
  EXPECT_EQ(number, number);
  EXPECT_EQ(counter.count(), 0U);
}

}  // namespace
}  // namespace tegotae::test
