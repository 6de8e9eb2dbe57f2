// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/doctor_interfaces.hpp>

#include <tegotae/lab/input_error.hpp>
#include <tegotae/lab/playback_driver.hpp>
#include <tegotae/lab/trajectory_file.hpp>

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

namespace tegotae {
namespace {

enum class NodeKind : std::uint8_t { kUsb, kSerial, kDaemon };

// Makers' numbers on the USB. Empty product: any.
struct KnownDevice {
  std::string_view vendor, product, name;
  NodeKind node;
};
constexpr KnownDevice kKnown[] = {
    {"1451", "", "Force Dimension", NodeKind::kUsb},
    {"0403", "cb48", "Novint Falcon", NodeKind::kUsb},
    {"0cec", "", "SPIDAR", NodeKind::kUsb},
    {"2988", "", "3D Systems Touch", NodeKind::kSerial},
    {"0301", "2988", "3D Systems Touch", NodeKind::kSerial},
    {"256f", "", "3Dconnexion", NodeKind::kDaemon},
    {"046d", "c6", "3Dconnexion (Logitech)", NodeKind::kDaemon},  // its products begin so
};

std::string word_in(const std::filesystem::path& file) {
  std::ifstream stream(file);
  std::string word;
  stream >> word;
  return word;
}

const KnownDevice* known_device(const std::string& vendor, const std::string& product) {
  for (const KnownDevice& device : kKnown) {
    if (vendor == device.vendor && product.compare(0, device.product.size(), device.product) == 0) return &device;
  }
  return nullptr;
}

std::optional<std::filesystem::path> usb_node(const SystemRoots& roots, const std::filesystem::path& device) {
  const std::string bus = word_in(device / "busnum"), number = word_in(device / "devnum");
  int b = 0, n = 0;
  if (std::from_chars(bus.data(), bus.data() + bus.size(), b).ec != std::errc() ||
      std::from_chars(number.data(), number.data() + number.size(), n).ec != std::errc()) {
    return std::nullopt;
  }
  return roots.dev / "bus/usb" / fmt::format("{:03}", b) / fmt::format("{:03}", n);
}

// The first of the device's interfaces that is a serial port.
std::optional<std::filesystem::path> serial_node(const SystemRoots& roots, const std::filesystem::path& device) {
  std::error_code error;
  for (const auto& interface : std::filesystem::directory_iterator(device, error)) {
    for (const auto& port : std::filesystem::directory_iterator(interface.path() / "tty", error)) {
      return roots.dev / port.path().filename();
    }
  }
  return std::nullopt;
}

std::string mend_rights(const KnownDevice& device, const std::string& vendor) {
  if (device.node == NodeKind::kSerial) return "sudo usermod -aG dialout $USER; then log in again";
  return fmt::format(
      "echo 'SUBSYSTEM==\"usb\", ATTR{{idVendor}}==\"{}\", MODE=\"0660\", TAG+=\"uaccess\"' | sudo tee "
      "/etc/udev/rules.d/70-tegotae-{}.rules; sudo udevadm control --reload; unplug it and plug it in again",
      vendor, vendor);
}

Finding usb_finding(const SystemRoots& roots, const std::filesystem::path& device, const KnownDevice& known,
                    const std::string& vendor, const NodeAccess& may_use) {
  const std::string who = fmt::format("{} ({}:{})", known.name, vendor, word_in(device / "idProduct"));
  if (known.node == NodeKind::kDaemon) return {Verdict::kOk, "usb", who + " is plugged in; spacenavd reads it.", ""};
  const auto node = known.node == NodeKind::kUsb ? usb_node(roots, device) : serial_node(roots, device);
  if (!node) {
    return {Verdict::kNotPossible, "usb", who + " is plugged in, but the system made no node for it.",
            known.node == NodeKind::kSerial ? "sudo modprobe cdc_acm; unplug it and plug it in again"
                                            : "unplug it and plug it in again; look at 'sudo dmesg'"};
  }
  if (may_use(*node)) return {Verdict::kOk, "usb", fmt::format("{} may be used at {}.", who, node->string()), ""};
  return {Verdict::kNotPossible, "usb",
          fmt::format("{} is at {}, which you may not read and write.", who, node->string()),
          mend_rights(known, vendor)};
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

std::string described(const InterfacePresence& presence) {
  std::string text;
  if (!presence.library.empty()) {
    text = fmt::format("library {}", presence.library);
  } else if (!presence.looked_for.empty()) {
    text = fmt::format("no library (looked for {})", joined(presence.looked_for));
  }
  if (!presence.devices.empty())
    return fmt::format("{}{}{}.", text, text.empty() ? "" : "; ", joined(presence.devices));
  return text.empty() ? "no device seen." : text + "; no device seen.";
}

Finding driver_finding(const InterfaceDriver& driver, bool wanted, std::string_view options) {
  const InterfacePresence presence = find_interface(driver, wanted ? options : std::string_view());
  const bool fine = presence.trouble.empty();
  const Verdict missing = wanted ? Verdict::kNotPossible : Verdict::kCouldBeBetter;
  return {fine ? Verdict::kOk : missing, std::string(driver.name), described(presence), presence.trouble};
}

Finding page_finding() {
  return {Verdict::kOk, "page", "simulated, guided from the page of 'tegotae serve'; it needs no device.", ""};
}

Finding playback_finding(const std::string& file) {
  constexpr const char* kWhatPlays = "a recording (MCAP) or a trajectory (CSV)";
  if (file.empty()) {
    throw InputError(fmt::format("playback needs a file, {}; name it: --interface playback:FILE.", kWhatPlays));
  }
  try {
    const Trajectory motion = read_trajectory(file);
    return {Verdict::kOk, "playback",
            fmt::format("{} can be played, {:.1f} s; it feels nothing.", file, motion.end() - motion.start()), ""};
  } catch (const std::runtime_error& error) {
    return {Verdict::kNotPossible, "playback", error.what(), fmt::format("name {}: playback:FILE", kWhatPlays)};
  }
}

void check_there_is(const std::string& wanted) {
  std::string names = "page";
  for (const InterfaceDriver* driver : known_drivers()) {
    if (driver->name == wanted) return;
    names.append(", ").append(driver->name);
  }
  throw InputError(fmt::format("there is no interface '{}'; there are: {}.", wanted, names));
}

}  // namespace

bool may_use_node(const std::filesystem::path& node) { return access(node.c_str(), R_OK | W_OK) == 0; }

std::vector<Finding> usb_findings(const SystemRoots& roots, const NodeAccess& may_use) {
  std::vector<Finding> findings;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(roots.sys / "bus/usb/devices", error)) {
    const std::string vendor = word_in(entry.path() / "idVendor");
    const KnownDevice* known = known_device(vendor, word_in(entry.path() / "idProduct"));
    if (known != nullptr) findings.push_back(usb_finding(roots, entry.path(), *known, vendor, may_use));
  }
  if (findings.empty()) {
    findings.push_back({Verdict::kCouldBeBetter, "usb", "no known force-feedback interface is plugged in.",
                        "plug it in and switch it on; devices on the network (Virtuose) or FireWire do not show here"});
  }
  std::sort(findings.begin(), findings.end(), [](const Finding& a, const Finding& b) { return a.found < b.found; });
  return findings;
}

std::vector<Finding> driver_findings(std::span<const InterfaceDriver* const> drivers, std::string_view wanted,
                                     std::string_view options) {
  std::vector<Finding> findings;
  bool found = wanted.empty();
  std::string names;
  for (const InterfaceDriver* driver : drivers) {
    findings.push_back(driver_finding(*driver, driver->name == wanted, options));
    found = found || driver->name == wanted;
    names.append(names.empty() ? "" : ", ").append(driver->name);
  }
  if (!found) throw InputError(fmt::format("there is no interface '{}'; there are: {}.", wanted, names));
  return findings;
}

std::vector<Finding> interface_findings(const InterfaceName& wanted) {
  std::vector<Finding> without_device;
  if (wanted.driver == "page") {
    without_device.push_back(page_finding());
  } else if (wanted.driver == playback_driver().name) {
    without_device.push_back(playback_finding(wanted.options));
  } else if (!wanted.driver.empty()) {
    check_there_is(wanted.driver);
  }
  std::vector<Finding> findings =
      driver_findings(interface_drivers(), without_device.empty() ? wanted.driver : std::string(), wanted.options);
  findings.insert(findings.begin(), without_device.begin(), without_device.end());
  return findings;
}

}  // namespace tegotae
