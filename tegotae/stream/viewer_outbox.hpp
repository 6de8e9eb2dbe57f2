// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/stream/viewer_options.hpp>

#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <variant>

namespace tegotae {

/// Status codes of a WebSocket's close that are used here (RFC 6455, 7.4.1).
enum class CloseCode : std::uint16_t { kGoingAway = 1001, kUnknownData = 1003, kPolicy = 1008 };

struct CloseOrder {
  CloseCode code;
  std::string reason;
};

/// What waits for one viewer, in the order in which it was given. Of states, only the newest waits.
class ViewerOutbox {
 public:
  using Next = std::variant<std::monostate, SharedText, CloseOrder>;

  ViewerOutbox(std::size_t max_messages, std::size_t max_bytes) : max_messages_(max_messages), max_bytes_(max_bytes) {}

  /// Takes the place of the state that waits, if any, and stands last.
  void publish(SharedText state);

  /// False: too much waits, and the message was not taken. What counts is what waits before it, so that a single
  /// message may be of any size.
  [[nodiscard]] bool send(SharedText message);

  /// Nothing is taken from here on, and what waits is dropped.
  void close(CloseOrder order);

  /// Nothing is taken from here on; what waits goes first, then `last` (null: none), whatever the limits.
  void finish(SharedText last, CloseOrder order);

  bool closing() const noexcept { return close_.has_value(); }
  std::size_t waiting_bytes() const noexcept { return bytes_; }  ///< of messages

  /// What goes next, taken out; nothing where nothing waits. A close order stays.
  Next next();

 private:
  struct Item {
    SharedText text;
    bool is_state;
  };

  void drop_state();

  std::size_t max_messages_, max_bytes_;
  std::deque<Item> items_;
  std::size_t messages_ = 0, bytes_ = 0;  ///< of items_ that are no states
  std::optional<CloseOrder> close_;
};

}  // namespace tegotae
