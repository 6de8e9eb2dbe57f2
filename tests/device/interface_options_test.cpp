// SPDX-License-Identifier: Apache-2.0
#include <tegotae/device/interface_driver.hpp>
#include <tegotae/device/interface_options.hpp>

#include <tests/device/refusal.hpp>

#include <gtest/gtest.h>

namespace tegotae {
namespace {

using test::refusal;

TEST(InterfaceOptions, OneValueWithoutAndSomeWithAName) {
  InterfaceOptions options("some-arm", "host#7,axes=y-xz,mass=0.25");
  EXPECT_EQ(options.value(), "host#7");
  EXPECT_EQ(options.text("axes"), "y-xz");
  EXPECT_EQ(options.number("mass", 0.0, 1.0), 0.25);
  EXPECT_EQ(options.text("mode", "on|off"), std::nullopt);
  EXPECT_EQ(options.number("period", 0.0, 1.0), std::nullopt);
  EXPECT_NO_THROW(options.refuse_others());
}

TEST(InterfaceOptions, EverythingMayBeMissing) {
  EXPECT_EQ(InterfaceOptions("some-arm", "").value(), "");
  EXPECT_EQ(InterfaceOptions("some-arm", "mode=on").value(), "");
  EXPECT_EQ(InterfaceOptions("some-arm", "mode=on").text("mode", "on|off"), "on");
}

TEST(InterfaceOptions, RefusesWithASentence) {
  EXPECT_EQ(refusal([] { InterfaceOptions("some-arm", "1,2"); }), "some-arm: '2' has no name; write NAME=VALUE.");
  EXPECT_EQ(refusal([] { InterfaceOptions("some-arm", "a=1,a=2"); }), "some-arm: 'a' is given twice.");
  EXPECT_EQ(refusal([] { InterfaceOptions("some-arm", "mode=o").text("mode", "on|off"); }),
            "some-arm: mode=o is none of on|off.");
  for (const char* mass : {"mass=", "mass=x", "mass=0.2kg", "mass=2", "mass=-1", "mass=nan"}) {
    EXPECT_EQ(refusal([&] { InterfaceOptions("some-arm", mass).number("mass", 0.0, 1.5); }),
              "some-arm: " + std::string(mass) + " is no number from 0 to 1.5.");
  }
  EXPECT_EQ(refusal([] {
              InterfaceOptions options("some-arm", "mas=1");
              options.number("mass", 0.0, 1.0);
              options.text("mode");
              options.refuse_others();
            }),
            "some-arm: there is no option 'mas'; there are: mass, mode.");
}

}  // namespace
}  // namespace tegotae
