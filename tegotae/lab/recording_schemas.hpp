// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/lab/samples_file.hpp>

#include <string>
#include <string_view>

namespace tegotae {

/// One kind of messages in a recording.
struct RecordingTopic {
  std::string_view topic, schema;
};

// The kinds, by the version of the recording's format that docs/recordings.md describes. A schema's name changes its
// version where a reader of the version before would misread a message.

inline constexpr RecordingTopic kSessionTopic{"/tegotae/session", "tegotae.Session.v1"};
inline constexpr RecordingTopic kSceneTopic{"/tegotae/scene", "tegotae.Scene.v1"};
inline constexpr RecordingTopic kSettingsTopic{"/tegotae/settings", "tegotae.Settings.v1"};
inline constexpr RecordingTopic kStateTopic{"/tegotae/state", "tegotae.State.v1"};
inline constexpr RecordingTopic kTickTopic{"/tegotae/tick", "tegotae.Tick.v1"};

/// The JSON schemas that stand in the file, with units. They declare what Foxglove can plot: one type a member, no
/// arrays in arrays (its reader refuses a channel for those); the rest stands in the description.
std::string_view schema_of_session() noexcept;
std::string_view schema_of_scene() noexcept;
std::string_view schema_of_settings() noexcept;
std::string_view schema_of_state() noexcept;
/// Of ticks, whose members are the columns of a samples file.
std::string schema_of_tick(SampleKind kind = SampleKind::kPlayed);

}  // namespace tegotae
