// SPDX-License-Identifier: Apache-2.0
#include <apps/commands.hpp>
#include <tegotae/device/interface_drivers.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <memory>
#include <string>

namespace tegotae {
namespace {

std::string line_of(const InterfaceDriver& driver) {
  const std::string options = driver.options.empty() ? "" : fmt::format("[:{}]", driver.options);
  return fmt::format("{}{}", driver.name, options);
}

void print_driver(const InterfaceDriver& driver) {
  fmt::print("{}\n    {}\n", line_of(driver), driver.summary);
  const InterfacePresence found = driver.find();
  if (!found.library.empty()) fmt::print("    library: {}\n", found.library);
  if (found.library.empty() && !found.looked_for.empty()) {
    fmt::print("    library: not found; looked for {}\n", fmt::join(found.looked_for, ", "));
  }
  for (const std::string& device : found.devices) fmt::print("    present: {}\n", device);
  if (!found.trouble.empty()) fmt::print("    {}\n", found.trouble);
  fmt::print("    after a crash: {}\n", driver.after_a_crash);
}

void list(const std::string& name) {
  if (!name.empty()) return print_driver(find_interface_driver(name));
  fmt::print("page\n    simulated, guided from the page of 'tegotae serve'; the default\n");
  for (const InterfaceDriver* driver : interface_drivers()) print_driver(*driver);
}

}  // namespace

void add_interfaces_command(CLI::App& program) {
  auto name = std::make_shared<std::string>();
  CLI::App* const command = program.add_subcommand(
      "interfaces", "List the interfaces that there are drivers for, and what of them is present.");
  command->add_option("DRIVER", *name, "Only this one");
  command->callback([name] {
    try {
      list(*name);
    } catch (const InterfaceError& error) {
      throw UsageError(error.what());
    }
  });
}

}  // namespace tegotae
