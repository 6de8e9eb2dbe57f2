// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace tegotae {

enum class NoticeLevel : std::uint8_t { kInfo, kWarning, kError };

// Messages of the live view that say one thing (docs/live-view.md).

/// `welcome`: tells a viewer its number.
std::string encode_welcome(std::uint64_t viewer);
/// `notice`: one sentence for people.
std::string encode_notice(NoticeLevel level, std::string_view text);
/// `end`: why the program closes the connection.
std::string encode_end(std::string_view text);

}  // namespace tegotae
