// SPDX-License-Identifier: Apache-2.0
#include <tegotae/stream/random_token.hpp>
#include <tegotae/stream/viewer_server.hpp>

#include <tests/stream/served.hpp>
#include <tests/stream/web_client.hpp>
#include <tests/sweep_size.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace tegotae {
namespace {

using namespace std::chrono_literals;
using test::RawClient;
using test::Served;
using test::shared;
using test::test_options;
using test::WebSocketClient;
using test::WebSocketRequest;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

// Large enough that the system holds but a few for one who does not read.
constexpr std::size_t kLarge = 256 * 1024;
constexpr int kSmallBuffer = 16 * 1024;

std::string large(int number) {
  std::string text = std::to_string(number) + " ";
  text.resize(kLarge, '.');
  return text;
}

std::weak_ptr<const std::string> publish_large(ViewerServer& server, int number) {
  const SharedText state = shared(large(number));
  server.publish(state);
  return state;
}

int number_of(const std::optional<std::string>& text) { return text ? std::stoi(*text) : -1; }

TEST(ViewerServer, ServesFilesWithTheirTypes) {
  const Served served;
  RawClient client(served.server.port());
  const auto page = client.request("GET", "/?anything");
  EXPECT_EQ(page.status, 200U);
  EXPECT_EQ(page.headers.at("content-type"), "text/html; charset=utf-8");
  EXPECT_EQ(page.headers.at("cache-control"), "no-store");
  EXPECT_EQ(page.body, "<!doctype html><title>t</title>");
  const auto script = client.request("GET", "/page.js");  // on the same connection
  EXPECT_EQ(script.headers.at("content-type"), "text/javascript; charset=utf-8");
  EXPECT_EQ(script.headers.at("x-content-type-options"), "nosniff");
  EXPECT_THAT(script.headers.at("content-security-policy"), HasSubstr("default-src 'none'"));
  EXPECT_EQ(script.body, "'use strict';");
  const auto head = client.request("HEAD", "/page.js");
  EXPECT_EQ(head.status, 200U);
  EXPECT_EQ(head.headers.at("content-length"), "13");
  EXPECT_EQ(head.body, "");
  EXPECT_EQ(client.request("GET", "/page.js").body, "'use strict';");
}

TEST(ViewerServer, RefusesWithAStatusAndASentence) {
  const Served served;
  const auto status = [&](const char* method, const char* target) {
    const auto reply = RawClient(served.server.port()).request(method, target);
    EXPECT_THAT(reply.body, HasSubstr(".\n")) << method << ' ' << target;
    return reply.status;
  };
  EXPECT_EQ(status("GET", "/none"), 404U);
  EXPECT_EQ(status("GET", "/../page.js"), 404U);
  EXPECT_EQ(status("POST", "/"), 405U);
  EXPECT_EQ(status("BREW", "/page.js"), 405U);
  EXPECT_EQ(status("GET", "/live"), 426U);
  EXPECT_EQ(RawClient(served.server.port()).request("GET", "/", {{"Host", "elsewhere.example"}}).status, 403U);
  EXPECT_EQ(RawClient(served.server.port()).request("GET", "/", {}).status, 403U);
}

// The answer to a request with a body comes although nobody reads the body.
TEST(ViewerServer, ABodyIsNotWaitedFor) {
  const Served served;
  RawClient client(served.server.port());
  ASSERT_TRUE(client.write("POST / HTTP/1.1\r\nHost: localhost\r\nContent-Length: 10000000\r\n\r\n"));
  ASSERT_TRUE(client.write(std::string(20'000, 'x')));
  client.end_writing();
  EXPECT_THAT(client.read_all(), HasSubstr("405"));
}

TEST(ViewerServer, RequestsHaveALengthAndATime) {
  auto options = test_options();
  options.request_timeout = 200ms;
  const Served served(options);
  RawClient longer(served.server.port());
  longer.write("GET / HTTP/1.1\r\nHost: localhost\r\nX: " + std::string(9'000, 'x'));
  EXPECT_THAT(longer.read_all(), HasSubstr("431"));
  RawClient garbage(served.server.port());
  garbage.write("\x16\x03\x01\x02\r\n\r\n");
  EXPECT_THAT(garbage.read_all(), HasSubstr("400"));
  RawClient slow(served.server.port());
  slow.write("GET / HTTP/1.1\r\nHost: loc");
  EXPECT_EQ(slow.read_all(), "");  // and the connection ends
}

TEST(ViewerServer, SaysWhoComesAndGoes) {
  Served served;
  EXPECT_EQ(served.server.viewer_count(), 0U);
  WebSocketClient first(served.server.port());
  EXPECT_EQ(first.status(), 101U);
  served.wait_for("joined 1");
  WebSocketClient second(served.server.port());
  served.wait_for("joined 2");
  EXPECT_EQ(served.server.viewer_count(), 2U);
  first.close();
  served.wait_for("left 1");
  EXPECT_EQ(served.server.viewer_count(), 1U);
  second.reset();
  served.wait_for("left 2");
  EXPECT_EQ(served.server.viewer_count(), 0U);
  EXPECT_THAT(served.events(), ElementsAre("joined 1", "joined 2", "left 1", "left 2"));
}

TEST(ViewerServer, TextGoesBothWays) {
  Served served;
  WebSocketClient first(served.server.port());
  served.wait_for("joined 1");
  WebSocketClient second(served.server.port());
  served.wait_for("joined 2");
  first.send("grüße");
  served.wait_for("1: grüße");
  served.server.send(1, shared("to one"));
  served.server.send(7, shared("to nobody"));
  served.server.send_all(shared("to all"));
  served.server.publish(shared("state"));
  EXPECT_EQ(first.read(), "to one");
  EXPECT_EQ(first.read(), "to all");
  EXPECT_EQ(first.read(), "state");
  EXPECT_EQ(second.read(), "to all");
  EXPECT_EQ(second.read(), "state");
}

TEST(ViewerServer, NothingComesBeforeTheGreeting) {
  auto options = test_options();
  options.greeting_first = true;
  Served served(options);
  WebSocketClient client(served.server.port());
  served.wait_for("joined 1");
  served.server.publish(shared("state before"));
  served.server.send_all(shared("notice before"));
  served.server.send(1, shared("greeting"));
  served.server.publish(shared("state after"));
  EXPECT_EQ(client.read(), "greeting");
  EXPECT_EQ(client.read(), "state after");
}

TEST(ViewerServer, ACallbackMaySend) {
  std::atomic<ViewerServer*> server{nullptr};
  Served served(test_options(),
                {[&](ViewerId id) { server.load()->send(id, shared("welcome")); },
                 [&](ViewerId, std::string_view text) { server.load()->send_all(shared("echo " + std::string(text))); },
                 {}});
  server = &served.server;
  WebSocketClient client(served.server.port());
  client.send("a");
  EXPECT_EQ(client.read(), "welcome");
  EXPECT_EQ(client.read(), "echo a");
}

// A viewer that does not read holds two states, and finds the newest when it reads again. Another, which reads each
// state, shows that the server had time for every one.
TEST(ViewerServer, ASlowViewerGetsTheNewestState) {
  Served served;
  WebSocketRequest slow;
  slow.receive_buffer = kSmallBuffer;
  WebSocketClient client(served.server.port(), slow);
  WebSocketClient fast(served.server.port());
  served.wait_for("joined 2");
  std::vector<std::weak_ptr<const std::string>> states;
  const int count = test::sweep_size(1000) + 100;
  for (int i = 1; i <= count; ++i) {
    states.push_back(publish_large(served.server, i));
    ASSERT_EQ(number_of(fast.read()), i);
    const auto expired = [](const auto& state) { return state.expired(); };
    states.erase(std::remove_if(states.begin(), states.end(), expired), states.end());
    ASSERT_LE(states.size(), 3U) << i;  // in flight and waiting for the slow one, and not yet given up for the other
  }
  int received = 0;
  for (int last = 0; last != count; ++received) {
    const int number = number_of(client.read());
    ASSERT_GT(number, last);
    last = number;
  }
  EXPECT_LT(received, 30);
}

TEST(ViewerServer, MessagesAreNotLeftOut) {
  auto options = test_options();
  options.max_waiting_messages = 5000;
  Served served(options);
  WebSocketRequest slow;
  slow.receive_buffer = kSmallBuffer;
  WebSocketClient client(served.server.port(), slow);
  served.wait_for("joined 1");
  for (int i = 1; i <= 4000; ++i) {
    served.server.send(1, shared(std::to_string(i)));
    served.server.publish(shared("0"));
  }
  for (int last = 0; last < 4000;) {
    const int number = number_of(client.read());
    if (number == 0) continue;
    ASSERT_EQ(number, last + 1);
    last = number;
  }
}

TEST(ViewerServer, WhoLetsTooMuchWaitIsDisconnected) {
  auto options = test_options();
  options.farewell_timeout = 200ms;
  Served served(options);
  WebSocketRequest slow;
  slow.receive_buffer = kSmallBuffer;
  WebSocketClient stuck(served.server.port(), slow);
  served.wait_for("joined 1");
  WebSocketClient other(served.server.port());
  served.wait_for("joined 2");
  for (int i = 1; i <= 200; ++i) served.server.send(1, shared(large(i)));
  served.wait_for("left 1");
  served.server.send(2, shared("still here"));
  EXPECT_EQ(other.read(), "still here");
  int last = 0;
  for (std::optional<std::string> text = stuck.read(); text; text = stuck.read()) ASSERT_EQ(number_of(text), ++last);
  EXPECT_LT(last, 100);
}

TEST(ViewerServer, ForeignPagesAreRefused) {
  const Served served;
  const auto status = [&](const char* host, std::optional<std::string> origin) {
    WebSocketRequest request;
    request.headers = {{"Host", host}};
    if (origin) request.headers["Origin"] = *origin;
    return WebSocketClient(served.server.port(), request).status();
  };
  EXPECT_EQ(status("127.0.0.1:8700", "http://127.0.0.1:8700"), 101U);
  EXPECT_EQ(status("[::1]:8700", "http://[::1]:8700"), 101U);
  EXPECT_EQ(status("localhost", {}), 101U);
  EXPECT_EQ(status("localhost:8700", "http://localhost:9000"), 403U);
  EXPECT_EQ(status("localhost", "http://evil.example"), 403U);
  EXPECT_EQ(status("localhost", "null"), 403U);
  EXPECT_EQ(status("localhost", ""), 403U);
  EXPECT_EQ(status("evil.example", "http://evil.example"), 403U);  // a name that was made to resolve to this machine
}

TEST(ViewerServer, AsksForTheToken) {
  auto options = test_options();
  options.token = random_token();
  const Served served(options);
  EXPECT_THAT(served.server.address(), HasSubstr("/?token=" + options.token));
  const auto page = [&](const std::string& target) {
    return RawClient(served.server.port()).request("GET", target).status;
  };
  EXPECT_EQ(page("/?token=" + options.token), 200U);
  EXPECT_EQ(page("/"), 401U);
  EXPECT_EQ(page("/?token=" + options.token.substr(1)), 401U);
  EXPECT_EQ(page("/page.js"), 200U);
  const auto live = [&](const std::string& target) {
    WebSocketRequest request;
    request.target = target;
    return WebSocketClient(served.server.port(), request);
  };
  EXPECT_EQ(live("/live?token=" + options.token).status(), 101U);
  EXPECT_EQ(live("/live").status(), 401U);
  const WebSocketClient wrong = live("/live?token=0");
  EXPECT_EQ(wrong.status(), 401U);
  EXPECT_THAT(wrong.refusal(), HasSubstr("asks for a token"));
}

TEST(ViewerServer, HoldsViewersToTheirRules) {
  auto options = test_options();
  options.max_message = 1000;
  Served served(options);
  WebSocketClient good(served.server.port());
  served.wait_for("joined 1");
  const auto code_after = [&](const auto& act) {
    WebSocketClient client(served.server.port());
    act(client);
    return client.read_close();
  };
  EXPECT_EQ(code_after([](WebSocketClient& c) { c.send(std::string(1001, 'x')); }), 1009U);
  EXPECT_EQ(code_after([](WebSocketClient& c) { c.send("\xff\xfe"); }), 1007U);
  EXPECT_EQ(code_after([](WebSocketClient& c) { c.send_binary("x"); }), 1003U);
  EXPECT_EQ(code_after([](WebSocketClient& c) { c.write_raw(std::string("\x81\x01x", 3)); }), 1002U);  // not masked
  served.wait_for("left 5");
  good.send(std::string(1000, 'y'));
  served.wait_for("1: " + std::string(1000, 'y'));
}

TEST(ViewerServer, WhoSaysTooMuchIsDisconnected) {
  auto options = test_options();
  options.max_messages_per_second = 20;
  Served served(options);
  WebSocketClient chatty(served.server.port());
  for (int i = 0; i < 10'000 && chatty.send("x"); ++i) {
  }
  EXPECT_EQ(chatty.read_close(), 1008U);
  EXPECT_THAT(chatty.close_reason(), HasSubstr("too many"));
  WebSocketClient pinging(served.server.port());
  for (int i = 0; i < 10'000 && pinging.ping(); ++i) {
  }
  EXPECT_EQ(pinging.read_close(), 1008U);
  served.wait_for("left 2");
}

TEST(ViewerServer, DisconnectsOneViewer) {
  Served served;
  WebSocketClient first(served.server.port());
  served.wait_for("joined 1");
  WebSocketClient second(served.server.port());
  served.wait_for("joined 2");
  std::string reason(122, 'x');
  served.server.disconnect(1, reason + "ü and more");  // its 123rd byte is half a character
  EXPECT_EQ(first.read_close(), 1008U);
  EXPECT_EQ(first.close_reason(), reason);
  served.wait_for("left 1");
  served.server.publish(shared("state"));
  EXPECT_EQ(second.read(), "state");
}

TEST(ViewerServer, HasPlaceForSoManyViewers) {
  auto options = test_options();
  options.max_viewers = 2;
  Served served(options);
  WebSocketClient first(served.server.port());
  served.wait_for("joined 1");
  const WebSocketClient second(served.server.port());
  served.wait_for("joined 2");
  EXPECT_EQ(WebSocketClient(served.server.port()).status(), 503U);
  first.close();
  served.wait_for("left 1");
  EXPECT_EQ(WebSocketClient(served.server.port()).status(), 101U);
}

TEST(ViewerServer, ACallbackThatThrowsIsCounted) {
  const auto fail = [](auto&&...) { throw std::runtime_error("callback"); };
  Served served(test_options(), {fail, fail, fail});
  WebSocketClient client(served.server.port());
  client.send("a");
  served.wait_for("1: a");
  served.server.publish(shared("state"));
  EXPECT_EQ(client.read(), "state");
  EXPECT_EQ(served.server.callback_failures(), 2U);
}

TEST(ViewerServer, StopSaysSo) {
  Served served;
  WebSocketClient client(served.server.port());
  served.wait_for("joined 1");
  served.server.send(1, shared("before"));
  std::thread stopping([&] { served.server.stop(shared("the end")); });
  EXPECT_EQ(client.read(), "before");
  EXPECT_EQ(client.read(), "the end");
  EXPECT_EQ(client.read_close(), 1001U);
  stopping.join();
  EXPECT_THAT(served.events(), ElementsAre("joined 1", "left 1"));
  EXPECT_EQ(served.server.viewer_count(), 0U);
  EXPECT_THROW(RawClient(served.server.port()), std::runtime_error);
  served.server.stop(shared("again"));
  served.server.publish(shared("to nobody"));
}

TEST(ViewerServer, StopWaitsForNobodyForLong) {
  auto options = test_options();
  options.farewell_timeout = 200ms;
  Served served(options);
  WebSocketRequest slow;
  slow.receive_buffer = kSmallBuffer;
  WebSocketClient stuck(served.server.port(), slow);
  const WebSocketClient silent(served.server.port());
  const RawClient waiting(served.server.port());
  served.wait_for("joined 2");
  for (int i = 1; i <= 50; ++i) served.server.send(1, shared(large(i)));
  served.server.stop(shared("the end"));
  EXPECT_THAT(served.events(), ::testing::IsSupersetOf({"left 1", "left 2"}));
}

TEST(ViewerServer, ACallbackMayStopTheServer) {
  std::atomic<ViewerServer*> server{nullptr};
  Served served(test_options(), {{}, [&](ViewerId, std::string_view) { server.load()->stop(shared("the end")); }, {}});
  server = &served.server;
  WebSocketClient client(served.server.port());
  client.send("stop");
  EXPECT_EQ(client.read(), "the end");
  EXPECT_EQ(client.read_close(), 1001U);
}

TEST(ViewerServer, EndsWithViewersInPlace) {
  auto options = test_options();
  options.farewell_timeout = 200ms;
  std::vector<WebSocketClient> clients;
  {
    Served served(options);
    for (int i = 1; i <= 10; ++i) clients.emplace_back(served.server.port());
    served.wait_for("joined 10");
    served.server.publish(shared("state"));
  }
  for (auto& client : clients) EXPECT_EQ(client.read_close(), 1001U);
}

TEST(ViewerServer, WithoutStartItEndsAsWell) {
  const ViewerServer server(test_options());
  const RawClient waiting(server.port());
  EXPECT_EQ(server.viewer_count(), 0U);
}

TEST(ViewerServer, SaysWhyItCannotServe) {
  const ViewerServer first(test_options());
  const auto serve = [](const std::string& host, std::uint16_t port, const std::string& token = "") {
    return [=] {
      auto options = test_options();
      options.host = host;
      options.port = port;
      options.token = token;
      const ViewerServer server(options);
    };
  };
  EXPECT_THAT(serve("127.0.0.1", first.port()),
              ThrowsMessage<WebServerError>("Port " + std::to_string(first.port()) +
                                            " of 127.0.0.1 is taken: choose another with --port, or 0 for any that is "
                                            "free."));
  EXPECT_THAT(serve("no such host", 0), ThrowsMessage<WebServerError>(HasSubstr("'no such host' is not known")));
  EXPECT_THAT(serve("192.0.2.1", 0), ThrowsMessage<WebServerError>(HasSubstr("no address of this machine")));
  EXPECT_THAT(serve("127.0.0.1", 0, "a b"), ThrowsMessage<WebServerError>(HasSubstr("token")));
}

TEST(ViewerServer, ServesAllAddressesWhereAskedTo) {
  auto options = test_options();
  options.host = "0.0.0.0";
  const Served served(options);
  EXPECT_EQ(RawClient(served.server.port()).request("GET", "/", {{"Host", "192.168.1.5:8700"}}).status, 200U);
  EXPECT_EQ(RawClient(served.server.port()).request("GET", "/", {{"Host", "evil.example"}}).status, 403U);
}

}  // namespace
}  // namespace tegotae
