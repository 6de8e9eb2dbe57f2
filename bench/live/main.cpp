// SPDX-License-Identifier: Apache-2.0
#include <bench/live/measured_session.hpp>
#include <bench/live/session_report.hpp>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <cstdio>
#include <exception>
#include <fstream>
#include <stdexcept>
#include <string>

namespace tegotae::bench {
namespace {

int run(int argc, char** argv) {
  CLI::App program(
      "Measures what viewers cost the haptic tick of 'tegotae serve', and how old what they get is. The program runs "
      "in a process of its own and plays a motion in a loop, in blocks without and with viewers by turns; this process "
      "is the viewers. The ticks come from the program's own recording.");
  SessionPlan plan;
  std::string json;
  program.add_option("--program", plan.program, "Program to measure")->capture_default_str();
  program.add_option("--recording", plan.recording, "Recording that it is to write; removed at the end")
      ->capture_default_str();
  program.add_option("--viewers", plan.viewers, "Viewers in every other block")
      ->check(CLI::Range(1, 32))
      ->capture_default_str();
  program.add_option("--blocks", plan.blocks, "Number of blocks, the first without viewers")
      ->check(CLI::Range(2, 1000))
      ->capture_default_str();
  program.add_option("--motions", plan.motions, "Motions a block")->check(CLI::Range(1, 1000))->capture_default_str();
  program.add_option("--motion", plan.motion, "Scripted motion to play")->capture_default_str();
  program.add_option("--json", json, "File for the figures");
  CLI11_PARSE(program, argc, argv);
  const SessionFigures figures = measure(plan);
  fmt::print("{}", text_of(figures));
  if (!json.empty() && !(std::ofstream(json) << json_of(figures) << '\n')) {
    throw std::runtime_error(json + " cannot be written");
  }
  return 0;
}

}  // namespace
}  // namespace tegotae::bench

int main(int argc, char** argv) {
  try {
    return tegotae::bench::run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bench_live: %s\n", error.what());
    return 1;
  }
}
