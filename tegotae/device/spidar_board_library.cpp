// SPDX-License-Identifier: Apache-2.0
#include <tegotae/device/spidar_board_library.hpp>

#include <tegotae/device/interface_driver.hpp>

namespace tegotae {

VendorLibrary SpidarBoardLibrary::find(const std::string& file) {
  return VendorLibrary({"spidar-g6",
                        "the transport to the SPIDAR's board",
                        {file},
                        "",
                        "Give the path of the library that speaks to your board: transport=/path/libmyboard.so "
                        "(docs/spidar.md)."});
}

SpidarBoardLibrary::SpidarBoardLibrary(const VendorLibrary& library) {
  // The version first: what it says, or that it cannot be asked, tells more than any other missing function.
  const auto version = library.function<int()>("tegotae_spidar_version");
  file = library.file();
  const int found = version();
  if (found != TEGOTAE_SPIDAR_VERSION) {
    throw InterfaceError("spidar-g6: " + file + " was made for version " + std::to_string(found) +
                         " of spidar_transport.h, and this program speaks version " +
                         std::to_string(TEGOTAE_SPIDAR_VERSION) + "; compile it anew with this program's header.");
  }
  library.require("tegotae_spidar_open", open);
  library.require("tegotae_spidar_strings", strings);
  library.require("tegotae_spidar_reset", reset);
  library.require("tegotae_spidar_read", read);
  library.require("tegotae_spidar_write", write);
  library.require("tegotae_spidar_stop", stop);
  library.require("tegotae_spidar_close", close);
  library.require("tegotae_spidar_error", error);
  sharing = library.function<int()>("tegotae_spidar_sharing")();
  if (sharing < TEGOTAE_SPIDAR_NEVER || sharing > TEGOTAE_SPIDAR_ANY_TIME) {
    throw InterfaceError("spidar-g6: tegotae_spidar_sharing of " + file + " answers " + std::to_string(sharing) +
                         ", which is none of the three values of spidar_transport.h; mend the library.");
  }
}

std::string SpidarBoardLibrary::why() const {
  const char* text = error();
  return text != nullptr && *text != '\0' ? text : "the library does not say why";
}

}  // namespace tegotae
