// SPDX-License-Identifier: Apache-2.0
#include <tegotae/device/interface_drivers.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

namespace tegotae {
namespace {

using ::testing::AllOf;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

TEST(InterfaceDrivers, AreCompleteAndHaveNamesOfTheirOwn) {
  std::set<std::string_view> names;
  for (const InterfaceDriver* driver : interface_drivers()) {
    EXPECT_TRUE(names.insert(driver->name).second) << driver->name;
    EXPECT_EQ(driver->name.find(':'), std::string_view::npos);
    EXPECT_FALSE(driver->summary.empty()) << driver->name;
    EXPECT_TRUE(driver->after_a_crash.ends_with('.')) << driver->name;
    ASSERT_NE(driver->find, nullptr) << driver->name;
    ASSERT_NE(driver->open, nullptr) << driver->name;
    EXPECT_EQ(&find_interface_driver(driver->name), driver);
  }
  EXPECT_TRUE(names.contains("spidar-g6"));
}

// Neither maker's library nor device is there where tests run: each says what is missing, and opening says the same.
TEST(InterfaceDrivers, WithoutADeviceSayWhatIsMissing) {
  for (const InterfaceDriver* driver : interface_drivers()) {
    const InterfacePresence found = driver->find();
    if (!found.devices.empty()) continue;
    EXPECT_THAT(found.trouble, EndsWith(".")) << driver->name;
    EXPECT_THAT([&] { static_cast<void>(driver->open("")); },
                ThrowsMessage<InterfaceError>(AllOf(HasSubstr(std::string(driver->name)), EndsWith("."))));
  }
}

TEST(InterfaceDrivers, ANameThatIsNoneIsAnsweredWithThoseThatAre) {
  EXPECT_THAT([] { static_cast<void>(find_interface_driver("falcon")); },
              ThrowsMessage<InterfaceError>(AllOf(HasSubstr("'falcon'"), HasSubstr("spidar-g6"))));
}

TEST(InterfaceDrivers, ASimulatedSpidarIsForExperiments) {
  EXPECT_THAT([] { static_cast<void>(find_interface_driver("spidar-g6").open("x3r,simulated")); },
              ThrowsMessage<InterfaceError>(HasSubstr("experiment NAME --interface spidar-g6:x3r,simulated.")));
}

TEST(InterfaceDrivers, OptionsFollowTheFirstColon) {
  EXPECT_EQ(parse_interface_name("force-dimension").driver, "force-dimension");
  EXPECT_EQ(parse_interface_name("force-dimension").options, "");
  const InterfaceName name = parse_interface_name("virtuose:10.0.0.1:5000");
  EXPECT_EQ(name.driver, "virtuose");
  EXPECT_EQ(name.options, "10.0.0.1:5000");
}

}  // namespace
}  // namespace tegotae
