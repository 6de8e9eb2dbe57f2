// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string_view>

namespace tegotae {

/// Creates or replaces `file` with `text`. Throws InputError, naming it, where it cannot be written to its end.
void write_text(const std::filesystem::path& file, std::string_view text);

/// Throws InputError that names the cause where `file` is a folder, or lies in none that is there.
void check_writable_place(const std::filesystem::path& file);

/// Creates the folder, and those above it, where it is not there yet. Throws InputError where it cannot.
void make_folder(const std::filesystem::path& folder);

}  // namespace tegotae
