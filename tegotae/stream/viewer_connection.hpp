// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/stream/viewer_hub.hpp>
#include <tegotae/stream/viewer_options.hpp>
#include <tegotae/stream/web_access.hpp>

#include <cstdint>
#include <map>

// Named only: this header is installed, and who includes it needs no Boost.
namespace boost::asio {
class io_context;
}

namespace tegotae {

/// A connection as the server sees it. It keeps itself alive while the io_context has something to do for it.
class ServerConnection {
 public:
  virtual ~ServerConnection() = default;
  virtual void wake() = 0;  ///< something waits for the viewer
  virtual void cut() = 0;   ///< closes the socket at once; the connection ends by itself soon after
};

/// All connections that live. Of the server's thread alone.
class ConnectionSet {
 public:
  using Serial = std::uint64_t;

  Serial add(ServerConnection& connection);
  void remove(Serial serial);
  /// From here on the connection is a viewer's, until remove_viewer().
  void make_viewer(Serial serial, ViewerId viewer);
  void remove_viewer(ViewerId viewer);

  void wake(ViewerId viewer);
  /// Of those that are no viewers: all, or the one that came first.
  void cut_strangers();
  void cut_oldest_stranger();
  std::size_t strangers() const noexcept { return strangers_.size(); }

 private:
  std::map<Serial, ServerConnection*> strangers_;  ///< in the order in which they came
  std::map<ViewerId, ServerConnection*> viewers_;
  Serial last_ = 0;
};

/// What all connections of a server share; outlives them.
struct ConnectionContext {
  const ViewerServerOptions& options;
  const WebAccess& access;
  ViewerHub& hub;
  ConnectionSet& connections;
};

/// Serves whoever is at the other end of a connected stream socket, which it takes over: files by HTTP, and a WebSocket
/// where one is granted.
void start_connection(boost::asio::io_context& io, int native_socket, bool is_ipv6, const ConnectionContext& context);

}  // namespace tegotae
