// SPDX-License-Identifier: Apache-2.0
#include <apps/commands.hpp>
#include <tegotae/device/guard_process.hpp>
#include <tegotae/device/interface_drivers.hpp>

#include <fmt/format.h>
#include <unistd.h>

#include <memory>
#include <string>

namespace tegotae {
namespace {

constexpr double kPatience = 10.0;  // s that a device may be held after the death of who used it

void guard(const std::string& interface) {
  const InterfaceName name = parse_interface_name(interface);
  const InterfaceDriver& driver = find_interface_driver(name.driver);
  switch (guard_interface(driver, name.options, STDIN_FILENO, kPatience)) {
    case GuardEnd::kFarewell:
      return;
    case GuardEnd::kSilenced:
      fmt::print(stderr, "tegotae: the program died; {} is at zero.\n", interface);
      return;
    case GuardEnd::kFailed:
      throw InterfaceError(fmt::format(
          "the program died, and {} could not be brought to zero: switch it off before you touch it.", interface));
  }
}

}  // namespace

void add_guard_command(CLI::App& program) {
  auto interface = std::make_shared<std::string>();
  CLI::App* const command =
      program.add_subcommand("guard",
                             "Bring an interface to zero where the program at the other end of standard input "
                             "dies; the program starts this itself.");
  command->group("");  // not listed
  command->add_option("INTERFACE", *interface)->required();
  command->callback([interface] { guard(*interface); });
}

}  // namespace tegotae
