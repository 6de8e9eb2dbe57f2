// SPDX-License-Identifier: Apache-2.0
#include <tegotae/device/openhaptics_library.hpp>

namespace tegotae {
namespace {

template <class Function>
void require(const VendorLibrary& library, const char* symbol, Function*& function) {
  function = library.function<Function>(symbol);
}

}  // namespace

VendorLibrary OpenHapticsLibrary::find() {
  return VendorLibrary({"openhaptics",
                        "OpenHaptics (its HD API)",
                        {"libHD.so", "libHD.so.3.4", "libHD.so.3.0"},
                        "",
                        "Install OpenHaptics for Linux and the driver of the device from 3D Systems, set GTDD_HOME as "
                        "they say, and put the folder of libHD.so into LD_LIBRARY_PATH."});
}

OpenHapticsLibrary::OpenHapticsLibrary(const VendorLibrary& library) {
  require(library, "hdInitDevice", init_device);
  require(library, "hdDisableDevice", disable_device);
  require(library, "hdMakeCurrentDevice", make_current_device);
  require(library, "hdBeginFrame", begin_frame);
  require(library, "hdEndFrame", end_frame);
  require(library, "hdEnable", enable);
  require(library, "hdDisable", disable);
  require(library, "hdGetDoublev", get_doubles);
  require(library, "hdSetDoublev", set_doubles);
  require(library, "hdGetIntegerv", get_integers);
  require(library, "hdGetString", get_string);
  require(library, "hdGetError", get_error);
  require(library, "hdCheckCalibration", check_calibration);
  require(library, "hdUpdateCalibration", update_calibration);
  require(library, "hdScheduleAsynchronous", schedule_asynchronous);
  require(library, "hdUnschedule", unschedule);
  require(library, "hdStartScheduler", start_scheduler);
  require(library, "hdStopScheduler", stop_scheduler);
}

}  // namespace tegotae
