// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>

#include <stdexcept>

namespace tegotae {

/// A command line that cannot be obeyed. `what()` is one sentence with the mend.
struct UsageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Each adds one command to the program: what it is called, its options, and what it does once the line is parsed.
// What it does throws UsageError, or another std::exception whose `what()` is one sentence.

void add_experiment_command(CLI::App& program);
void add_serve_command(CLI::App& program);
void add_render_command(CLI::App& program);
void add_methods_command(CLI::App& program);
void add_split_command(CLI::App& program);
void add_stability_command(CLI::App& program);
void add_compare_command(CLI::App& program);
void add_export_command(CLI::App& program);
void add_replay_command(CLI::App& program);
void add_interfaces_command(CLI::App& program);
void add_guard_command(CLI::App& program);
void add_doctor_command(CLI::App& program);

}  // namespace tegotae
