// SPDX-License-Identifier: Apache-2.0
#include <bench/live/viewers.hpp>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/websocket.hpp>

#include <time.h>

#include <charconv>
#include <chrono>
#include <future>
#include <string_view>
#include <thread>

namespace tegotae::bench {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
using boost::system::error_code;
using Tcp = asio::ip::tcp;
using WebSocket = beast::websocket::stream<Tcp::socket>;

void connect(WebSocket& socket, std::uint16_t port) {
  socket.next_layer().connect({asio::ip::address_v4::loopback(), port});
  socket.next_layer().set_option(Tcp::no_delay(true));
  socket.read_message_max(0);
  socket.handshake("127.0.0.1:" + std::to_string(port), "/live");
}

std::string_view text_of(const beast::flat_buffer& buffer) {
  return {static_cast<const char*>(buffer.data().data()), buffer.size()};
}

bool is_state(std::string_view text) { return text.starts_with(R"({"type":"state")"); }

double number_after(std::string_view text, std::string_view key) {
  const std::size_t begin = text.find(key) + key.size();
  double number = 0.0;
  std::from_chars(text.data() + begin, text.data() + text.size(), number);
  return number;
}

double unix_milliseconds() {
  return std::chrono::duration<double, std::milli>(std::chrono::system_clock::now().time_since_epoch()).count();
}

double steady_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double own_processor_time() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

// What a frame without a mask carries before its text (RFC 6455, 5.2).
std::uint64_t frame_head(std::size_t size) { return size < 126 ? 2 : size < 65536 ? 4 : 10; }

struct Viewer {
  explicit Viewer(asio::io_context& io) : socket(io) {}

  WebSocket socket;
  beast::flat_buffer buffer;
  double newest = 0.0;  ///< number of the state
};

}  // namespace

void ViewerFigures::add(const ViewerFigures& other) {
  ages.insert(ages.end(), other.ages.begin(), other.ages.end());
  bytes += other.bytes;
  left_out += other.left_out;
  seconds += other.seconds;
  processor_time += other.processor_time;
}

class Viewers::Implementation {
 public:
  Implementation(std::uint16_t port, int count) {
    for (int i = 0; i < count; ++i) {
      viewers_.push_back(std::make_unique<Viewer>(io_));
      connect(viewers_.back()->socket, port);
    }
    for (const auto& viewer : viewers_) read(*viewer);
    thread_ = std::thread([this] { io_.run(); });
  }

  ~Implementation() {
    asio::post(io_, [this] {
      for (const auto& viewer : viewers_) {
        viewer->socket.async_close(beast::websocket::close_code::normal, [](error_code) {});
      }
    });
    thread_.join();
  }

  void begin() {
    on_thread([this] {
      figures_ = {};
      measuring_ = true;
      began_ = steady_seconds();
      processor_time_ = own_processor_time();
    });
  }

  ViewerFigures end() {
    on_thread([this] {
      measuring_ = false;
      figures_.seconds = steady_seconds() - began_;
      figures_.processor_time = own_processor_time() - processor_time_;
    });
    return figures_;
  }

 private:
  template <class Function>
  void on_thread(Function function) {
    std::promise<void> done;
    asio::post(io_, [&] {
      function();
      done.set_value();
    });
    done.get_future().wait();
  }

  void read(Viewer& viewer) {
    viewer.socket.async_read(viewer.buffer, [this, &viewer](error_code error, std::size_t) {
      if (error) return;
      take(viewer, text_of(viewer.buffer));
      viewer.buffer.consume(viewer.buffer.size());
      read(viewer);
    });
  }

  void take(Viewer& viewer, std::string_view text) {
    const double n = is_state(text) ? number_after(text, "\"n\":") : 0.0;
    if (measuring_) {
      figures_.bytes += frame_head(text.size()) + text.size();
      if (n > 0.0) figures_.ages.push_back(unix_milliseconds() - number_after(text, "\"made\":"));
      if (n > viewer.newest + 1.0 && viewer.newest > 0.0) {
        figures_.left_out += static_cast<std::uint64_t>(n - viewer.newest - 1.0);
      }
    }
    if (n > 0.0) viewer.newest = n;
  }

  asio::io_context io_;
  std::vector<std::unique_ptr<Viewer>> viewers_;
  ViewerFigures figures_;
  bool measuring_ = false;
  double began_ = 0.0, processor_time_ = 0.0;  // s
  std::thread thread_;
};

Viewers::Viewers(std::uint16_t port, int count) : implementation_(std::make_unique<Implementation>(port, count)) {}
Viewers::~Viewers() = default;
void Viewers::begin_measuring() { implementation_->begin(); }
ViewerFigures Viewers::end_measuring() { return implementation_->end(); }

void play_motion(std::uint16_t port, const std::string& name) {
  asio::io_context io;
  WebSocket socket(io);
  connect(socket, port);
  socket.write(asio::buffer(R"({"type":"motion","name":")" + name + "\"}"));
  const std::string plays = "\"motion\":\"" + name + '"';
  for (;;) {
    beast::flat_buffer buffer;
    socket.read(buffer);
    if (is_state(text_of(buffer)) && text_of(buffer).find(plays) != std::string_view::npos) break;
  }
  socket.close(beast::websocket::close_code::normal);
}

}  // namespace tegotae::bench
