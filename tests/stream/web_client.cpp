// SPDX-License-Identifier: Apache-2.0
#include <tests/stream/web_client.hpp>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/write.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>

#include <algorithm>
#include <array>
#include <cctype>
#include <chrono>
#include <stdexcept>
#include <utility>

namespace tegotae::test {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = boost::beast::http;
namespace websocket = boost::beast::websocket;
using boost::system::error_code;
using Tcp = asio::ip::tcp;

constexpr std::chrono::seconds kPatience{60};

// Waits for the one operation that `start` begins with the handler it is given.
template <class Start>
error_code wait(asio::io_context& io, const Start& start) {
  std::optional<error_code> result;
  start([&result](error_code error, auto&&...) { result = error; });
  io.restart();
  io.run_for(kPatience);
  if (!result) throw std::runtime_error("the server has not answered");
  return *result;
}

std::string lower_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

std::string text_of(beast::string_view text) { return {text.data(), text.size()}; }

void connect(asio::io_context& io, Tcp::socket& socket, std::uint16_t port, int receive_buffer) {
  socket.open(Tcp::v4());
  if (receive_buffer > 0) socket.set_option(asio::socket_base::receive_buffer_size(receive_buffer));
  const Tcp::endpoint server(asio::ip::address_v4::loopback(), port);
  const error_code error = wait(io, [&](auto&& done) { socket.async_connect(server, done); });
  if (error) throw std::runtime_error("no connection: " + error.message());
}

void reset_socket(Tcp::socket& socket) {
  error_code ignored;
  socket.set_option(asio::socket_base::linger(true, 0), ignored);
  socket.close(ignored);
}

bool write_to(asio::io_context& io, Tcp::socket& socket, std::string_view bytes) {
  return !wait(io, [&](auto&& done) { asio::async_write(socket, asio::buffer(bytes), done); });
}

}  // namespace

struct RawClient::Implementation {
  asio::io_context io;
  Tcp::socket socket{io};
  beast::flat_buffer buffer;
};

RawClient::RawClient(std::uint16_t port) : implementation_(std::make_unique<Implementation>()) {
  connect(implementation_->io, implementation_->socket, port, 0);
}

RawClient::~RawClient() = default;
RawClient::RawClient(RawClient&&) noexcept = default;

bool RawClient::write(std::string_view bytes) { return write_to(implementation_->io, implementation_->socket, bytes); }

void RawClient::end_writing() {
  error_code ignored;
  implementation_->socket.shutdown(Tcp::socket::shutdown_send, ignored);
}

void RawClient::reset() { reset_socket(implementation_->socket); }

std::string RawClient::read_all() {
  std::string all;
  std::array<char, 4096> part{};
  for (;;) {
    std::size_t size = 0;
    const error_code error = wait(implementation_->io, [&](auto&& done) {
      implementation_->socket.async_read_some(asio::buffer(part), [&size, done](error_code e, std::size_t n) {
        size = n;
        done(e);
      });
    });
    all.append(part.data(), size);
    if (error) return all;
  }
}

HttpReply RawClient::request(const std::string& method, const std::string& target,
                             const std::map<std::string, std::string>& headers) {
  http::request<http::empty_body> request;
  request.version(11);
  request.method_string(method);
  request.target(target);
  for (const auto& [name, value] : headers) request.set(name, value);
  HttpReply reply;
  if (wait(implementation_->io, [&](auto&& done) { http::async_write(implementation_->socket, request, done); })) {
    return reply;
  }
  http::response_parser<http::string_body> parser;
  parser.skip(method == "HEAD");
  if (wait(implementation_->io,
           [&](auto&& done) { http::async_read(implementation_->socket, implementation_->buffer, parser, done); })) {
    return reply;
  }
  reply.status = parser.get().result_int();
  for (const auto& field : parser.get())
    reply.headers[lower_case(text_of(field.name_string()))] = text_of(field.value());
  reply.body = parser.get().body();
  return reply;
}

struct WebSocketClient::Implementation {
  asio::io_context io;
  websocket::stream<Tcp::socket> socket{io};
  websocket::response_type response;
  std::string refusal;

  bool send(std::string_view bytes, bool text) {
    socket.text(text);
    return !wait(io, [&](auto&& done) { socket.async_write(asio::buffer(bytes), done); });
  }
};

WebSocketClient::WebSocketClient(std::uint16_t port, const WebSocketRequest& request)
    : implementation_(std::make_unique<Implementation>()) {
  auto& [io, socket, response, refused] = *implementation_;
  connect(io, socket.next_layer(), port, request.receive_buffer);
  socket.read_message_max(0);
  socket.set_option(websocket::stream_base::decorator([&](websocket::request_type& headers) {
    for (const auto& [name, value] : request.headers) headers.set(name, value);
  }));
  const error_code error = wait(io, [&, &ws = socket, &answer = response](auto&& done) {
    ws.async_handshake(answer, "localhost", request.target, done);
  });
  refused = response.body();
  if (error && error != websocket::error::upgrade_declined) throw std::runtime_error("no reply: " + error.message());
}

WebSocketClient::~WebSocketClient() = default;
WebSocketClient::WebSocketClient(WebSocketClient&&) noexcept = default;

unsigned WebSocketClient::status() const noexcept { return implementation_->response.result_int(); }
const std::string& WebSocketClient::refusal() const noexcept { return implementation_->refusal; }
bool WebSocketClient::send(std::string_view text) { return implementation_->send(text, true); }
bool WebSocketClient::send_binary(std::string_view bytes) { return implementation_->send(bytes, false); }

bool WebSocketClient::ping() {
  return !wait(implementation_->io, [&](auto&& done) { implementation_->socket.async_ping({}, done); });
}

bool WebSocketClient::write_raw(std::string_view bytes) {
  return write_to(implementation_->io, implementation_->socket.next_layer(), bytes);
}

std::optional<std::string> WebSocketClient::read() {
  beast::flat_buffer buffer;
  if (wait(implementation_->io, [&](auto&& done) { implementation_->socket.async_read(buffer, done); })) return {};
  return beast::buffers_to_string(buffer.cdata());
}

unsigned WebSocketClient::read_close() {
  while (read()) {
  }
  return implementation_->socket.reason().code;
}

const std::string& WebSocketClient::close_reason() const noexcept {
  implementation_->refusal =
      text_of({implementation_->socket.reason().reason.data(), implementation_->socket.reason().reason.size()});
  return implementation_->refusal;
}

void WebSocketClient::close() {
  wait(implementation_->io,
       [&](auto&& done) { implementation_->socket.async_close(websocket::close_code::normal, done); });
}

void WebSocketClient::reset() { reset_socket(implementation_->socket.next_layer()); }

}  // namespace tegotae::test
