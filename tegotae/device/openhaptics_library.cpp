// SPDX-License-Identifier: Apache-2.0
#include <tegotae/device/openhaptics_library.hpp>

namespace tegotae {
VendorLibrary OpenHapticsLibrary::find() {
  return VendorLibrary({"openhaptics",
                        "OpenHaptics (its HD API)",
                        {"libHD.so", "libHD.so.3.4", "libHD.so.3.0"},
                        "",
                        "Install OpenHaptics for Linux and the driver of the device from 3D Systems, set GTDD_HOME as "
                        "they say, and put the folder of libHD.so into LD_LIBRARY_PATH."});
}

OpenHapticsLibrary::OpenHapticsLibrary(const VendorLibrary& library) {
  library.require("hdInitDevice", init_device);
  library.require("hdDisableDevice", disable_device);
  library.require("hdMakeCurrentDevice", make_current_device);
  library.require("hdBeginFrame", begin_frame);
  library.require("hdEndFrame", end_frame);
  library.require("hdEnable", enable);
  library.require("hdDisable", disable);
  library.require("hdGetDoublev", get_doubles);
  library.require("hdSetDoublev", set_doubles);
  library.require("hdGetIntegerv", get_integers);
  library.require("hdGetString", get_string);
  library.require("hdGetError", get_error);
  library.require("hdCheckCalibration", check_calibration);
  library.require("hdUpdateCalibration", update_calibration);
  library.require("hdScheduleAsynchronous", schedule_asynchronous);
  library.require("hdUnschedule", unschedule);
  library.require("hdStartScheduler", start_scheduler);
  library.require("hdStopScheduler", stop_scheduler);
}

}  // namespace tegotae
