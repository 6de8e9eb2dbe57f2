// SPDX-License-Identifier: Apache-2.0
#include <apps/commands.hpp>

#include <CLI/CLI.hpp>

#include <cstdio>
#include <exception>

namespace {

// A person's mistake in the command line is told from a run that failed.
enum ExitCode { kFine = 0, kFailed = 1, kUsage = 2 };

int usage_error(const CLI::App& program, const CLI::ParseError& error) {
  if (error.get_exit_code() == 0) return program.exit(error);  // --help, --version: prints it
  std::fprintf(stderr, "tegotae: %s; see 'tegotae --help'.\n", error.what());
  return kUsage;
}

int run(int argc, char** argv) {
  CLI::App program{"tegotae: 6-DoF haptic rendering of rigid bodies", "tegotae"};
  program.set_version_flag("--version", "tegotae " TEGOTAE_VERSION);
  program.require_subcommand(1);
  tegotae::add_experiment_command(program);
  tegotae::add_render_command(program);
  tegotae::add_methods_command(program);
  tegotae::add_stability_command(program);
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return usage_error(program, error);
  } catch (const tegotae::UsageError& error) {
    std::fprintf(stderr, "tegotae: %s\n", error.what());
    return kUsage;
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
