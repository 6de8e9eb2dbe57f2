// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace tegotae {

struct ChildResult {
  bool not_found = false;  ///< there is no such program on PATH
  int exit_code = 0;       ///< 128 and more: ended by a signal
};

/// Runs the program `command[0]` with its arguments in `folder`, without input, its output thrown away, and waits for
/// its end. No shell takes part.
ChildResult run_child(const std::vector<std::string>& command, const std::filesystem::path& folder);

}  // namespace tegotae
