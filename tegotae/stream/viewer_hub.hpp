// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/stream/viewer_options.hpp>
#include <tegotae/stream/viewer_outbox.hpp>

#include <atomic>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tegotae {

/// The viewers of a server and what waits for each: where the threads that give texts and the server's thread, which
/// sends them, meet. Knows no socket. Functions of the first group may be called from any thread.
class ViewerHub {
 public:
  /// Told, on the giving thread, for which viewers something waits since they last had nothing. Must not block.
  using Wake = std::function<void(const std::vector<ViewerId>&)>;

  ViewerHub(const ViewerServerOptions& options, Wake wake) : options_(options), wake_(std::move(wake)) {}

  void publish(const SharedText& state);
  void send(ViewerId viewer, SharedText message);
  void send_all(const SharedText& message);
  void close(ViewerId viewer, CloseCode code, std::string reason);
  /// Sends all that waits and `last` to every viewer, then closes; nobody joins any more. Only the first call counts.
  void finish(const SharedText& last);
  std::size_t count() const;
  bool full() const;  ///< no more viewers are taken in
  std::uint64_t callback_failures() const noexcept { return failures_.load(std::memory_order_relaxed); }

  /// Before any of the next group.
  void set_events(ViewerServerEvents events) { events_ = std::move(events); }

  /// Of the server's thread alone: a viewer comes (none where there is no place), has said something, is gone.
  std::optional<ViewerId> enter();
  void joined(ViewerId viewer);
  void received(ViewerId viewer, std::string_view message);
  void left(ViewerId viewer);
  /// What goes next; where it is nothing, the viewer is woken when there is something.
  ViewerOutbox::Next next(ViewerId viewer);
  bool closing(ViewerId viewer) const;

 private:
  struct Viewer {
    ViewerOutbox outbox;
    bool awake = false;    ///< the server's thread is at it or has been told
    bool greeted = false;  ///< was sent something
  };

  // With mutex_ held: sends, or orders the close where too much waits. Whether to wake the server's thread.
  bool give(Viewer& viewer, SharedText message);
  static bool order_close(Viewer& viewer, CloseCode code, std::string reason);
  static bool rouse(Viewer& viewer);
  bool reached(const Viewer& viewer) const { return viewer.greeted || !options_.greeting_first; }
  template <class Callback>
  void guarded(const Callback& callback) noexcept;

  const ViewerServerOptions& options_;
  Wake wake_;
  ViewerServerEvents events_;
  mutable std::mutex mutex_;
  std::map<ViewerId, Viewer> viewers_;
  ViewerId last_viewer_ = 0;
  bool finished_ = false;
  std::atomic<std::uint64_t> failures_{0};
};

}  // namespace tegotae
