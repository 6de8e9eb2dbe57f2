// SPDX-License-Identifier: Apache-2.0
#include <apps/commands.hpp>
#include <apps/validators.hpp>
#include <tegotae/device/interface_drivers.hpp>
#include <tegotae/device/simulated_presets.hpp>
#include <tegotae/device/spidar_presets.hpp>
#include <tegotae/lab/input_error.hpp>
#include <tegotae/lab/interface_choice.hpp>
#include <tegotae/lab/playback_driver.hpp>
#include <tegotae/lab/spidar_workspace.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <filesystem>
#include <memory>
#include <numbers>
#include <string>
#include <string_view>

namespace tegotae {
namespace {

constexpr std::string_view kSpidar = "spidar-g6";

std::string line_of(const InterfaceDriver& driver) {
  const std::string options = driver.options.empty() ? "" : fmt::format("[:{}]", driver.options);
  return fmt::format("{}{}", driver.name, options);
}

void print_page() { fmt::print("page\n    simulated, guided from the page of 'tegotae serve'; the default\n"); }

void print_simulated() {
  fmt::print("simulated:NAME\n    for 'tegotae experiment', which holds it in a simulated hand\n");
  for (const auto& preset : simulated_devices()) fmt::print("    {}: {}\n", preset.name, preset.source);
}

void print_spidar_presets() {
  for (const SpidarPreset& preset : spidar_presets()) fmt::print("    {}: {}\n", preset.name, preset.remark);
}

void print_driver(const InterfaceDriver& driver, const std::string& options = {}) {
  fmt::print("{}\n    {}\n", line_of(driver), driver.summary);
  const InterfacePresence found = find_interface(driver, options);
  if (!found.library.empty()) fmt::print("    library: {}\n", found.library);
  if (found.library.empty() && !found.looked_for.empty()) {
    fmt::print("    library: not found; looked for {}\n", fmt::join(found.looked_for, ", "));
  }
  for (const std::string& device : found.devices) fmt::print("    present: {}\n", device);
  if (!found.trouble.empty()) fmt::print("    {}\n", found.trouble);
  const bool is_known = !options.empty() && found.trouble.empty();
  fmt::print("    after a crash: {}\n",
             is_known ? rescue_of(driver, options).after_a_crash : std::string(driver.after_a_crash));
  if (driver.name == kSpidar) print_spidar_presets();
}

void list(const InterfaceName& name) {
  if (name.driver == "page") return print_page();
  if (name.driver == "simulated") return print_simulated();
  if (!name.driver.empty()) return print_driver(find_interface_driver(name.driver, known_drivers()), name.options);
  print_page();
  print_simulated();
  for (const InterfaceDriver* driver : known_drivers()) print_driver(*driver);
}

struct InterfacesOptions {
  std::string name, folder;
  bool workspace = false;
};

SpidarGeometry chosen_spidar(const InterfaceName& name) {
  if (name.driver != kSpidar) {
    throw UsageError(fmt::format(
        "--workspace draws what the strings of a SPIDAR reach: give spidar-g6, spidar-g6:PRESET or spidar-g6:FILE{}.",
        name.driver.empty() ? "" : fmt::format(", not '{}'", name.driver)));
  }
  const std::string_view options = std::string_view(name.options).substr(0, name.options.find(','));
  return spidar_geometry_of(options.empty() ? "x3r" : options);
}

void print_workspace(const InterfacesOptions& options) {
  const SpidarGeometry geometry = chosen_spidar(parse_interface_name(options.name));
  std::filesystem::path folder = options.folder;
  if (folder.empty()) folder = std::filesystem::path("out") / "workspace" / geometry.name;
  const SpidarWorkspace workspace = spidar_workspace(geometry);
  draw_spidar_workspace(geometry, folder);
  fmt::print("spidar-g6:{}: in the middle of the frame {:.1f} N and {:.3f} N m in every direction\n", geometry.name,
             workspace.at_centre.force, workspace.at_centre.torque);
  constexpr std::array<const char*, 3> kNames = {"x, to the right", "y, away", "z, up"};
  for (size_t i = 0; i < kNames.size(); ++i) {
    const auto &way = workspace.way[i], &angle = workspace.angle[i];
    fmt::print("  {:<16} held from {:.1f} to {:.1f} mm, and turned about it from {:.1f} to {:.1f} degrees\n", kNames[i],
               -1e3 * way.backward, 1e3 * way.forward, -angle.backward * 180.0 / std::numbers::pi,
               angle.forward * 180.0 / std::numbers::pi);
  }
  fmt::print("figures: {}\n", folder.string());
}

void run(const InterfacesOptions& options) {
  if (!options.workspace && !options.folder.empty()) {
    throw UsageError("--out is for what --workspace draws; add --workspace, or leave it out.");
  }
  try {
    if (options.workspace) {
      print_workspace(options);
    } else {
      list(parse_interface_name(options.name));
    }
  } catch (const InterfaceError& error) {
    throw UsageError(error.what());
  }
}

}  // namespace

void add_interfaces_command(CLI::App& program) {
  auto options = std::make_shared<InterfacesOptions>();
  CLI::App* const command = program.add_subcommand(
      "interfaces", "List the interfaces that there are drivers for, and what of them is present.");
  command->add_option("DRIVER", options->name, "Only this one; also with options, as 'serve' takes it: DRIVER:OPTIONS")
      ->type_name("");
  command->add_flag("--workspace", options->workspace,
                    "Of spidar-g6, spidar-g6:PRESET or spidar-g6:FILE (default: x3r): draw what its strings reach");
  command->add_option("--out", options->folder, "Folder for what --workspace draws; default: out/workspace/NAME")
      ->type_name("DIR")
      ->check(not_empty("a folder"));
  command->callback([options] { run(*options); });
}

}  // namespace tegotae
