// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/works.hpp>

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <stdexcept>
#include <string>
#include <vector>

namespace tegotae {
namespace {

TEST(Works, AreEachPerformedOnceOnAnyNumberOfThreads) {
  for (const unsigned threads : {0U, 1U, 3U, 50U}) {
    std::array<std::atomic<int>, 20> times{};
    std::vector<Work> works;
    for (auto& count : times) works.push_back({1.0, [&count](const Progress&) { ++count; }});
    std::vector<double> told;
    perform_works(works, threads, nullptr, [&](double part) { told.push_back(part); });
    for (const auto& count : times) EXPECT_EQ(count, 1);
    EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
    ASSERT_FALSE(told.empty());
    EXPECT_NEAR(told.back(), 1.0, 1e-12);
  }
  perform_works({}, 2, nullptr, [](double) {});
}

TEST(Works, TellTheWeightedPartThatIsDone) {
  std::vector<double> told;
  const std::vector<Work> works = {{3.0, [](const Progress& progress) { progress(0.5); }},
                                   {1.0, [](const Progress& progress) {
                                      progress(2.0);
                                      progress(0.1);  // back again: not believed
                                    }}};
  perform_works(works, 1, nullptr, [&](double part) { told.push_back(part); });
  EXPECT_EQ(told, (std::vector<double>{0.375, 0.75, 1.0, 1.0, 1.0}));
}

TEST(Works, OneThatFailsHindersNoOther) {
  std::string why;
  int performed = 0;
  const std::vector<Work> works = {
      {1.0, [](const Progress&) { throw std::runtime_error("no luck"); }, [&](const std::string& what) { why = what; }},
      {1.0, [](const Progress&) { throw std::runtime_error("nobody is told"); }},
      {1.0, [&](const Progress&) { ++performed; }}};
  perform_works(works, 1, nullptr, [](double) {});
  EXPECT_EQ(why, "no luck");
  EXPECT_EQ(performed, 1);
}

TEST(Works, EndWhereTheyTellProgressOnceStopped) {
  std::atomic<bool> stop{false};
  bool ended = false, begun = false, failed = false;
  const std::vector<Work> works = {{1.0,
                                    [&](const Progress& progress) {
                                      progress(0.1);
                                      stop = true;
                                      progress(0.2);
                                      ended = true;
                                    },
                                    [&](const std::string&) { failed = true; }},
                                   {1.0, [&](const Progress&) { begun = true; }}};
  perform_works(works, 1, &stop, [](double) {});
  EXPECT_FALSE(ended);
  EXPECT_FALSE(begun);
  EXPECT_FALSE(failed);
}

}  // namespace
}  // namespace tegotae
