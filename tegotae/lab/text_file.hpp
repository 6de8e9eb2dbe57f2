// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string_view>

namespace tegotae {

/// Creates or replaces `file` with `text`. Throws InputError, naming it, where it cannot be written to its end.
void write_text(const std::filesystem::path& file, std::string_view text);

/// Creates the folder, and those above it, where it is not there yet. Throws InputError where it cannot.
void make_folder(const std::filesystem::path& folder);

}  // namespace tegotae
