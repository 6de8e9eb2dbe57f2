// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/math/pose.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <variant>

namespace tegotae {

/// What a page may ask for (docs/live-view.md). Numbers are finite, names short texts without control characters;
/// whether they name anything is for the receiver to say.
namespace viewer_command {

struct Hand {
  Pose X_WT;  ///< the tool's frame, where the hand means it; unit quaternion
};
struct Release {};
struct Set {
  std::string name;
  std::optional<double> value;  ///< not set: the scene's own
};
struct Method {
  std::string name;
};
struct Pause {};
struct Resume {};
struct Step {};
struct Reset {};
struct Motion {
  std::string name;
};
struct Stop {};
struct SceneChoice {
  std::string name;
};
struct ExperimentChoice {
  std::string name;
};
struct Record {
  bool on = false;
};
struct Seek {
  double time = 0.0;  ///< s
};
struct Play {
  double speed = 1.0;  ///< 0.01 to 100 times as fast as it was
};

}  // namespace viewer_command

using ViewerCommand =
    std::variant<viewer_command::Hand, viewer_command::Release, viewer_command::Set, viewer_command::Method,
                 viewer_command::Pause, viewer_command::Resume, viewer_command::Step, viewer_command::Reset,
                 viewer_command::Motion, viewer_command::Stop, viewer_command::SceneChoice,
                 viewer_command::ExperimentChoice, viewer_command::Record, viewer_command::Seek, viewer_command::Play>;

/// A page's message, understood or refused.
struct ParsedCommand {
  std::optional<ViewerCommand> command;
  std::string error;  ///< where there is no command: one sentence for the page
};

/// Understands one message of a page: a JSON object with a `type` and exactly the members of that type. Whatever the
/// bytes are, it does not throw (but for want of memory), and takes time linear in their number.
ParsedCommand parse_viewer_command(std::string_view message);

}  // namespace tegotae
