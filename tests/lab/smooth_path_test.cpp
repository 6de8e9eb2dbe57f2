// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/motion.hpp>
#include <tegotae/lab/smooth_path.hpp>

#include <gtest/gtest.h>

#include <stdexcept>

namespace tegotae {
namespace {

const SmoothPath kPath({{1.0, 2.0}, {2.0, 5.0}, {4.0, -1.0}});

TEST(SmoothPath, PassesThroughItsKeysAndIsHeldOutside) {
  EXPECT_EQ(kPath.at(-3.0), 2.0);
  EXPECT_EQ(kPath.at(1.0), 2.0);
  EXPECT_EQ(kPath.at(2.0), 5.0);
  EXPECT_EQ(kPath.at(4.0), -1.0);
  EXPECT_EQ(kPath.at(40.0), -1.0);
}

TEST(SmoothPath, GoesFromKeyToKeyAsASmoothStep) {
  for (int i = 0; i <= 300; ++i) {
    const double time = 1.0 + 0.01 * i;
    const double expected =
        time < 2.0 ? SmoothStep{1.0, 2.0, 2.0, 5.0}.at(time) : SmoothStep{2.0, 4.0, 5.0, -1.0}.at(time);
    EXPECT_DOUBLE_EQ(kPath.at(time), expected);
  }
}

TEST(SmoothPath, RestsAtItsKeys) {
  for (const double key : {1.0, 2.0, 4.0}) EXPECT_NEAR(kPath.at(key + 1e-4), kPath.at(key - 1e-4), 1e-9);
}

TEST(SmoothPath, RefusesKeysThatDoNotAscend) {
  EXPECT_THROW(SmoothPath({}), std::invalid_argument);
  EXPECT_THROW(SmoothPath({{1.0, 0.0}, {1.0, 1.0}}), std::invalid_argument);
  EXPECT_THROW(SmoothPath({{1.0, 0.0}, {0.5, 1.0}}), std::invalid_argument);
}

}  // namespace
}  // namespace tegotae
