// SPDX-License-Identifier: Apache-2.0
#include <apps/commands.hpp>
#include <apps/interruption.hpp>
#include <apps/progress_line.hpp>
#include <apps/settings_options.hpp>
#include <apps/validators.hpp>
#include <tegotae/lab/run_recording.hpp>
#include <tegotae/lab/samples_file.hpp>
#include <tegotae/lab/session.hpp>
#include <tegotae/lab/text_file.hpp>
#include <tegotae/lab/tick_troubles.hpp>
#include <tegotae/lab/trajectory_file.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <utility>

namespace tegotae {
namespace {

struct RenderOptions {
  std::string scene, tool, trajectory, out, recording;
  SettingsOptions settings;
};

// What the rows came to.
struct RenderedRows {
  long count = 0;
  double deepest = 0.0;         // m
  double greatest_force = 0.0;  // N
  TickTroubles troubles;

  void add(const TickRecord& record) {
    ++count;
    deepest = std::max(deepest, record.deepest);
    greatest_force = std::max(greatest_force, record.wrench.force.vector().norm());
    troubles.add(record);
  }
};

bool is_same_file(const std::string& a, const std::string& b) {
  std::error_code error;
  return !a.empty() && (a == b || (std::filesystem::equivalent(a, b, error) && !error));
}

void refuse_to_overwrite(const std::string& option, const std::string& file, const std::string& other_option,
                         const std::string& other) {
  if (!is_same_file(file, other)) return;
  throw UsageError(
      fmt::format("{} {} is the file of {}, which it would replace; name another.", option, file, other_option));
}

void refuse_to_overwrite(const RenderOptions& options) {
  for (const auto& [option, file] : {std::pair("--out", options.out), std::pair("--record", options.recording)}) {
    refuse_to_overwrite(option, file, "--scene", options.scene);
    refuse_to_overwrite(option, file, "--trajectory", options.trajectory);
  }
  refuse_to_overwrite("--record", options.recording, "--out", options.out);
}

void warn(const std::string& warning) {
  if (!warning.empty()) fmt::print(stderr, "tegotae: warning: {}\n", warning);
}

RenderedRows render(Session& session, SamplesFile& samples, RunRecording* recording) {
  RenderedRows rows;
  ProgressLine progress("rendering");
  session.run_simulated(
      [&](const TickRecord& record) {
        samples.write(record);
        if (recording != nullptr) recording->write(record);
        rows.add(record);
        return !interrupted();
      },
      [&](double part) { progress.show(part); });
  samples.close();
  return rows;
}

void run(const RenderOptions& options) {
  const SettingsRequest wanted = options.settings.checked();
  refuse_to_overwrite(options);
  Trajectory motion = read_trajectory(options.trajectory);
  auto world = load_mujoco_world(options.scene, options.tool);
  for (const std::string& warning : scene_warnings(*world, options.scene)) warn(warning);
  const SessionSettings settings =
      decide_settings(wanted.or_else(settings_of(world->haptic_settings(), options.scene)), world->geometry().tool);
  Session session(std::move(world), std::move(motion), settings);

  check_writable_place(options.out);
  SamplesFile samples(options.out, session.notes(), session.start());
  std::optional<RunRecording> recording;
  if (!options.recording.empty()) {
    check_writable_place(options.recording);
    recording.emplace(options.recording, session, session.notes(),
                      std::filesystem::path(options.scene).filename().string(), "");
  }
  listen_for_interruption();
  const RenderedRows rows = render(session, samples, recording ? &*recording : nullptr);
  if (recording) {
    recording->close();
    warn(recording->error());
  }
  warn(session.trouble());
  warn(rows.troubles.sentence());
  fmt::print("{} rows in {}: greatest force {:.4g} N, deepest penetration {:.4g} mm\n", rows.count, options.out,
             rows.greatest_force, rows.deepest * 1e3);
  if (interrupted())
    throw Interruption(fmt::format("interrupted; the {} rows until then stand in {}.", rows.count, options.out));
}

}  // namespace

void add_render_command(CLI::App& program) {
  auto options = std::make_shared<RenderOptions>();
  CLI::App* const command = program.add_subcommand(
      "render", "Render a recorded motion of a tool on a scene, in simulated time; the result repeats bit for bit.");
  command->add_option("--scene", options->scene, "Scene: an MJCF or URDF file")->type_name("FILE")->required();
  command->add_option("--tool", options->tool, "Body of the scene that the hand moves")->type_name("BODY")->required();
  command
      ->add_option("--trajectory", options->trajectory,
                   "Motion of the tool body's frame: comma-separated columns t (s), x, y, z (m), qw, qx, qy, qz, or a "
                   "recording")
      ->type_name("FILE")
      ->required();
  command->add_option("--out", options->out, "File for the result, one row a haptic tick")
      ->type_name("FILE")
      ->check(not_empty("a file"))
      ->required();
  command->add_option("--record", options->recording, "Recording (MCAP) to write besides")
      ->type_name("FILE")
      ->check(not_empty("a file"));
  options->settings.add_all(*command);
  SettingsOptions::refuse_interface(*command, "'tegotae render' plays the motion exactly");
  command->callback([options] { run(*options); });
}

}  // namespace tegotae
