// SPDX-License-Identifier: Apache-2.0
#include <apps/commands.hpp>
#include <apps/interruption.hpp>

#include <CLI/CLI.hpp>

#include <cstdio>
#include <exception>
#include <string>
#include <vector>

namespace {

// A person's mistake in the command line is told from a run that failed.
enum ExitCode { kFine = 0, kFailed = 1, kUsage = 2 };

std::vector<const CLI::App*> commands_of(const CLI::App& program) {
  return program.get_subcommands([](const CLI::App*) { return true; });
}

// The command that the line names first; null: none that there is.
const CLI::App* command_of(const CLI::App& program, int argc, char** argv) {
  for (const CLI::App* command : commands_of(program)) {
    if (argc > 1 && command->get_name() == argv[1]) return command;
  }
  return nullptr;
}

void refuse_unknown_command(const CLI::App& program, int argc, char** argv) {
  if (argc < 2 || argv[1][0] == '-' || command_of(program, argc, argv) != nullptr) return;
  std::string names;
  for (const CLI::App* command : commands_of(program)) {
    if (command->get_group().empty()) continue;  // for the program itself
    names += (names.empty() ? "" : ", ") + command->get_name();
  }
  throw tegotae::UsageError("there is no command '" + std::string(argv[1]) + "'; there are: " + names +
                            "; see 'tegotae --help'.");
}

int usage_error(const CLI::App& program, const CLI::ParseError& error, const CLI::App* command) {
  if (error.get_exit_code() == 0) return program.exit(error);  // --help, --version: prints it
  const std::string name = command != nullptr ? command->get_name() + " " : "";
  std::fprintf(stderr, "tegotae: %s; see 'tegotae %s--help'.\n", error.what(), name.c_str());
  return kUsage;
}

int run(int argc, char** argv) {
  CLI::App program{"tegotae: 6-DoF haptic rendering of rigid bodies", "tegotae"};
  program.set_version_flag("--version", "tegotae " TEGOTAE_VERSION);
  program.require_subcommand(1);
  tegotae::add_experiment_command(program);
  tegotae::add_serve_command(program);
  tegotae::add_render_command(program);
  tegotae::add_methods_command(program);
  tegotae::add_split_command(program);
  tegotae::add_stability_command(program);
  tegotae::add_compare_command(program);
  tegotae::add_export_command(program);
  tegotae::add_replay_command(program);
  tegotae::add_interfaces_command(program);
  tegotae::add_guard_command(program);
  tegotae::add_doctor_command(program);
  try {
    refuse_unknown_command(program, argc, argv);
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return usage_error(program, error, command_of(program, argc, argv));
  } catch (const tegotae::UsageError& error) {
    std::fprintf(stderr, "tegotae: %s\n", error.what());
    return kUsage;
  } catch (const tegotae::Interruption& interruption) {
    std::fprintf(stderr, "tegotae: %s\n", interruption.what());
    return interruption.exit_code();
  }
  return kFine;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "tegotae: %s\n", error.what());
  } catch (...) {
    std::fputs("tegotae: an unknown error.\n", stderr);
  }
  return kFailed;
}
