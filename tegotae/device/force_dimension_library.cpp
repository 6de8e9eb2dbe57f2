// SPDX-License-Identifier: Apache-2.0
#include <tegotae/device/force_dimension_library.hpp>

namespace tegotae {

VendorLibrary ForceDimensionLibrary::find() {
  return VendorLibrary({"force-dimension",
                        "the Force Dimension SDK",
                        {"libdrd.so", "libdrd.so.3", "libdhd.so", "libdhd.so.3"},
                        "",
                        "Install it from forcedimension.com and put the folder of its libraries into LD_LIBRARY_PATH, "
                        "or into /etc/ld.so.conf.d and run ldconfig."});
}

ForceDimensionLibrary::ForceDimensionLibrary(const VendorLibrary& library) {
  library.require("dhdGetDeviceCount", device_count);
  file = library.file();
  if (library.optional_function<int()>("drdOpen") != nullptr) {
    library.require("drdOpen", drd_open);
    library.require("drdOpenID", drd_open_id);
    library.look_for("drdClose", drd_close);
    library.require("drdIsInitialized", drd_is_initialized);
    library.require("drdAutoInit", drd_auto_init);
    library.require("drdStop", drd_stop);
  }
  library.require("dhdOpen", open);
  library.require("dhdOpenID", open_id);
  library.require("dhdClose", close);
  library.look_for("dhdStop", stop);
  library.require("dhdErrorGetLastStr", last_error);
  library.require("dhdGetSystemName", system_name);
  library.look_for("dhdGetSerialNumber", serial_number);
  library.require("dhdHasWrist", has_wrist);
  library.require("dhdHasActiveWrist", has_active_wrist);
  library.require("dhdHasGripper", has_gripper);
  library.require("dhdIsLeftHanded", is_left_handed);
  library.require("dhdEnableForce", enable_force);
  library.require("dhdSetGravityCompensation", set_gravity_compensation);
  library.require("dhdSetEffectorMass", set_effector_mass);
  library.look_for("dhdSetMaxForce", set_max_force);
  library.look_for("dhdSetMaxTorque", set_max_torque);
  library.require("dhdGetPosition", position);
  library.require("dhdGetPositionAndOrientationFrame", pose);
  library.require("dhdGetLinearVelocity", linear_velocity);
  library.require("dhdGetAngularVelocityRad", angular_velocity);
  library.require("dhdGetButtonMask", button_mask);
  library.require("dhdGetGripperGap", gripper_gap);
  library.require("dhdSetForceAndGripperForce", set_force);
  library.require("dhdSetForceAndTorqueAndGripperForce", set_wrench);
}

std::string ForceDimensionLibrary::error() const {
  const char* text = last_error();
  return text != nullptr && *text != '\0' ? text : "the SDK does not say why";
}

}  // namespace tegotae
