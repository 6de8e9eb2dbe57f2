// SPDX-License-Identifier: Apache-2.0
#include <tegotae/stream/viewer_server.hpp>

#include <tests/stream/served.hpp>
#include <tests/stream/web_client.hpp>
#include <tests/sweep_size.hpp>

#include <gtest/gtest.h>

#include <array>
#include <optional>
#include <random>
#include <string>
#include <thread>
#include <vector>

namespace tegotae {
namespace {

using test::RawClient;
using test::Served;
using test::shared;
using test::sweep_size;
using test::test_options;
using test::WebSocketClient;

// A server and a viewer that keeps to the rules, and must get a new state after whatever others do.
class ViewerServerFuzz : public ::testing::Test {
 protected:
  ViewerServerFuzz() : good_(served_.server.port()) { served_.wait_for("joined 1"); }

  std::uint16_t port() const { return served_.server.port(); }

  void expect_state() {
    const std::string state = "state " + std::to_string(++states_);
    served_.server.publish(shared(state));
    ASSERT_EQ(good_.read(), state);
  }

  std::size_t below(std::size_t end) { return std::uniform_int_distribution<std::size_t>(0, end - 1)(random_); }

  std::string random_bytes(std::size_t size) {
    std::string bytes(size, '\0');
    for (char& byte : bytes) byte = static_cast<char>(random_());
    return bytes;
  }

  template <std::size_t Count>
  std::string one_of(const std::array<const char*, Count>& choices) {
    return choices[below(Count)];
  }

  std::string random_request();
  std::string random_frame();

