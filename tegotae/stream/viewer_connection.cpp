// SPDX-License-Identifier: Apache-2.0
#include <tegotae/stream/viewer_connection.hpp>

#include <tegotae/stream/message_rate.hpp>
#include <tegotae/stream/web_answer.hpp>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>

#include <unistd.h>

#include <array>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace tegotae {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = boost::beast::http;
namespace websocket = boost::beast::websocket;
using boost::system::error_code;
using Tcp = asio::ip::tcp;
using HttpParser = http::request_parser<http::string_body>;  // only heads are read
using HttpRequest = HttpParser::value_type;

// Bytes of a request without body.
constexpr std::uint32_t kMaxHeader = 8 * 1024;
// Bytes that the system holds for a viewer beside the state in flight: about 0.2 s of states of 5 KB, so that what a
// slow viewer reads is not older. More would only add age.
constexpr int kSendBuffer = 64 * 1024;
// Read and thrown away after the last answer of a connection, so that closing it does not destroy the answer on its
// way.
constexpr std::size_t kMaxLinger = 256 * 1024;
// Bytes of a close frame's reason (RFC 6455, 5.5).
constexpr std::size_t kMaxReason = 123;

// The reason, cut where a character of UTF-8 begins.
std::string cut_reason(std::string reason) {
  if (reason.size() <= kMaxReason) return reason;
  std::size_t end = kMaxReason;
  while (end > 0 && (static_cast<unsigned char>(reason[end]) & 0xc0) == 0x80) --end;
  reason.resize(end);
  return reason;
}

// One viewer's WebSocket.
class ViewerConnection final : public ServerConnection, public std::enable_shared_from_this<ViewerConnection> {
 public:
  ViewerConnection(beast::tcp_stream&& stream, const ConnectionContext& context)
      : deadline_(stream.get_executor()),
        socket_(std::move(stream)),
        context_(context),
        rate_(context.options.max_messages_per_second),
        serial_(context.connections.add(*this)) {}

  ~ViewerConnection() override {
    context_.connections.remove(serial_);
    if (!viewer_) return;
    context_.connections.remove_viewer(*viewer_);
    context_.hub.left(*viewer_);
  }

  void accept(const HttpRequest& request) {
    const ViewerServerOptions& options = context_.options;
    beast::get_lowest_layer(*socket_).expires_never();  // the WebSocket keeps times of its own
    socket_->set_option(websocket::stream_base::timeout{options.request_timeout, options.viewer_timeout, true});
    socket_->read_message_max(options.max_message);
    socket_->auto_fragment(false);
    socket_->text(true);
    socket_->control_callback([this](websocket::frame_type, beast::string_view) { count_message(); });
    socket_->async_accept(request, [self = shared_from_this()](error_code error) {
      if (!error) self->enter();
    });
  }

  void wake() override {
    if (context_.hub.closing(*viewer_)) start_deadline();
    if (!in_flight_) write_next();
  }

  // Closing the socket would not do: a read that finds a fault while a close waits for it waits for that close, without
  // end. Gone with the stream are both.
  void cut() override {
    const auto self = shared_from_this();
    close_begun_ = true;
    socket_.reset();
  }

 private:
  void enter() {
    if (!socket_) return;
    viewer_ = context_.hub.enter();
    if (!viewer_) {
      close(websocket::close_code::try_again_later, "no place for one more viewer");
    } else {
      context_.connections.make_viewer(serial_, *viewer_);
      context_.hub.joined(*viewer_);
    }
    read();
  }

  // Reads until the connection ends, also while it closes: the peer's answer to the close is read here.
  void read() {
    socket_->async_read(buffer_, [self = shared_from_this()](error_code error, std::size_t) {
      error ? self->fail() : self->take_message();
    });
  }

  void take_message() {
    if (!socket_) return;
    if (viewer_ && !close_begun_ && !context_.hub.closing(*viewer_)) {
      count_message();
      if (!socket_->got_text()) {
        context_.hub.close(*viewer_, CloseCode::kUnknownData, "text frames only");
      } else if (!context_.hub.closing(*viewer_)) {
        const auto bytes = buffer_.cdata();
        context_.hub.received(*viewer_, {static_cast<const char*>(bytes.data()), bytes.size()});
      }
    }
    buffer_.consume(buffer_.size());
    read();
  }

