// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/replay_view.hpp>

#include <tegotae/lab/unix_time.hpp>
#include <tegotae/stream/short_messages.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <thread>
#include <utility>
#include <variant>

namespace tegotae {
namespace {

using Clock = std::chrono::steady_clock;

// A page of ours sends none; a person who tries something by hand sends a few.
constexpr int kMostMalformed = 50;

std::string warning_of(const ReplaySession& session, const std::filesystem::path& file) {
  if (session.is_complete()) return {};
  return fmt::format("{}: the recording was cut; what was whole is shown, up to {:.3f} s.", file.string(),
                     session.duration());
}

}  // namespace

ReplayView::ReplayView(const std::filesystem::path& file, ViewerOutput output)
    : session_(file),
      output_(std::move(output)),
      warning_(warning_of(session_, file)),
      told_scene_(session_.scene_number()),
      told_settings_(session_.settings_number()) {}

void ReplayView::run(const std::atomic<bool>& stop) {
  Clock::time_point last = Clock::now(), next = last;
  while (!stop) {
    const Clock::time_point now = Clock::now();
    pass(std::chrono::duration<double>(now - std::exchange(last, now)).count());
    next = std::max(next + kStatePeriod, now);
    std::this_thread::sleep_until(next);
  }
}

void ReplayView::pass(double elapsed) {
  for (const LiveInbox::Event& event : inbox_.take()) handle(event);
  if (output_.viewer_count() == 0) return;
  session_.advance(elapsed);
  show();
}

void ReplayView::handle(const LiveInbox::Event& event) {
  if (std::holds_alternative<LiveInbox::Joined>(event.what)) greet(event.viewer);
  if (std::holds_alternative<LiveInbox::Left>(event.what)) malformed_.erase(event.viewer);
  if (const auto* refused = std::get_if<LiveInbox::Refused>(&event.what)) {
    refuse(event.viewer, refused->why);
    if (++malformed_[event.viewer] > kMostMalformed) output_.disconnect(event.viewer, "too many malformed messages");
  }
  if (const auto* command = std::get_if<ViewerCommand>(&event.what)) {
    const std::string why_not = session_.obey(*command);
    if (!why_not.empty()) refuse(event.viewer, why_not);
  }
}

void ReplayView::greet(ViewerId viewer) {
  output_.send(viewer, shared(encode_welcome(viewer)));
  output_.send(viewer, shared(session_.scene_message()));
  const std::string settings = session_.settings_message();
  if (!settings.empty()) output_.send(viewer, shared(settings));
  if (!warning_.empty()) output_.send(viewer, shared(encode_notice(NoticeLevel::kWarning, warning_)));
}

void ReplayView::refuse(ViewerId viewer, const std::string& why) {
  output_.send(viewer, shared(encode_notice(NoticeLevel::kError, why)));
}

void ReplayView::show() {
  if (std::exchange(told_scene_, session_.scene_number()) != session_.scene_number()) {
    output_.send_all(shared(session_.scene_message()));
  }
  if (std::exchange(told_settings_, session_.settings_number()) != session_.settings_number()) {
    const std::string settings = session_.settings_message();
    if (!settings.empty()) output_.send_all(shared(settings));
  }
  output_.publish(shared(session_.state_message(static_cast<int>(output_.viewer_count()), unix_milliseconds())));
}

}  // namespace tegotae