  Served served_{[] {
    auto options = test_options();
    options.request_timeout = std::chrono::milliseconds(500);
    options.farewell_timeout = std::chrono::milliseconds(200);
    options.max_message = 2000;
    options.max_waiting_messages = 10'000;
    return options;
  }()};
  WebSocketClient good_;
  std::mt19937 random_{20'261'122};
  int states_ = 0;
};

// Made of parts of good requests, some of them wrong or at the wrong place.
std::string ViewerServerFuzz::random_request() {
  static constexpr std::array kMethods = {"GET", "HEAD", "POST", "get", "", "OPTIONS", "GET GET", "\x01"};
  static constexpr std::array kTargets = {"/", "/live", "/page.js", "*", "", "//", "/%00", "/live?token=", "http://a/"};
  static constexpr std::array kVersions = {"HTTP/1.1", "HTTP/1.0", "HTTP/2", "HTTP/1.1 ", "", "\n"};
  static constexpr std::array kLines = {"Host: localhost",
                                        "Host: evil.example",
                                        "Host:",
                                        "Upgrade: websocket",
                                        "Connection: Upgrade",
                                        "Connection: keep-alive, Upgrade, close",
                                        "Sec-WebSocket-Version: 13",
                                        "Sec-WebSocket-Version: 99",
                                        "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==",
                                        "Sec-WebSocket-Key: x",
                                        "Sec-WebSocket-Extensions: permessage-deflate; server_max_window_bits=99",
                                        "Origin: http://localhost",
                                        "Content-Length: 18446744073709551616",
                                        "Content-Length: -1",
                                        "Transfer-Encoding: chunked",
                                        ": no name",
                                        "no colon",
                                        " folded"};
  std::string request = one_of(kMethods) + ' ' + one_of(kTargets) + ' ' + one_of(kVersions) + "\r\n";
  for (std::size_t lines = below(10); lines > 0; --lines) request += one_of(kLines) + "\r\n";
  if (below(8) == 0) request.insert(below(request.size()), random_bytes(3));
  return request + "\r\n";
}

// A head with random bits and lengths, rarely valid, and fewer, as many or more bytes than it says.
std::string ViewerServerFuzz::random_frame() {
  std::string frame(1, static_cast<char>(below(2) == 0 ? 0x80 | below(16) : below(256)));
  const std::size_t size = below(4) == 0 ? below(3000) : below(126);
  const int mask = below(8) == 0 ? 0 : 0x80;
  if (size < 126) {
    frame += static_cast<char>(static_cast<int>(size) | mask);
  } else {
    frame += static_cast<char>(126 | mask);
    frame += static_cast<char>(size >> 8);
    frame += static_cast<char>(size & 0xff);
  }
  if (below(16) == 0) frame = std::string(1, static_cast<char>(random_())) + "\xff" + random_bytes(8);
  if (mask != 0) frame += random_bytes(4);
  return frame + random_bytes(below(8) == 0 ? below(3000) : size);
}

TEST_F(ViewerServerFuzz, RandomBytes) {
  for (int i = 0; i < sweep_size(500); ++i) {
    RawClient client(port());
    client.write(random_bytes(below(i % 16 == 0 ? 20'000 : 200)));
    if (i % 3 == 0) client.end_writing();
    if (i % 3 == 1) client.reset();
    expect_state();
  }
}

TEST_F(ViewerServerFuzz, RandomRequests) {
  for (int i = 0; i < sweep_size(2000); ++i) {
    RawClient client(port());
    for (std::size_t requests = 1 + below(3); requests > 0; --requests) client.write(random_request());
    if (below(4) == 0) {
      client.end_writing();
      client.read_all();
    }
    expect_state();
  }
}

TEST_F(ViewerServerFuzz, RandomFrames) {
  for (int i = 0; i < sweep_size(1000); ++i) {
    WebSocketClient client(port());
    ASSERT_EQ(client.status(), 101U);
    for (std::size_t frames = 1 + below(4); frames > 0; --frames) client.write_raw(random_frame());
    if (below(3) == 0) client.reset();
    expect_state();
  }
  for (const std::string& event : served_.events()) ASSERT_EQ(event.find(std::string(2001, ' ')), std::string::npos);
}

// Connections that are opened and left so are cut when others come, and viewers keep theirs.
TEST_F(ViewerServerFuzz, HalfOpenConnections) {
  std::vector<RawClient> held;
  for (int i = 0; i < 300; ++i) {
    held.emplace_back(port());
    if (i % 2 == 0) held.back().write("GET / HTTP/1.1\r\nHost:");
    if (i % 5 == 0) held.back().end_writing();
  }
  expect_state();
  EXPECT_EQ(RawClient(port()).request("GET", "/").status, 200U);
  EXPECT_EQ(WebSocketClient(port()).status(), 101U);
  expect_state();
}

TEST_F(ViewerServerFuzz, ThousandsOfShortConnections) {
  for (int i = 0; i < sweep_size(3000); ++i) {
    if (i % 3 == 0) {
      EXPECT_EQ(RawClient(port()).request("GET", "/page.js").body, "'use strict';");
    } else if (i % 3 == 1) {
      RawClient(port()).reset();
    } else {
      WebSocketClient client(port());
      if (i % 2 == 0) client.send("hello");
      client.reset();
    }
    if (i % 10 == 0) expect_state();
  }
  expect_state();
}

// All functions at once, from several threads, while viewers come and go and one is disconnected at times.
TEST_F(ViewerServerFuzz, ManyThreads) {
  std::vector<std::thread> threads;
  for (int thread = 0; thread < 3; ++thread) {
    threads.emplace_back([this, thread] {
      for (int i = 0; i < sweep_size(2000); ++i) {
        served_.server.publish(shared("p"));
        if (i % 16 == 0) served_.server.send_all(shared("a"));
        served_.server.send(static_cast<ViewerId>(2 + i % 50), shared("s"));
        if (i % 64 == 0) served_.server.disconnect(static_cast<ViewerId>(2 + (i + thread) % 50), "at random");
        ASSERT_LE(served_.server.viewer_count(), 32U);
      }
    });
  }
  for (int i = 0; i < sweep_size(200); ++i) {
    WebSocketClient client(port());
    if (client.status() == 101) client.send("hello");
    if (i % 2 == 0) client.reset();
  }
  for (std::thread& thread : threads) thread.join();
  served_.server.send(1, shared("last"));
  std::optional<std::string> text;
  do text = good_.read();
  while (text && text != "last");
  EXPECT_EQ(text, "last");
  expect_state();
}

}  // namespace
}  // namespace tegotae
