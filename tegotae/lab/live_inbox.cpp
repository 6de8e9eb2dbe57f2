// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/live_inbox.hpp>

#include <utility>

namespace tegotae {
namespace {

const viewer_command::Hand* pose_of(const LiveInbox::Event& event) {
  const auto* command = std::get_if<ViewerCommand>(&event.what);
  return command != nullptr ? std::get_if<viewer_command::Hand>(command) : nullptr;
}

}  // namespace

void LiveInbox::received(ViewerId viewer, std::string_view message) {
  ParsedCommand parsed = parse_viewer_command(message);
  if (parsed.command) {
    add({viewer, std::move(*parsed.command)});
  } else {
    add({viewer, Refused{std::move(parsed.error)}});
  }
}

std::vector<LiveInbox::Event> LiveInbox::take() {
  const std::lock_guard lock(mutex_);
  return std::exchange(waiting_, {});
}

// Who comes and goes is never lost: there are at most as many as connections.
void LiveInbox::add(Event event) {
  const std::lock_guard lock(mutex_);
  if (!waiting_.empty() && waiting_.back().viewer == event.viewer && pose_of(waiting_.back()) != nullptr &&
      pose_of(event) != nullptr) {
    waiting_.back() = std::move(event);
    return;
  }
  const bool may_be_lost = !std::holds_alternative<Joined>(event.what) && !std::holds_alternative<Left>(event.what);
  if (may_be_lost && waiting_.size() >= kMostWaiting) return;
  waiting_.push_back(std::move(event));
}

}  // namespace tegotae
