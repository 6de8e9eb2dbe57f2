// SPDX-License-Identifier: Apache-2.0
#include <tegotae/device/interface_driver.hpp>
#include <tegotae/device/virtuose_library.hpp>

namespace tegotae {
namespace {

template <class Function>
void require(const VendorLibrary& library, const char* symbol, Function*& function) {
  function = library.function<Function>(symbol);
}

}  // namespace

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
  require(library, "virtOpen", open);
  require(library, "virtClose", close);
  require(library, "virtGetErrorCode", error_code);
  require(library, "virtGetErrorMessage", error_message);
  require(library, "virtSetIndexingMode", set_indexing_mode);
  require(library, "virtSetForceFactor", set_force_factor);
  require(library, "virtSetSpeedFactor", set_speed_factor);
  require(library, "virtSetTimeStep", set_time_step);
  require(library, "virtSetBaseFrame", set_base_frame);
  require(library, "virtSetObservationFrame", set_observation_frame);
  require(library, "virtSetCommandType", set_command_type);
  require(library, "virtSaturateTorque", saturate);
  require(library, "virtEnableForceFeedback", enable_force_feedback);
  require(library, "virtSetPowerOn", set_power);
  require(library, "virtGetPowerOn", get_power);
  require(library, "virtGetEmergencyStop", get_emergency_stop);
  require(library, "virtGetButton", get_button);
  require(library, "virtGetPosition", get_pose);
  require(library, "virtGetSpeed", get_speed);
  require(library, "virtSetForce", set_force);
}

std::string VirtuoseLibrary::error(void* context) const {
  const char* text = error_message(error_code(context));
  return text != nullptr && *text != '\0' ? text : "the API does not say why";
}

}  // namespace tegotae
