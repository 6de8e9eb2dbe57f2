// SPDX-License-Identifier: Apache-2.0
#include <tegotae/stream/viewer_hub.hpp>

#include <utility>

namespace tegotae {

bool ViewerHub::rouse(Viewer& viewer) { return !std::exchange(viewer.awake, true); }

// Always wakes: a text may be in flight to a viewer that does not read, and its time to do so begins now.
bool ViewerHub::order_close(Viewer& viewer, CloseCode code, std::string reason) {
  if (viewer.outbox.closing()) return false;
  viewer.outbox.close({code, std::move(reason)});
  viewer.awake = true;
  return true;
}

bool ViewerHub::give(Viewer& viewer, SharedText message) {
  if (viewer.outbox.send(std::move(message))) return rouse(viewer);
  return order_close(viewer, CloseCode::kPolicy, "too slow: too much waits to be read");
}

void ViewerHub::publish(const SharedText& state) {
  std::vector<ViewerId> woken;
  {
    const std::lock_guard lock(mutex_);
    for (auto& [id, viewer] : viewers_) {
      if (!reached(viewer)) continue;
      viewer.outbox.publish(state);
      if (rouse(viewer)) woken.push_back(id);
    }
  }
  if (!woken.empty()) wake_(woken);
}

void ViewerHub::send(ViewerId viewer, SharedText message) {
  {
    const std::lock_guard lock(mutex_);
    const auto found = viewers_.find(viewer);
    if (found == viewers_.end()) return;
    found->second.greeted = true;
    if (!give(found->second, std::move(message))) return;
  }
  wake_({viewer});
}

void ViewerHub::send_all(const SharedText& message) {
  std::vector<ViewerId> woken;
  {
    const std::lock_guard lock(mutex_);
    for (auto& [id, viewer] : viewers_) {
      if (reached(viewer) && give(viewer, message)) woken.push_back(id);
    }
  }
  if (!woken.empty()) wake_(woken);
}

void ViewerHub::close(ViewerId viewer, CloseCode code, std::string reason) {
  {
    const std::lock_guard lock(mutex_);
    const auto found = viewers_.find(viewer);
    if (found == viewers_.end() || !order_close(found->second, code, std::move(reason))) return;
  }
  wake_({viewer});
}

void ViewerHub::finish(const SharedText& last) {
  std::vector<ViewerId> woken;
  {
    const std::lock_guard lock(mutex_);
    if (std::exchange(finished_, true)) return;
    for (auto& [id, viewer] : viewers_) {
      viewer.outbox.finish(last, {CloseCode::kGoingAway, "the server ends"});
      viewer.awake = true;
      woken.push_back(id);
    }
  }
  if (!woken.empty()) wake_(woken);
}

std::size_t ViewerHub::count() const {
  const std::lock_guard lock(mutex_);
  return viewers_.size();
}

bool ViewerHub::full() const {
  const std::lock_guard lock(mutex_);
  return viewers_.size() >= static_cast<std::size_t>(options_.max_viewers);
}

std::optional<ViewerId> ViewerHub::enter() {
  const std::lock_guard lock(mutex_);
  if (finished_ || viewers_.size() >= static_cast<std::size_t>(options_.max_viewers)) return {};
  const ViewerId id = ++last_viewer_;
  viewers_.emplace(id, Viewer{ViewerOutbox(options_.max_waiting_messages, options_.max_waiting_bytes)});
  return id;
}

template <class Callback>
void ViewerHub::guarded(const Callback& callback) noexcept {
  try {
    callback();
  } catch (...) {
    failures_.fetch_add(1, std::memory_order_relaxed);
  }
}

void ViewerHub::joined(ViewerId viewer) {
  guarded([&] {
    if (events_.joined) events_.joined(viewer);
  });
}

void ViewerHub::received(ViewerId viewer, std::string_view message) {
  guarded([&] {
    if (events_.received) events_.received(viewer, message);
  });
}

void ViewerHub::left(ViewerId viewer) {
  {
    const std::lock_guard lock(mutex_);
    viewers_.erase(viewer);
  }
  guarded([&] {
    if (events_.left) events_.left(viewer);
  });
}

ViewerOutbox::Next ViewerHub::next(ViewerId viewer) {
  const std::lock_guard lock(mutex_);
  const auto found = viewers_.find(viewer);
  if (found == viewers_.end()) return {};
  ViewerOutbox::Next next = found->second.outbox.next();
  if (std::holds_alternative<std::monostate>(next)) found->second.awake = false;
  return next;
}

bool ViewerHub::closing(ViewerId viewer) const {
  const std::lock_guard lock(mutex_);
  const auto found = viewers_.find(viewer);
  return found == viewers_.end() || found->second.outbox.closing();
}

}  // namespace tegotae
