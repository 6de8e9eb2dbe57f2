// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/device/spidar_transport.h>
#include <tegotae/device/vendor_library.hpp>

#include <string>

namespace tegotae {

/// Functions of the library that speaks to a SPIDAR's board, as spidar_transport.h declares them.
struct SpidarBoardLibrary {
  /// `file` as the dynamic loader takes it: with a slash that file, else a name that it searches for.
  static VendorLibrary find(const std::string& file);
  /// Throws InterfaceError where `library` is not loaded, lacks a function or was made for another version.
  explicit SpidarBoardLibrary(const VendorLibrary& library);

  /// Why the last call failed, in the library's words.
  std::string why() const;

  std::string file;
  int sharing = TEGOTAE_SPIDAR_NEVER;
  decltype(&tegotae_spidar_open) open = nullptr;
  decltype(&tegotae_spidar_strings) strings = nullptr;
  decltype(&tegotae_spidar_reset) reset = nullptr;
  decltype(&tegotae_spidar_read) read = nullptr;
  decltype(&tegotae_spidar_write) write = nullptr;
  decltype(&tegotae_spidar_stop) stop = nullptr;
  decltype(&tegotae_spidar_close) close = nullptr;
  decltype(&tegotae_spidar_error) error = nullptr;
};

}  // namespace tegotae
