// SPDX-License-Identifier: Apache-2.0
#include <apps/commands.hpp>
#include <apps/validators.hpp>
#include <tegotae/lab/input_error.hpp>
#include <tegotae/lab/recording_file.hpp>
#include <tegotae/lab/text_file.hpp>

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <system_error>

namespace tegotae {
namespace {

struct ExportOptions {
  std::string recording, csv;
};

void run(const ExportOptions& options) {
  std::error_code error;
  if (std::filesystem::equivalent(options.csv, options.recording, error) && !error) {
    throw UsageError(fmt::format("--csv {} is the recording itself; name another file.", options.csv));
  }
  if (!is_recording(options.recording)) {
    throw InputError(fmt::format("{}: this is no recording that can be read; 'tegotae render --record' makes one.",
                                 options.recording));
  }
  check_writable_place(options.csv);
  std::ofstream csv(options.csv, std::ios::binary);
  const RecordingExport done = export_csv(options.recording, csv);
  csv.close();
  if (!csv) throw InputError(fmt::format("{}: the file cannot be written; free space or name another.", options.csv));
  if (!done.complete) {
    fmt::print(stderr, "tegotae: warning: {}: the recording was cut; all of it up to there is exported.\n",
               options.recording);
  }
  fmt::print("{} rows in {}\n", done.ticks, options.csv);
}

}  // namespace

void add_export_command(CLI::App& program) {
  auto options = std::make_shared<ExportOptions>();
  CLI::App* const command = program.add_subcommand("export", "Write the ticks of a recording as comma-separated rows.");
  command->add_option("FILE", options->recording, "Recording (MCAP)")
      ->type_name("")
      ->required()
      ->check(not_empty("a file"));
  command->add_option("--csv", options->csv, "File for the rows, one a haptic tick")
      ->type_name("FILE")
      ->required()
      ->check(not_empty("a file"));
  command->callback([options] { run(*options); });
}

}  // namespace tegotae
