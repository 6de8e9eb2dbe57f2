// SPDX-License-Identifier: Apache-2.0
#include <tegotae/device/virtuose_library.hpp>

#include <tegotae/device/interface_driver.hpp>

namespace tegotae {

VendorLibrary VirtuoseLibrary::find() {
  return VendorLibrary({"virtuose",
                        "the Virtuose API",
                        {"virtuoseAPI.so"},
                        "",
                        "Install version 4 of it from Haption and put its folder into LD_LIBRARY_PATH, or into "
                        "/etc/ld.so.conf.d and run ldconfig."});
}

VirtuoseLibrary::VirtuoseLibrary(const VendorLibrary& library) {
  // The version first: what it says, or that it cannot be asked, tells more than any other missing function.
  const auto version = library.function<int(int*, int*)>("virtAPIVersion");
  file = library.file();
  int major = 0;
  if (version(&major, &minor_version) != 0 || major != kVersion) {
    throw InterfaceError("virtuose: " + file + " calls itself version " + std::to_string(major) + "." +
                         std::to_string(minor_version) +
                         " of the Virtuose API, and only version 4 is known here; install that from Haption.");
  }
  library.require("virtOpen", open);
  library.require("virtClose", close);
  library.require("virtGetErrorCode", error_code);
  library.require("virtGetErrorMessage", error_message);
  library.require("virtSetIndexingMode", set_indexing_mode);
  library.require("virtSetForceFactor", set_force_factor);
  library.require("virtSetSpeedFactor", set_speed_factor);
  library.require("virtSetTimeStep", set_time_step);
  library.require("virtSetBaseFrame", set_base_frame);
  library.require("virtSetObservationFrame", set_observation_frame);
  library.require("virtSetCommandType", set_command_type);
  library.require("virtSaturateTorque", saturate);
  library.require("virtEnableForceFeedback", enable_force_feedback);
  library.require("virtSetPowerOn", set_power);
  library.require("virtGetPowerOn", get_power);
  library.require("virtGetEmergencyStop", get_emergency_stop);
  library.look_for("virtIsInShiftPosition", is_shifting);
  library.require("virtGetButton", get_button);
  library.require("virtGetPosition", get_pose);
  library.require("virtGetSpeed", get_speed);
  library.require("virtSetForce", set_force);
}

std::string VirtuoseLibrary::error(void* context) const {
  const char* text = error_message(error_code(context));
  return text != nullptr && *text != '\0' ? text : "the API does not say why";
}

}  // namespace tegotae
