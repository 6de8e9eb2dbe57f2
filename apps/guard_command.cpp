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

GuardEnd guard_until_the_end(const InterfaceDriver& driver, const std::string& options) {
  const HeartbeatMemory heart(kGuardHeartbeat);
  const GuardedProcess guarded{STDIN_FILENO, getppid(), &*heart, rescue_of(driver, options).time, kPatience};
  return guard_interface(driver, options, guarded);
}

void guard(const std::string& interface) {
  const InterfaceName name = parse_interface_name(interface);
  switch (guard_until_the_end(find_interface_driver(name.driver), name.options)) {
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
                             "dies or stands still; the program starts this itself.");
  command->group("");  // not listed
  command->add_option("INTERFACE", *interface)->required();
  command->callback([interface] { guard(*interface); });
}

}  // namespace tegotae
