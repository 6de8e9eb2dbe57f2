// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/device/trajectory.hpp>

#include <filesystem>
#include <istream>
#include <string>

namespace tegotae {

/// Reads a motion of the tool's frame from a recording (RecordingFile: where the hand held the tool) or from
/// comma-separated text. The first line that is neither blank nor a comment
/// (`#`) names the columns: `t` (s, ascending strictly), `x`, `y`, `z` (m), `qw`, `qx`, `qy`, `qz` (quaternion of norm
/// 1 within 1e-3, which is then normalised), in any order; others are ignored. Throws InputError, naming file, line and
/// column, for a file that cannot be read, a column that is missing or doubled, a value that is missing, not a number
/// or not finite, a quaternion that is none, a time that does not ascend, and for a file without samples;
/// RecordingError for a recording that is damaged.
Trajectory read_trajectory(const std::filesystem::path& file);

/// The same from a stream; `name` stands for the file in messages.
Trajectory read_trajectory(std::istream& text, const std::string& name);

}  // namespace tegotae
