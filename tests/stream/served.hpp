// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/stream/viewer_server.hpp>

#include <chrono>
#include <condition_variable>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <string>
#include <vector>

namespace tegotae::test {

inline SharedText shared(std::string text) { return std::make_shared<const std::string>(std::move(text)); }

/// Options of a server for tests: any port, a page and a script, no wait for a greeting.
inline ViewerServerOptions test_options() {
  ViewerServerOptions options;
  options.port = 0;
  options.greeting_first = false;
  options.max_messages_per_second = 1'000'000;
  options.assets = {{"/", "text/html; charset=utf-8", "<!doctype html><title>t</title>"},
                    {"/page.js", "text/javascript; charset=utf-8", "'use strict';"}};
  return options;
}

/// A server that keeps what happens to it.
class Served {
 public:
  explicit Served(const ViewerServerOptions& options = test_options(), ViewerServerEvents also = {})
      : also_(std::move(also)), server(options) {
    server.start({[this](ViewerId id) { note("joined " + std::to_string(id), [&] { call(also_.joined, id); }); },
                  [this](ViewerId id, std::string_view text) {
                    note(std::to_string(id) + ": " + std::string(text), [&] { call(also_.received, id, text); });
                  },
                  [this](ViewerId id) { note("left " + std::to_string(id), [&] { call(also_.left, id); }); }});
  }

  /// Waits until `event` has happened so many times; throws where it does not within a minute.
  void wait_for(const std::string& event, int times = 1) {
    std::unique_lock lock(mutex_);
    if (!changed_.wait_for(lock, std::chrono::seconds(60), [&] { return counts_[event] >= times; })) {
      throw std::runtime_error("has not happened: " + event);
    }
  }

  std::vector<std::string> events() {
    const std::lock_guard lock(mutex_);
    return events_;
  }

 private:
  template <class Callback, class... Arguments>
  static void call(const Callback& callback, Arguments... arguments) {
    if (callback) callback(arguments...);
  }

  template <class Then>
  void note(const std::string& event, const Then& then) {
    {
      const std::lock_guard lock(mutex_);
      events_.push_back(event);
      ++counts_[event];
    }
    changed_.notify_all();
    then();
  }

  ViewerServerEvents also_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<std::string> events_;
  std::map<std::string, int> counts_;

 public:
  ViewerServer server;  ///< last: ends before what its callbacks use
};

}  // namespace tegotae::test
