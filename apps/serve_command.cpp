// SPDX-License-Identifier: Apache-2.0
#include <apps/commands.hpp>
#include <apps/interruption.hpp>
#include <apps/serving_options.hpp>
#include <apps/settings_options.hpp>
#include <apps/validators.hpp>
#include <tegotae/lab/experiment.hpp>
#include <tegotae/lab/live_messages.hpp>
#include <tegotae/lab/live_session.hpp>
#include <tegotae/lab/scene_file.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>

namespace tegotae {
namespace {

struct ServeOptions {
  std::string scene, tool = "tool", experiment, interface = "page", recording, recordings = ".";
  ServingOptions serving;
  SettingsOptions settings;
};

LiveScene first_scene(const ServeOptions& options) {
  if (!options.experiment.empty()) {
    if (!options.scene.empty()) throw UsageError("give either a scene or --experiment, not both.");
    return live_scene_of(find_experiment(options.experiment));
  }
  if (options.scene.empty()) return {"table", find_scene("table.xml")};
  const std::filesystem::path file = options.scene;
  return {file.filename().string(), file, options.tool};
}

LiveSessionOptions session_options(const ServeOptions& options) {
  LiveSessionOptions session;
  session.settings = options.settings.checked();
  session.scene = first_scene(options);
  session.scenes = shipped_scenes();
  if (!options.scene.empty()) session.scenes.insert(session.scenes.begin(), session.scene);
  session.recordings = options.recordings;
  if (!options.recording.empty()) session.file = options.recording;
  return session;
}

void log(NoticeLevel level, const std::string& text) {
  if (level == NoticeLevel::kInfo) {
    fmt::print("tegotae: {}\n", text);
    std::fflush(stdout);
    return;
  }
  fmt::print(stderr, "tegotae: {}: {}\n", level == NoticeLevel::kWarning ? "warning" : "error", text);
}

void check_interface(const std::string& name) {
  if (name == "page") return;
  throw UsageError(fmt::format(
      "there is no interface '{}'; there is: page (a simulated interface and hand that the page guides).", name));
}

void serve(const ServeOptions& options) {
  check_interface(options.interface);
  ViewerServer server(options.serving.server_options());
  LiveSession session(session_options(options), output_to(server), log);
  listen_for_interruption();
  serve_until_stopped(server, session.inbox(), [&] {
    options.serving.announce(server, session.scene_name());
    session.run(interrupted());
  });
}

}  // namespace

void add_serve_command(CLI::App& program) {
  auto options = std::make_shared<ServeOptions>();
  CLI::App* const command = program.add_subcommand(
      "serve", "Run a scene in real time and serve a page that shows it, steers it and is the hand.");
  command->add_option("SCENE", options->scene, "Scene: an MJCF or URDF file; default: a table with free boxes")
      ->type_name("");
  command->add_option("--tool", options->tool, "Body of SCENE that the hand moves; default: tool")->type_name("BODY");
  command->add_option("--experiment", options->experiment, "Experiment to play, in place of a scene")
      ->type_name("NAME");
  command
      ->add_option("--interface", options->interface,
                   "Interface in the hand; page: simulated, guided from the page; default: page")
      ->type_name("NAME");
  command->add_option("--record", options->recording, "Recording (MCAP) to write from the beginning")
      ->type_name("FILE")
      ->check(not_empty("a file"));
  command
      ->add_option("--recordings", options->recordings,
                   "Folder of the recordings that are started from the page; default: this one")
      ->type_name("FOLDER")
      ->check(CLI::ExistingDirectory);
  options->serving.add(*command);
  options->settings.add_all(*command);
  command->callback([options] { serve(*options); });
}

}  // namespace tegotae
