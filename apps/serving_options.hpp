// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/lab/live_inbox.hpp>
#include <tegotae/lab/viewer_output.hpp>
#include <tegotae/stream/viewer_server.hpp>

#include <CLI/CLI.hpp>

#include <cstdint>
#include <functional>
#include <string>

namespace tegotae {

/// The options of commands that serve the page.
struct ServingOptions {
  std::string host = "127.0.0.1";
  std::uint16_t port = 8700;
  bool open = false;

  void add(CLI::App& command);

  /// Of a server of the page. Beyond this machine a token is asked for, made anew at each start.
  ViewerServerOptions server_options() const;

  /// Says where `what` is to be seen, and opens a browser there where that is asked for.
  void announce(const ViewerServer& server, const std::string& what) const;
};

/// The functions of a server, for a session. The server must outlive them.
ViewerOutput output_to(ViewerServer& server);

/// Starts the server for what is `run` until it is interrupted, and stops it with the reason for the pages, also where
/// `run` throws: what the server tells `inbox` ends before this returns.
void serve_until_stopped(ViewerServer& server, LiveInbox& inbox, const std::function<void()>& run);

}  // namespace tegotae