  void count_message() {
    if (rate_.count(std::chrono::steady_clock::now()) || !viewer_) return;
    context_.hub.close(*viewer_, CloseCode::kPolicy, "too many messages a second");
  }

  void write_next() {
    if (close_begun_) return;
    const ViewerOutbox::Next next = context_.hub.next(*viewer_);
    if (const auto* text = std::get_if<SharedText>(&next)) {
      write(*text);
    } else if (const auto* order = std::get_if<CloseOrder>(&next)) {
      close(static_cast<websocket::close_code>(order->code), order->reason);
    }
  }

  void write(const SharedText& text) {
    in_flight_ = text;
    socket_->async_write(asio::buffer(*in_flight_), [self = shared_from_this()](error_code error, std::size_t) {
      self->in_flight_.reset();
      error ? self->fail() : self->write_next();
    });
  }

  void close(websocket::close_code code, std::string reason) {
    if (std::exchange(close_begun_, true)) return;
    start_deadline();
    websocket::close_reason why(code);
    why.reason = cut_reason(std::move(reason));
    socket_->async_close(why, [self = shared_from_this()](error_code) {});
  }

  // The connection is at its end: what else is under way learns so by itself, at the deadline at the latest.
  void fail() {
    close_begun_ = true;
    start_deadline();
  }

  // From here on the connection has so long to end by itself. Does not keep it alive.
  void start_deadline() {
    if (std::exchange(has_deadline_, true)) return;
    deadline_.expires_after(context_.options.farewell_timeout);
    deadline_.async_wait([weak = weak_from_this()](error_code error) {
      const auto self = weak.lock();
      if (self && !error) self->cut();
    });
  }

  asio::steady_timer deadline_;
  // Until it is cut. Without compression: it costs more time than it saves here.
  std::optional<websocket::stream<beast::tcp_stream, false>> socket_;
  ConnectionContext context_;
  MessageRate rate_;
  ConnectionSet::Serial serial_;
  std::optional<ViewerId> viewer_;
  beast::flat_buffer buffer_;
  SharedText in_flight_;
  bool close_begun_ = false, has_deadline_ = false;
};

// A connection that asks for files, one after the other, or becomes a viewer's.
class FileConnection final : public ServerConnection, public std::enable_shared_from_this<FileConnection> {
 public:
  FileConnection(Tcp::socket&& socket, const ConnectionContext& context)
      : stream_(std::move(socket)), context_(context), serial_(context.connections.add(*this)) {}

  ~FileConnection() override { context_.connections.remove(serial_); }

  void read() {
    parser_.emplace();
    parser_->header_limit(kMaxHeader);
    parser_->body_limit(std::numeric_limits<std::uint64_t>::max());  // never read
    stream_.expires_after(context_.options.request_timeout);
    http::async_read_header(stream_, buffer_, *parser_, [self = shared_from_this()](error_code error, std::size_t) {
      error ? self->take_failure(error) : self->take_request();
    });
  }

  void wake() override {}
  void cut() override { stream_.close(); }

 private:
  void take_failure(error_code error) {
    if (error == http::error::end_of_stream || error == http::error::partial_message ||
        error.category() != http::make_error_code(http::error::bad_version).category()) {
      return;  // nobody is there, or too slow
    }
    const bool too_long = error == http::error::header_limit || error == http::error::buffer_overflow;
    answer(too_long ? refusal(431, "This request is too long.\n") : refusal(400, "This is no HTTP request.\n"), false);
  }

  std::string_view header_of(http::field field) const {
    const auto range = parser_->get().equal_range(field);
    if (range.first == range.second) return {};
    if (std::next(range.first) != range.second) return "?";
    const beast::string_view value = range.first->value();
    return {value.data(), value.size()};
  }

  bool from_loopback() const {
    error_code error;
    const asio::ip::address address = stream_.socket().remote_endpoint(error).address();
    if (address.is_v6() && address.to_v6().is_v4_mapped()) {
      return asio::ip::make_address_v4(asio::ip::v4_mapped, address.to_v6()).is_loopback();
    }
    return !error && address.is_loopback();
  }

