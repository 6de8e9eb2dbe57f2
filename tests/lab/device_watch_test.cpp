// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/device_watch.hpp>

#include <gtest/gtest.h>

#include <vector>

namespace tegotae {
namespace {

using News = DeviceWatch::News;

TEST(DeviceWatch, SaysOnceThatADeviceIsSilentAndOnceThatItIsBack) {
  DeviceWatch watch;
  std::vector<News> told;
  for (int tick = 0; tick < 3000; ++tick) {
    const News news = watch.see(1e-3 * tick, tick >= 1000 && tick < 2000);
    if (news != News::kNone) told.push_back(news);
    if (tick == 1240) {
      EXPECT_TRUE(told.empty());
    }
    if (tick == 1260) {
      EXPECT_EQ(told.size(), 1u);
    }
  }
  EXPECT_EQ(told, (std::vector<News>{News::kSilent, News::kBack}));
}

TEST(DeviceWatch, ATickThatFailsNowAndThenIsNotWorthAWord) {
  DeviceWatch watch;
  for (int tick = 0; tick < 3000; ++tick) EXPECT_EQ(watch.see(1e-3 * tick, tick % 97 == 0), News::kNone) << tick;
}

TEST(DeviceWatch, OneThatAnswersNowAndThenStaysSilent) {
  DeviceWatch watch;
  int told = 0;
  for (int tick = 0; tick < 1000; ++tick) told += watch.see(1e-3 * tick, true) != News::kNone ? 1 : 0;
  for (int tick = 1000; tick < 3000; ++tick) told += watch.see(1e-3 * tick, tick % 97 != 0) != News::kNone ? 1 : 0;
  EXPECT_EQ(told, 1);
}

}  // namespace
}  // namespace tegotae
