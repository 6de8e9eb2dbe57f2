// SPDX-License-Identifier: Apache-2.0
#include <apps/commands.hpp>
#include <apps/interruption.hpp>
#include <apps/serving_options.hpp>
#include <apps/validators.hpp>
#include <tegotae/lab/replay_view.hpp>
#include <tegotae/stream/short_messages.hpp>

#include <fmt/format.h>

#include <exception>
#include <filesystem>
#include <memory>
#include <string>

namespace tegotae {
namespace {

struct ReplayOptions {
  std::string recording;
  ServingOptions serving;
};

void stop(ViewerServer& server, const std::string& why) {
  server.stop(std::make_shared<const std::string>(encode_end(why)));
}

void replay(const ReplayOptions& options) {
  const std::filesystem::path file = options.recording;
  ViewerServer server(options.serving.server_options());
  ReplayView view(file, output_to(server));
  if (!view.warning().empty()) fmt::print(stderr, "tegotae: warning: {}\n", view.warning());
  listen_for_interruption();
  server.start({[&](ViewerId viewer) { view.inbox().joined(viewer); },
                [&](ViewerId viewer, std::string_view message) { view.inbox().received(viewer, message); },
                [&](ViewerId viewer) { view.inbox().left(viewer); }});
  options.serving.announce(server, fmt::format("{} ({:.1f} s)", file.filename().string(), view.session().duration()));
  try {
    view.run(interrupted());
  } catch (const std::exception& error) {
    stop(server, error.what());
    throw;
  }
  stop(server, "the program was stopped.");
  fmt::print("tegotae: stopped.\n");
}

}  // namespace

void add_replay_command(CLI::App& program) {
  auto options = std::make_shared<ReplayOptions>();
  CLI::App* const command = program.add_subcommand("replay", "Show a recording in a page, with a time bar.");
  command->add_option("FILE", options->recording, "Recording (MCAP)")->required()->check(not_empty("a file"));
  options->serving.add(*command);
  command->callback([options] { replay(*options); });
}

}  // namespace tegotae
