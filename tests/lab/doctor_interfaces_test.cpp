// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/doctor_interfaces.hpp>
#include <tegotae/lab/input_error.hpp>
#include <tests/lab/made_up_machine.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <stdexcept>
#include <string>
#include <vector>

namespace tegotae {
namespace {

using ::testing::HasSubstr;

void plug_in(const MadeUpMachine& machine, const std::string& place, const std::string& vendor,
             const std::string& product) {
  const std::string device = "sys/bus/usb/devices/" + place;
  machine.write(device + "/idVendor", vendor + "\n");
  machine.write(device + "/idProduct", product + "\n");
  machine.write(device + "/busnum", "3\n");
  machine.write(device + "/devnum", "12\n");
}

bool anyone(const std::filesystem::path&) { return true; }
bool nobody(const std::filesystem::path&) { return false; }

TEST(DoctorInterfaces, NothingPluggedIn) {
  const MadeUpMachine machine;
  plug_in(machine, "1-1", "8087", "0024");  // a hub
  const std::vector<Finding> findings = usb_findings(machine.roots(), anyone);
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(findings[0].verdict, Verdict::kCouldBeBetter);
  EXPECT_THAT(findings[0].found, HasSubstr("no known force-feedback interface"));
}

TEST(DoctorInterfaces, ADeviceThatMayBeUsedAndOneThatMayNot) {
  const MadeUpMachine machine;
  plug_in(machine, "3-2", "1451", "0402");
  const std::string node = (machine.roots().dev / "bus/usb/003/012").string();
  std::string asked;
  const std::vector<Finding> fine = usb_findings(machine.roots(), [&](const std::filesystem::path& path) {
    asked = path.string();
    return true;
  });
  ASSERT_EQ(fine.size(), 1U);
  EXPECT_EQ(asked, node);
  EXPECT_EQ(fine[0].verdict, Verdict::kOk);
  EXPECT_THAT(fine[0].found, HasSubstr("Force Dimension (1451:0402) may be used"));
  const std::vector<Finding> refused = usb_findings(machine.roots(), nobody);
  ASSERT_EQ(refused.size(), 1U);
  EXPECT_EQ(refused[0].verdict, Verdict::kNotPossible);
  EXPECT_THAT(refused[0].mend, testing::AllOf(HasSubstr("ATTR{idVendor}==\"1451\""),
                                              HasSubstr("/etc/udev/rules.d/70-tegotae-1451.rules")));
}

TEST(DoctorInterfaces, ATouchIsASerialPort) {
  const MadeUpMachine machine;
  plug_in(machine, "3-2", "2988", "0302");
  const std::vector<Finding> without_driver = usb_findings(machine.roots(), anyone);
  ASSERT_EQ(without_driver.size(), 1U);
  EXPECT_EQ(without_driver[0].verdict, Verdict::kNotPossible);
  EXPECT_THAT(without_driver[0].mend, HasSubstr("cdc_acm"));
  machine.write("sys/bus/usb/devices/3-2/3-2:1.0/tty/ttyACM1/dev", "166:1\n");
  const std::vector<Finding> refused = usb_findings(machine.roots(), nobody);
  EXPECT_THAT(refused[0].found, HasSubstr("/dev/ttyACM1, which you may not"));
  EXPECT_THAT(refused[0].mend, HasSubstr("dialout"));
  EXPECT_EQ(usb_findings(machine.roots(), anyone)[0].verdict, Verdict::kOk);
}

TEST(DoctorInterfaces, KnowsProductsWhereAMakerHasOthers) {
  const MadeUpMachine machine;
  plug_in(machine, "1-1", "0403", "6001");  // a serial adapter with the same maker's number as the Falcon
  plug_in(machine, "1-2", "0403", "cb48");
  plug_in(machine, "1-3", "046d", "c077");  // a mouse
  plug_in(machine, "1-4", "046d", "c626");  // a SpaceNavigator
  const std::vector<Finding> findings = usb_findings(machine.roots(), nobody);
  ASSERT_EQ(findings.size(), 2U);
  EXPECT_THAT(findings[0].found, HasSubstr("3Dconnexion"));
  EXPECT_EQ(findings[0].verdict, Verdict::kOk) << "the daemon's business";
  EXPECT_THAT(findings[1].found, HasSubstr("Falcon"));
}

TEST(DoctorInterfaces, ADeviceThatTellsNoNumberHasNoNode) {
  const MadeUpMachine machine;
  plug_in(machine, "1-2", "1451", "0402");
  machine.write("sys/bus/usb/devices/1-2/devnum", "\n");
  EXPECT_EQ(usb_findings(machine.roots(), anyone)[0].verdict, Verdict::kNotPossible);
}

TEST(DoctorInterfaces, ANodeThatIsNotThereMayNotBeUsed) {
  const TemporaryFolder folder;
  EXPECT_FALSE(may_use_node(folder.path() / "none"));
  EXPECT_TRUE(may_use_node(folder.write("node", "")));
}

InterfacePresence present() { return {"/opt/lib/libA.so", {"libA.so"}, {"omega.7: a:0"}, ""}; }
InterfacePresence absent() { return {"", {"libB.so", "libB.so.3"}, {}, "install B."}; }

InterfacePresence present_with(std::string_view options) {
  if (options != "7") throw InterfaceError("c: only 7 is there.");
  return present();
}

constexpr InterfaceDriver kPresent{"a", "", "", "", present, nullptr, nullptr};
constexpr InterfaceDriver kAbsent{"b", "", "", "", absent, nullptr, nullptr};
constexpr std::array<const InterfaceDriver*, 2> kDrivers = {&kPresent, &kAbsent};

TEST(DoctorInterfaces, DriversAndWhereTheyLooked) {
  const std::vector<Finding> findings = driver_findings(kDrivers, "");
  ASSERT_EQ(findings.size(), 2U);
  EXPECT_EQ(findings[0].verdict, Verdict::kOk);
  EXPECT_EQ(findings[0].found, "library /opt/lib/libA.so; omega.7: a:0.");
  EXPECT_EQ(findings[1].verdict, Verdict::kCouldBeBetter);
  EXPECT_EQ(findings[1].found, "no library (looked for libB.so, libB.so.3); no device seen.");
  EXPECT_EQ(findings[1].mend, "install B.");
}

TEST(DoctorInterfaces, TheOneThatIsWantedMustBeThere) {
  EXPECT_EQ(driver_findings(kDrivers, "a")[1].verdict, Verdict::kCouldBeBetter);
  EXPECT_EQ(driver_findings(kDrivers, "b")[1].verdict, Verdict::kNotPossible);
  EXPECT_THAT([] { driver_findings(kDrivers, "c"); },
              testing::ThrowsMessage<InputError>("there is no interface 'c'; there are: a, b."));
}

const Finding& finding_about(const std::vector<Finding>& findings, const std::string& subject) {
  for (const Finding& finding : findings) {
    if (finding.subject == subject) return finding;
  }
  throw std::runtime_error("no finding about " + subject);
}

TEST(DoctorInterfaces, ThePageNeedsNoDevice) {
  const std::vector<Finding> findings = interface_findings({"page", ""});
  EXPECT_EQ(findings.front().subject, "page");
  EXPECT_EQ(findings.front().verdict, Verdict::kOk);
  EXPECT_EQ(finding_about(findings, "spidar-g6").verdict, Verdict::kCouldBeBetter) << "not asked for";
  EXPECT_EQ(finding_about(interface_findings({"spidar-g6", "x3r"}), "spidar-g6").verdict, Verdict::kNotPossible);
}

TEST(DoctorInterfaces, PlaybackNeedsAFileThatPlays) {
  const TemporaryFolder folder;
  const std::string motion = folder.write("motion.csv", "t,x,y,z,qw,qx,qy,qz\n1,0,0,0,1,0,0,0\n3.5,0,0,0.1,1,0,0,0\n");
  const Finding fine = finding_about(interface_findings({"playback", motion}), "playback");
  EXPECT_EQ(fine.verdict, Verdict::kOk);
  EXPECT_THAT(fine.found, HasSubstr("motion.csv can be played, 2.5 s"));
  const std::string bad = folder.write("bad.csv", "t,x\n1,0\n");
  const Finding refused = finding_about(interface_findings({"playback", bad}), "playback");
  EXPECT_EQ(refused.verdict, Verdict::kNotPossible);
  EXPECT_THAT(refused.found, HasSubstr("bad.csv"));
  EXPECT_THAT(refused.mend, HasSubstr("playback:FILE"));
  EXPECT_THAT(
      [] {
        interface_findings({"playback", ""});
      },
      testing::ThrowsMessage<InputError>(HasSubstr("playback needs a file")));
  EXPECT_THAT(
      [] {
        interface_findings({"falcon", ""});
      },
      testing::ThrowsMessage<InputError>(
          testing::AllOf(HasSubstr("there are: page, force-dimension"), HasSubstr("playback"))));
}

TEST(DoctorInterfaces, OptionsAreAskedForWhereTheyMatter) {
  InterfaceDriver asking = {"c", "", "", "", absent, nullptr, nullptr};
  asking.find_with = present_with;
  const std::array<const InterfaceDriver*, 2> drivers = {&asking, &kAbsent};
  EXPECT_EQ(driver_findings(drivers, "c", "7")[0].verdict, Verdict::kOk);
  const Finding refused = driver_findings(drivers, "c", "8")[0];
  EXPECT_EQ(refused.verdict, Verdict::kNotPossible);
  EXPECT_EQ(refused.mend, "c: only 7 is there.");
  EXPECT_EQ(driver_findings(drivers, "c")[0].mend, "install B.");
  EXPECT_EQ(driver_findings(drivers, "b", "7")[0].verdict, Verdict::kCouldBeBetter) << "not its options";
}

}  // namespace
}  // namespace tegotae
