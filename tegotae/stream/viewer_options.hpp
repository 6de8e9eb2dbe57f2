// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/stream/web_asset.hpp>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace tegotae {

/// A viewer, from 1 on; never used again for another while the server lives.
using ViewerId = std::uint64_t;

/// Text on its way to viewers, shared by all that it goes to. Not null.
using SharedText = std::shared_ptr<const std::string>;

/// How a viewer server serves. The limits hold for each connection, so that no viewer can take what others need.
struct ViewerServerOptions {
  std::string host = "127.0.0.1";  ///< name or address of this machine; 0.0.0.0 or :: for all its addresses
  std::uint16_t port = 8700;       ///< 0: any that is free
  std::string token;               ///< that viewers must show; empty: none is asked for. Letters, digits, - . _ ~
  /// What is handed out; the bytes outlive the server. A page (text/html) needs the token where one is asked for; what
  /// a page loads holds nothing of the session, and does not.
  std::vector<WebAsset> assets;
  bool greeting_first = true;  ///< publish() and send_all() reach a viewer only after the first send() to it
  int max_viewers = 32;
  std::size_t max_message = 64 * 1024;                ///< bytes of one message from a viewer
  int max_messages_per_second = 500;                  ///< from one viewer, control frames included
  std::size_t max_waiting_messages = 64;              ///< of send() for one viewer
  std::size_t max_waiting_bytes = 8 * 1024 * 1024;    ///< with so many waiting nothing more is taken
  std::chrono::milliseconds request_timeout{10'000};  ///< for a whole request to come, and for its answer to go
  std::chrono::milliseconds viewer_timeout{30'000};   ///< without a sign of life, pings answered included
  std::chrono::milliseconds farewell_timeout{2'000};  ///< for what still waits to go and a close to be answered
};

/// What happens, told on the server's own thread, one at a time; `left` comes once for each `joined`. A callback may
/// call the server, stop() too, and should be short: all viewers wait for it. What it throws is caught and counted.
struct ViewerServerEvents {
  std::function<void(ViewerId)> joined;
  std::function<void(ViewerId, std::string_view message)> received;  ///< valid UTF-8, until the callback returns
  std::function<void(ViewerId)> left;
};

/// The server cannot serve as asked; one sentence that says why and what would mend it.
struct WebServerError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace tegotae
