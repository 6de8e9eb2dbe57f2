// SPDX-License-Identifier: Apache-2.0
// Drivers in processes of their own: libraries that are not there or not what they should be, and death in the middle.
#include <tegotae/device/interface_drivers.hpp>

#include <tests/device/driver_program.hpp>
#include <tests/device/waiting.hpp>
#include <tests/doubles/double_state_file.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <ostream>
#include <string>

namespace tegotae {
namespace {

using test::comes_true;
using test::DoubleStateFile;
using test::HoldingProbe;
using test::run_probe;
using ::testing::AllOf;
using ::testing::HasSubstr;

TEST(DriverProcess, WithoutTheLibrarySaysWhereItLookedAndWhatToInstall) {
  const auto force_dimension = run_probe("", "find force-dimension");
  EXPECT_THAT(force_dimension.text,
              AllOf(HasSubstr("library ''"), HasSubstr("looked for 'libdrd.so'\nlooked for 'libdrd.so.3'\n"),
                    HasSubstr("looked for 'libdhd.so'\nlooked for 'libdhd.so.3'\n"),
                    HasSubstr("the Force Dimension SDK was not found"), HasSubstr("forcedimension.com")));
  const auto opened = run_probe("", "open force-dimension");
  EXPECT_EQ(opened.exit_code, 1);
  EXPECT_THAT(opened.text, HasSubstr("the Force Dimension SDK was not found"));
  const auto virtuose = run_probe("", "open virtuose arm");
  EXPECT_EQ(virtuose.exit_code, 1);
  EXPECT_THAT(virtuose.text,
              AllOf(HasSubstr("the Virtuose API was not found (looked for virtuoseAPI.so)"), HasSubstr("version 4")));
}

TEST(DriverProcess, ALibraryWithoutAFunctionIsRefusedByItsName) {
  const DoubleStateFile device("sigma.7");
  const auto force_dimension = run_probe("force-dimension-incomplete", "open force-dimension");
  EXPECT_EQ(force_dimension.exit_code, 1);
  EXPECT_THAT(force_dimension.text, AllOf(HasSubstr("force-dimension-incomplete/libdrd.so has no function "
                                                    "'dhdSetForceAndTorqueAndGripperForce'"),
                                          HasSubstr("install a newer version of the Force Dimension SDK")));
  const auto virtuose = run_probe("virtuose-incomplete", "find virtuose");
  EXPECT_THAT(virtuose.text, HasSubstr("virtuoseAPI.so has no function 'virtAPIVersion'"));
  EXPECT_EQ(device->opens.load(), 0u);
}

TEST(DriverProcess, LibdhdAloneServesADeviceThatIsCalibrated) {
  const DoubleStateFile device("delta.3");
  const auto found = run_probe("force-dimension-dhd", "find force-dimension");
  EXPECT_THAT(found.text, AllOf(HasSubstr("looked for 'libdhd.so'"), HasSubstr("calibrated by hand: this is libdhd")));
  const auto opened = run_probe("force-dimension-dhd", "open force-dimension 0");
  EXPECT_EQ(opened.exit_code, 0);
  EXPECT_EQ(opened.text, "force-dimension:delta.3\n");
  EXPECT_EQ(device->closes.load(), 1u);
}

struct ProcessCase {
  const char* driver;
  const char* folder;
  const char* options;
};

void PrintTo(const ProcessCase& each, std::ostream* out) { *out << each.driver; }

class KilledDriver : public ::testing::TestWithParam<ProcessCase> {};

// What the guard relies on: the device of a process that was killed displays its last command, nobody can open it
// before, and `silence` brings it to zero.
TEST_P(KilledDriver, LeavesItsForceUntilSomebodySilencesIt) {
  const auto& [driver, folder, options] = GetParam();
  const DoubleStateFile device(*options == '\0' ? "sigma.7" : options);
  HoldingProbe probe(folder, driver, options);
  ASSERT_TRUE(comes_true([&] { return device.displayed().force.z() == 2.0 || !probe.is_running(); }));
  const InterfaceDriver& found = find_interface_driver(driver);
  EXPECT_FALSE(found.silence(options));
  EXPECT_EQ(device.displayed().force.z(), 2.0);
  probe.kill_it();
  EXPECT_EQ(device.displayed().force.z(), 2.0);
  EXPECT_TRUE(found.silence(options));
  EXPECT_EQ(device.displayed().force.norm(), 0.0);
  EXPECT_FALSE(device->forces_on.load());
  EXPECT_EQ(device->opener.load(), 0);
  device.unplug();
  EXPECT_FALSE(found.silence(options));
}

INSTANTIATE_TEST_SUITE_P(Drivers, KilledDriver,
                         ::testing::Values(ProcessCase{"force-dimension", "force-dimension", ""},
                                           ProcessCase{"virtuose", "virtuose", "arm"}),
                         [](const auto& each) {
                           std::string name = each.param.driver;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

}  // namespace
}  // namespace tegotae
