// SPDX-License-Identifier: Apache-2.0
#include <apps/commands.hpp>
#include <apps/progress_line.hpp>
#include <apps/settings_options.hpp>
#include <tegotae/lab/samples_file.hpp>
#include <tegotae/lab/session.hpp>
#include <tegotae/lab/trajectory_file.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <string>
#include <utility>

namespace tegotae {
namespace {

struct RenderOptions {
  std::string scene, tool, trajectory, out;
  SettingsOptions settings;
};

void print_result(const RenderOptions& options, long rows, double deepest, double greatest_force) {
  fmt::print("{} rows in {}: greatest force {:.4g} N, deepest penetration {:.4g} mm\n", rows, options.out,
             greatest_force, deepest * 1e3);
}

void run(const RenderOptions& options) {
  const SettingsRequest wanted = options.settings.checked();
  Trajectory motion = read_trajectory(options.trajectory);
  auto world = load_mujoco_world(options.scene, options.tool);
  for (const std::string& warning : world->warnings()) fmt::print(stderr, "tegotae: warning: {}\n", warning);
  const SessionSettings settings =
      decide_settings(wanted.or_else(settings_of(world->haptic_settings())), world->geometry().tool);
  Session session(std::move(world), std::move(motion), settings);

  SamplesFile samples(options.out, session.notes(), session.start());
  ProgressLine progress("rendering");
  long rows = 0;
  double deepest = 0.0, greatest_force = 0.0;
  session.run_simulated(
      [&](const TickRecord& record) {
        samples.write(record);
        ++rows;
        deepest = std::max(deepest, record.deepest);
        greatest_force = std::max(greatest_force, record.wrench.force.vector().norm());
        return true;
      },
      [&](double part) { progress.show(part); });
  samples.close();
  print_result(options, rows, deepest, greatest_force);
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
                   "Motion of the tool body's frame: comma-separated columns t (s), x, y, z (m), qw, qx, qy, qz")
      ->type_name("FILE")
      ->required();
  command->add_option("--out", options->out, "File for the result, one row a haptic tick")
      ->type_name("FILE")
      ->required();
  options->settings.add_all(*command);
  command->callback([options] { run(*options); });
}

}  // namespace tegotae
