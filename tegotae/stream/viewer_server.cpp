// SPDX-License-Identifier: Apache-2.0
#include <tegotae/stream/viewer_server.hpp>

#include <tegotae/stream/viewer_connection.hpp>
#include <tegotae/stream/viewer_hub.hpp>
#include <tegotae/stream/web_access.hpp>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>

#include <atomic>
#include <chrono>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

namespace tegotae {
namespace {

namespace asio = boost::asio;
using boost::system::error_code;
using Tcp = asio::ip::tcp;

// Connections that are no viewers; one more, and the oldest of them is cut, so that who holds them open keeps nobody
// out. A browser opens six.
constexpr std::size_t kMaxStrangers = 64;
// Before accepting is tried again where the system has no more sockets to give.
constexpr std::chrono::milliseconds kAcceptPause{100};

std::string without_brackets(const std::string& host) {
  return host.size() > 2 && host.front() == '[' && host.back() == ']' ? host.substr(1, host.size() - 2) : host;
}

std::string refusal_to_listen(const ViewerServerOptions& options, error_code error) {
  const std::string port = "Port " + std::to_string(options.port);
  if (error == asio::error::address_in_use) {
    return port + " of " + options.host + " is taken: choose another with --port, or 0 for any that is free.";
  }
  if (error == asio::error::access_denied) {
    return port + " is kept for the system: choose one from 1024 on with --port, or 0 for any that is free.";
  }
  if (error == boost::system::errc::address_not_available) {
    return "'" + options.host + "' is no address of this machine: name one of its own with --host.";
  }
  return port + " of " + options.host + " cannot be served (" + error.message() +
         "): name another with --host and --port.";
}

Tcp::endpoint endpoint_of(asio::io_context& io, const ViewerServerOptions& options) {
  error_code error;
  Tcp::resolver resolver(io);
  const auto found = resolver.resolve(without_brackets(options.host), std::to_string(options.port), error);
  if (error || found.empty()) {
    throw WebServerError("The host '" + options.host +
                         "' is not known: name this machine or one of its addresses with --host, such as 127.0.0.1.");
  }
  return found.begin()->endpoint();
}

Tcp::acceptor listen(asio::io_context& io, const ViewerServerOptions& options) {
  const Tcp::endpoint endpoint = endpoint_of(io, options);
  Tcp::acceptor acceptor(io);
  error_code error;
  const auto checked = [&](error_code result) {
    if (result) throw WebServerError(refusal_to_listen(options, result));
  };
  checked(acceptor.open(endpoint.protocol(), error));
  checked(acceptor.set_option(asio::socket_base::reuse_address(true), error));
  checked(acceptor.bind(endpoint, error));
  checked(acceptor.listen(asio::socket_base::max_listen_connections, error));
  return acceptor;
}

}  // namespace

class ViewerServer::Implementation {
 public:
  explicit Implementation(ViewerServerOptions options)
      : options_(std::move(options)),
        access_(options_.host, options_.token),
        hub_(options_, [this](const std::vector<ViewerId>& viewers) { wake(viewers); }),
        acceptor_(listen(io_, options_)),
        pause_(io_),
        port_(acceptor_.local_endpoint().port()),
        is_ipv6_(acceptor_.local_endpoint().address().is_v6()) {}

  void start(ViewerServerEvents events) {
    hub_.set_events(std::move(events));
    accept();
    thread_ = std::thread([this] { run(); });
  }

  void stop(const SharedText& last_message) {
    if (std::this_thread::get_id() == own_thread_.load()) return begin_stop(last_message);
    const std::lock_guard lock(joining_);  // who comes second returns when the thread has ended, too
    if (!thread_.joinable()) return;
    begin_stop(last_message);
    thread_.join();
  }

  ViewerHub& hub() noexcept { return hub_; }
  std::uint16_t port() const noexcept { return port_; }
  std::string address() const { return access_.address(port_); }

 private:
  // Until no connection is left and none can come.
  void run() {
    own_thread_ = std::this_thread::get_id();
    for (;;) {
      try {
        io_.run();
        return;
      } catch (...) {
        // No memory for one connection, which has ended with that; the others go on.
      }
    }
  }

  void wake(const std::vector<ViewerId>& viewers) {
    asio::post(io_, [this, viewers] {
      for (const ViewerId viewer : viewers) connections_.wake(viewer);
    });
  }

  void begin_stop(const SharedText& last_message) {
    hub_.finish(last_message);
    asio::post(io_, [this] {
      error_code ignored;
      acceptor_.close(ignored);
      pause_.cancel();
      connections_.cut_strangers();
    });
  }

  void accept() {
    acceptor_.async_accept([this](error_code error, Tcp::socket socket) {
      if (!acceptor_.is_open()) return;
      if (error) return accept_later();
      accept();
      if (connections_.strangers() >= kMaxStrangers) connections_.cut_oldest_stranger();
      const int native_socket = socket.release(error);
      if (!error) start_connection(io_, native_socket, is_ipv6_, {options_, access_, hub_, connections_});
    });
  }

  void accept_later() {
    pause_.expires_after(kAcceptPause);
    pause_.async_wait([this](error_code) {
      if (acceptor_.is_open()) accept();
    });
  }

  ViewerServerOptions options_;
  WebAccess access_;
  ViewerHub hub_;
  ConnectionSet connections_;
  asio::io_context io_{1};  // after what its connections use when they end with it
  Tcp::acceptor acceptor_;
  asio::steady_timer pause_;
  std::uint16_t port_;
  bool is_ipv6_;
  std::atomic<std::thread::id> own_thread_{};
  std::mutex joining_;
  std::thread thread_;
};

ViewerServer::ViewerServer(ViewerServerOptions options)
    : implementation_(std::make_unique<Implementation>(std::move(options))) {}

ViewerServer::~ViewerServer() { stop(); }

void ViewerServer::start(ViewerServerEvents events) { implementation_->start(std::move(events)); }

void ViewerServer::publish(const SharedText& state) { implementation_->hub().publish(state); }

void ViewerServer::send(ViewerId viewer, SharedText message) {
  implementation_->hub().send(viewer, std::move(message));
}

void ViewerServer::send_all(const SharedText& message) { implementation_->hub().send_all(message); }

void ViewerServer::disconnect(ViewerId viewer, std::string reason) {
  implementation_->hub().close(viewer, CloseCode::kPolicy, std::move(reason));
}

std::size_t ViewerServer::viewer_count() const { return implementation_->hub().count(); }

std::uint64_t ViewerServer::callback_failures() const noexcept { return implementation_->hub().callback_failures(); }

std::uint16_t ViewerServer::port() const noexcept { return implementation_->port(); }

std::string ViewerServer::address() const { return implementation_->address(); }

void ViewerServer::stop(const SharedText& last_message) { implementation_->stop(last_message); }

}  // namespace tegotae