  void take_request() {
    const HttpRequest& request = parser_->get();
    WebQuestion question;
    question.method = {request.method_string().data(), request.method_string().size()};
    question.target = {request.target().data(), request.target().size()};
    question.host = header_of(http::field::host);
    question.origin = header_of(http::field::origin);
    question.has_origin = request.count(http::field::origin) > 0;
    question.is_upgrade = websocket::is_upgrade(request);
    question.from_loopback = from_loopback();
    WebAnswer found = answer_of(question, context_.access, context_.options.assets);
    if (found.status == 101) {
      if (!context_.hub.full()) return upgrade();
      found = refusal(503, "No place for one more viewer.\n");
    }
    answer(std::move(found), request.keep_alive() && parser_->is_done());
  }

  void upgrade() {
    const HttpRequest request = parser_->release();
    std::make_shared<ViewerConnection>(std::move(stream_), context_)->accept(request);
  }

  void answer(WebAnswer&& found, bool keep_alive) {
    answer_ = std::move(found);
    response_.emplace();
    response_->result(answer_.status);
    response_->keep_alive(keep_alive);
    response_->set(http::field::content_type,
                   beast::string_view(answer_.content_type.data(), answer_.content_type.size()));
    for (const auto& [name, value] : answer_.headers)
      response_->set(beast::string_view(name.data(), name.size()), value);
    response_->body() = {answer_.bytes.data(), answer_.bytes.size()};
    response_->content_length(answer_.bytes.size());
    serializer_.emplace(*response_);
    stream_.expires_after(context_.options.request_timeout);
    const auto sent = [self = shared_from_this()](error_code error, std::size_t) {
      if (!error) self->response_->keep_alive() ? self->read() : self->linger();
    };
    if (parser_->get().method() == http::verb::head) {
      http::async_write_header(stream_, *serializer_, sent);
    } else {
      http::async_write(stream_, *serializer_, sent);
    }
  }

  // Waits for the other end to close, so that what it still sends does not reset the connection before it has read.
  void linger() {
    error_code ignored;
    stream_.socket().shutdown(Tcp::socket::shutdown_send, ignored);
    stream_.expires_after(context_.options.farewell_timeout);
    discard();
  }

  void discard() {
    stream_.async_read_some(asio::buffer(discarded_), [self = shared_from_this()](error_code error, std::size_t size) {
      self->lingered_ += size;
      if (!error && self->lingered_ < kMaxLinger) self->discard();
    });
  }

  beast::tcp_stream stream_;
  ConnectionContext context_;
  ConnectionSet::Serial serial_;
  beast::flat_buffer buffer_{2 * kMaxHeader};
  std::optional<HttpParser> parser_;
  WebAnswer answer_;
  std::optional<http::response<http::span_body<const char>>> response_;
  std::optional<http::response_serializer<http::span_body<const char>>> serializer_;
  std::array<char, 4096> discarded_{};
  std::size_t lingered_ = 0;
};

}  // namespace

ConnectionSet::Serial ConnectionSet::add(ServerConnection& connection) {
  strangers_.emplace(++last_, &connection);
  return last_;
}

void ConnectionSet::remove(Serial serial) { strangers_.erase(serial); }

void ConnectionSet::make_viewer(Serial serial, ViewerId viewer) {
  const auto found = strangers_.find(serial);
  viewers_.emplace(viewer, found->second);
  strangers_.erase(found);
}

void ConnectionSet::remove_viewer(ViewerId viewer) { viewers_.erase(viewer); }

void ConnectionSet::wake(ViewerId viewer) {
  const auto found = viewers_.find(viewer);
  if (found != viewers_.end()) found->second->wake();
}

void ConnectionSet::cut_strangers() {
  std::vector<Serial> serials;
  for (const auto& [serial, connection] : strangers_) serials.push_back(serial);
  for (const Serial serial : serials) {
    const auto found = strangers_.find(serial);  // one that is cut may be gone at once
    if (found != strangers_.end()) found->second->cut();
  }
}

void ConnectionSet::cut_oldest_stranger() {
  if (!strangers_.empty()) strangers_.begin()->second->cut();
}

void start_connection(asio::io_context& io, int native_socket, bool is_ipv6, const ConnectionContext& context) {
  Tcp::socket socket(io);
  error_code error, ignored;
  socket.assign(is_ipv6 ? Tcp::v6() : Tcp::v4(), native_socket, error);
  if (error) {
    ::close(native_socket);
    return;
  }
  socket.set_option(Tcp::no_delay(true), ignored);
  socket.set_option(asio::socket_base::send_buffer_size(kSendBuffer), ignored);
  std::make_shared<FileConnection>(std::move(socket), context)->read();
}

}  // namespace tegotae
