// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string_view>

/// The parts of the MCAP container, version 0 (https://mcap.dev/spec), that recordings use: no chunks, so that each
/// record that was written whole can be read, wherever the file ends.
namespace tegotae::mcap {

inline constexpr std::string_view kMagic{"\x89MCAP0\r\n", 8};

/// Kinds of records. Each stands as its kind (1 byte), the length of its content (8 bytes) and the content; numbers are
/// little-endian, texts have their length (4 bytes) before them.
enum class Opcode : std::uint8_t {
  kHeader = 0x01,
  kFooter = 0x02,
  kSchema = 0x03,
  kChannel = 0x04,
  kMessage = 0x05,
  kStatistics = 0x0B,
  kDataEnd = 0x0F,
};

}  // namespace tegotae::mcap
