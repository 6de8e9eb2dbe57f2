// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/lab/live_inbox.hpp>
#include <tegotae/lab/replay_session.hpp>
#include <tegotae/lab/viewer_output.hpp>

#include <atomic>
#include <filesystem>
#include <map>
#include <string>

namespace tegotae {

/// A recording for the pages that look at it: shows them what holds and obeys what they ask. Its time stands still
/// while nobody looks.
class ReplayView {
 public:
  /// Throws RecordingError where the file cannot be read or holds nothing to show.
  ReplayView(const std::filesystem::path& file, ViewerOutput output);

  /// What the server is told. Any thread.
  LiveInbox& inbox() noexcept { return inbox_; }

  const ReplaySession& session() const noexcept { return session_; }

  /// Empty, or a sentence on what is missing from the recording.
  const std::string& warning() const noexcept { return warning_; }

  /// Shows 60 states a second until `stop` becomes true. Throws RecordingError where the file can no longer be read.
  void run(const std::atomic<bool>& stop);

  /// One round: does what was asked since the last one, lets `elapsed` (s) go by, and shows what holds then.
  void pass(double elapsed);

 private:
  void handle(const LiveInbox::Event& event);
  void greet(ViewerId viewer);
  void refuse(ViewerId viewer, const std::string& why);
  void show();

  ReplaySession session_;
  ViewerOutput output_;
  LiveInbox inbox_;
  std::string warning_;
  int told_scene_, told_settings_;     ///< numbers of those that all viewers know
  std::map<ViewerId, int> malformed_;  ///< messages of each viewer that were no commands
};

}  // namespace tegotae
