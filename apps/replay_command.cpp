// SPDX-License-Identifier: Apache-2.0
#include <apps/commands.hpp>
#include <apps/interruption.hpp>
#include <apps/serving_options.hpp>
#include <apps/validators.hpp>
#include <tegotae/lab/replay_view.hpp>

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <string>

namespace tegotae {
namespace {

struct ReplayOptions {
  std::string recording;
  ServingOptions serving;
};

void replay(const ReplayOptions& options) {
  const std::filesystem::path file = options.recording;
  ViewerServer server(options.serving.server_options());
  ReplayView view(file, output_to(server));
  if (!view.warning().empty()) fmt::print(stderr, "tegotae: warning: {}\n", view.warning());
  listen_for_interruption();
  const double duration = view.session().duration();
  serve_until_stopped(server, view.inbox(), [&] {
    options.serving.announce(server, fmt::format("{} ({:.1f} s)", file.filename().string(), duration));
    view.run(interrupted());
  });
}

}  // namespace

void add_replay_command(CLI::App& program) {
  auto options = std::make_shared<ReplayOptions>();
  CLI::App* const command = program.add_subcommand("replay", "Show a recording in a page, with a time bar.");
  command->add_option("FILE", options->recording, "Recording (MCAP)")
      ->type_name("")
      ->required()
      ->check(not_empty("a file"));
  options->serving.add(*command);
  command->callback([options] { replay(*options); });
}

}  // namespace tegotae
