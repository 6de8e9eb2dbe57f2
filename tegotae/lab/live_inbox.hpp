// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/stream/viewer_command.hpp>
#include <tegotae/stream/viewer_options.hpp>

#include <cstddef>
#include <mutex>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace tegotae {

/// What viewers did and said, from the server's thread to the one that serves them. Bounded: of a viewer's poses of the
/// hand only the newest waits, and where too much waits the rest is lost.
class LiveInbox {
 public:
  struct Joined {};
  struct Left {};
  struct Refused {
    std::string why;  ///< a sentence
  };
  struct Event {
    ViewerId viewer = 0;
    std::variant<Joined, Left, Refused, ViewerCommand> what;
  };

  void joined(ViewerId viewer) { add({viewer, Joined{}}); }
  void left(ViewerId viewer) { add({viewer, Left{}}); }
  /// Understands the message; one that is no command becomes a refusal.
  void received(ViewerId viewer, std::string_view message);

  /// All that came since the last call, in its order.
  std::vector<Event> take();

 private:
  static constexpr std::size_t kMostWaiting = 1024;

  void add(Event event);

  std::mutex mutex_;
  std::vector<Event> waiting_;
};

}  // namespace tegotae
