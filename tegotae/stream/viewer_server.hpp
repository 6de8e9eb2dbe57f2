// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/stream/viewer_options.hpp>

#include <cstdint>
#include <memory>
#include <string>

namespace tegotae {

/// Serves a page to browsers (HTTP/1.1) and talks with them over WebSockets at /live (RFC 6455, text frames). Knows
/// nothing of what the texts say. All sockets are handled on one thread of the server's own, without real-time rights;
/// every function may be called from any thread but a haptic one (they allocate and take a lock for a few
/// instructions), and none but stop() waits for a viewer.
///
/// What one viewer gets comes in the order in which it was given; of what is published, it gets the newest when it is
/// ready for one, and the ones before are left out. So a slow viewer holds one state in flight and one that waits.
///
/// Who is let in: a request must name a host that is served (so that a foreign name that resolves to this machine is
/// refused), a WebSocket must come from a page of this server (Origin), and pages and WebSockets must show the token
/// where there is one. A program, which sends no Origin, is let in from this machine or with the token.
class ViewerServer {
 public:
  /// Takes the port: from here on connections are accepted by the system, and answered from start() on. Throws
  /// WebServerError where host, port or token cannot be used.
  explicit ViewerServer(ViewerServerOptions options);
  /// As stop().
  ~ViewerServer();
  ViewerServer(const ViewerServer&) = delete;
  ViewerServer& operator=(const ViewerServer&) = delete;

  /// Starts the thread. Once, and before other threads use the server. Throws std::system_error where the system has no
  /// thread left.
  void start(ViewerServerEvents events);

  /// The newest state, to all viewers.
  void publish(const SharedText& state);

  /// To one viewer, in order and not left out. A viewer for which too much waits is disconnected (code 1008). One that
  /// has left is none to send to.
  void send(ViewerId viewer, SharedText message);
  void send_all(const SharedText& message);

  /// Closes one viewer's connection with code 1008 and the reason (cut to 123 bytes); what waits for it is not sent.
  void disconnect(ViewerId viewer, std::string reason);

  std::size_t viewer_count() const;
  std::uint64_t callback_failures() const noexcept;  ///< how many callbacks have thrown
  std::uint16_t port() const noexcept;               ///< the one taken
  std::string address() const;                       ///< to be opened in a browser, with the token

  /// Takes nobody in any more, sends each viewer what waits and `last_message` (null: none), closes with code 1001
  /// (going away) and joins the thread: within `farewell_timeout`, after which what is left is cut. From a callback it
  /// returns at once and is finished by the destructor. Only the first call counts.
  void stop(const SharedText& last_message = nullptr);

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace tegotae
