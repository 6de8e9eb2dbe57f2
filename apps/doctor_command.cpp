// SPDX-License-Identifier: Apache-2.0
#include <apps/commands.hpp>
#include <apps/progress_line.hpp>
#include <apps/validators.hpp>
#include <tegotae/lab/doctor_interfaces.hpp>
#include <tegotae/lab/doctor_measure.hpp>
#include <tegotae/lab/doctor_system.hpp>
#include <tegotae/lab/input_error.hpp>

#include <fmt/format.h>

#include <cstdio>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace tegotae {
namespace {

struct DoctorOptions {
  std::string interface;
  double seconds = 5.0;
  double rate = 1000.0;
  bool json = false;
};

void append(std::vector<Finding>& findings, std::vector<Finding> more) {
  for (Finding& finding : more) findings.push_back(std::move(finding));
}

std::vector<Finding> machine_findings(const DoctorOptions& options) {
  const double period = 1.0 / options.rate;
  ProgressLine wake_ups_line("wake-ups");
  const WakeUps wake_ups = measure_wake_ups(period, options.seconds, [&](double part) { wake_ups_line.show(part); });
  ProgressLine ticks_line("ticks");
  const DurationHistogram ticks = measure_ticks([&](double part) { ticks_line.show(part); });
  const SystemRoots roots;
  return {kernel_finding(roots),
          scheduling_finding(roots, wake_ups.rights.fifo),
          memory_finding(roots, wake_ups.rights.memory_locked),
          governor_finding(roots),
          wake_up_finding(wake_ups, period),
          tick_finding(ticks, period)};
}

void print(const std::vector<Finding>& findings) {
  for (const Finding& finding : findings) {
    fmt::print("{:<16} {:<16} {}\n", name_of(finding.verdict), finding.subject, finding.found);
    if (!finding.mend.empty()) fmt::print("{:<33} mend: {}\n", "", finding.mend);
  }
}

void print(const std::vector<Finding>& machine, const std::vector<Finding>& interfaces) {
  fmt::print("This machine\n");
  print(machine);
  fmt::print("\nInterfaces (only the one that you have is needed)\n");
  print(interfaces);
}

std::vector<Finding> found_interfaces(const DoctorOptions& options) {
  try {
    return interface_findings(parse_interface_name(options.interface));
  } catch (const InputError& error) {
    throw UsageError(error.what());
  }
}

void examine(const DoctorOptions& options) {
  std::vector<Finding> interfaces = found_interfaces(options);  // first, as the name may be none
  append(interfaces, usb_findings({}));
  std::vector<Finding> machine = machine_findings(options);
  if (!options.json) print(machine, interfaces);
  append(machine, std::move(interfaces));
  if (options.json) fmt::print("{}", findings_json(machine));
  std::fflush(stdout);
  if (!is_possible(machine)) {
    throw std::runtime_error("force feedback cannot be done on this machine as it is: mend what is not possible.");
  }
  if (!options.json) fmt::print("\nForce feedback at {:g} Hz can be done on this machine.\n", options.rate);
}

}  // namespace

void add_doctor_command(CLI::App& program) {
  auto options = std::make_shared<DoctorOptions>();
  CLI::App* const command = program.add_subcommand(
      "doctor", "Say whether this machine can do force feedback, and how to mend what is in the way.");
  command->add_option("--interface", options->interface, "Interface that must be there, as 'serve' takes it")
      ->type_name("NAME[:OPTIONS]")
      ->check(not_empty("an interface"));
  command->add_option("--rate", options->rate, "Haptic rate to be judged by, Hz")
      ->check(CLI::Range(10.0, 20000.0))
      ->type_name("HZ")
      ->capture_default_str();
  command->add_option("--seconds", options->seconds, "How long the wake-ups are measured, s")
      ->check(CLI::Range(0.1, 3600.0))
      ->type_name("S")
      ->capture_default_str();
  command->add_flag("--json", options->json, "Print the findings as JSON");
  command->callback([options] { examine(*options); });
}

}  // namespace tegotae
