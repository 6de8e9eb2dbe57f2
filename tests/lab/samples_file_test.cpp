// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/input_error.hpp>
#include <tegotae/lab/samples_file.hpp>
#include <tests/lab/samples_table.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace tegotae {
namespace {

using testing::ElementsAreArray;
using testing::HasSubstr;

TickRecord distinct_record() {
  TickRecord record;
  record.time = 0.009000000000000001;
  record.X_WT = Pose{{1.0, 2.0, 3.0}, Quaternion(0.5, -0.5, 0.5, -0.5)};
  record.wrench = Wrench{{4.0, 5.0, 6.0}, {7.0, 8.0, 9.0}};
  record.displayed = Wrench{{10.0, 11.0, 12.0}, {13.0, 14.0, -0.0}};
  record.X_WP = Pose{{16.0, 17.0, 18.0}, Quaternion(1.0, 0.0, 0.0, 0.0)};
  record.near_objects = 20;
  record.planes = 21;
  record.contact_points = 22;
  record.constraints = 23;
  record.active = 24;
  record.solver_iterations = 25;
  record.status = 2;
  record.safety_events = 5;
  record.deepest = 0.1 + 0.2;
  record.model_age = 0.05;
  record.model_sequence = 27;
  record.dropped = 28;
  record.tick_us = 29.5;
  return record;
}

SamplesTable table_of(const TickRecord& record, double start) {
  const TemporaryFolder folder;
  SamplesFile file(folder.path() / "samples.csv", {"method: paper"}, start);
  file.write(record);
  file.close();
  return read_samples(folder.path() / "samples.csv");
}

TEST(SamplesFile, BeginsWithTheColumnsThatReadersRelyOn) {
  const SamplesTable table = table_of({}, 0.0);
  const std::vector<std::string> first(table.names.begin(), table.names.begin() + 14);
  EXPECT_THAT(first,
              ElementsAreArray({"t", "x", "y", "z", "qw", "qx", "qy", "qz", "fx", "fy", "fz", "tx", "ty", "tz"}));
  EXPECT_EQ(table.names.back(), "tick_us");
  EXPECT_EQ(table.rows.at(0).size(), table.names.size());
}

TEST(SamplesFile, CarriesVersionNotesAndUnitsInItsHead) {
  const SamplesTable table = table_of({}, 0.0);
  EXPECT_EQ(table.comments.at(0), "# tegotae samples, format 1");
  EXPECT_EQ(table.comments.at(1), "# method: paper");
  EXPECT_THAT(table.comments.back(), HasSubstr("t[s] x[m]"));
  EXPECT_THAT(table.comments.back(), HasSubstr("tz[N m]"));
}

TEST(SamplesFile, PutsEachValueInItsColumn) {
  const SamplesTable table = table_of(distinct_record(), 0.0);
  const std::vector<std::string> expected = {
      "0.009", "1",  "2",  "3",   "0.5", "-0.5", "0.5", "-0.5", "4",  "5",  "6",  "7",
      "8",     "9",  "10", "11",  "12",  "13",   "14",  "0",    "16", "17", "18", "1",
      "0",     "0",  "0",  "20",  "21",  "22",   "23",  "24",   "25", "2",  "5",  "0.30000000000000004",
      "0.05",  "27", "28", "29.5"};
  EXPECT_THAT(table.rows.at(0), ElementsAreArray(expected));
}

TEST(SamplesFile, CountsTimeFromTheStartOfTheTrajectory) {
  EXPECT_EQ(table_of(distinct_record(), 10.0).at(0, "t"), 10.009);
  EXPECT_EQ(table_of(distinct_record(), -1.0).at(0, "t"), -0.991);
}

TEST(SamplesFile, SaysThatItCannotBeCreated) {
  const TemporaryFolder folder;
  const auto create = [&] { SamplesFile(folder.path() / "none" / "samples.csv", {}, 0.0); };
  EXPECT_THAT(create, testing::ThrowsMessage<InputError>(HasSubstr("none/samples.csv")));
}

TEST(SamplesFile, SaysThatTheDiskIsFull) {
  const auto write = [] {
    SamplesFile file("/dev/full", {}, 0.0);
    file.write({});
    file.close();
  };
  EXPECT_THAT(write, testing::ThrowsMessage<InputError>(HasSubstr("No space left")));
}

}  // namespace
}  // namespace tegotae
