// SPDX-License-Identifier: Apache-2.0
#include <apps/serving_options.hpp>
#include <apps/validators.hpp>
#include <tegotae/lab/child_process.hpp>
#include <tegotae/stream/random_token.hpp>
#include <tegotae/stream/short_messages.hpp>
#include <tegotae/stream/web_page.hpp>

#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <memory>
#include <string_view>
#include <thread>
#include <utility>

namespace tegotae {
namespace {

// A name may begin with 127. and lead elsewhere: of these only addresses.
bool is_loopback(const std::string& host) {
  const bool is_number = host.find_first_not_of("0123456789.") == std::string::npos;
  return host == "localhost" || host == "::1" || (is_number && host.starts_with("127."));
}

}  // namespace

ViewerOutput output_to(ViewerServer& server) {
  return {[&](const SharedText& state) { server.publish(state); },
          [&](ViewerId viewer, SharedText message) { server.send(viewer, std::move(message)); },
          [&](const SharedText& message) { server.send_all(message); }, [&] { return server.viewer_count(); },
          [&](ViewerId viewer, std::string reason) { server.disconnect(viewer, std::move(reason)); }};
}

void serve_until_stopped(ViewerServer& server, LiveInbox& inbox, const std::function<void()>& run) {
  const auto stop = [&](const char* why) { server.stop(std::make_shared<const std::string>(encode_end(why))); };
  server.start({[&](ViewerId viewer) { inbox.joined(viewer); },
                [&](ViewerId viewer, std::string_view message) { inbox.received(viewer, message); },
                [&](ViewerId viewer) { inbox.left(viewer); }});
  try {
    run();
  } catch (const std::exception& error) {
    stop(error.what());
    throw;
  }
  stop("the program was stopped.");
  fmt::print("tegotae: stopped.\n");
}

void ServingOptions::add(CLI::App& command) {
  command.add_option("--port", port, "Port to serve the page on; 0: any that is free; default: 8700")
      ->type_name("N")
      ->check(whole_number("port", 0, 65535));
  command
      .add_option("--host", host,
                  "Name or address of this machine to serve on, 0.0.0.0 for all; beyond this machine a token is asked "
                  "for, which the printed address holds; default: 127.0.0.1")
      ->type_name("HOST")
      ->check(not_empty("a name or an address"));
  command.add_flag("--open", open, "Open the page in the browser");
}

ViewerServerOptions ServingOptions::server_options() const {
  ViewerServerOptions options;
  options.host = host;
  options.port = port;
  if (!is_loopback(host)) options.token = random_token();
  options.assets.assign(web_page().begin(), web_page().end());
  return options;
}

void ServingOptions::announce(const ViewerServer& server, const std::string& what) const {
  fmt::print("tegotae: {} at {} (Ctrl-C ends)\n", what, server.address());
  std::fflush(stdout);
  if (!open) return;
  // Some openers wait for the browser to end.
  std::thread([address = server.address()] {
    if (!run_child({"xdg-open", address}, ".").not_found) return;
    fmt::print(stderr, "tegotae: warning: there is no xdg-open to open a browser with; open {} yourself.\n", address);
  }).detach();
}

}  // namespace tegotae
