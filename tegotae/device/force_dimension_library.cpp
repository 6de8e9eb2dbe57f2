// SPDX-License-Identifier: Apache-2.0
#include <tegotae/device/force_dimension_library.hpp>

namespace tegotae {
namespace {

template <class Function>
void require(const VendorLibrary& library, const char* symbol, Function*& function) {
  function = library.function<Function>(symbol);
}

template <class Function>
void look_for(const VendorLibrary& library, const char* symbol, Function*& function) {
  function = library.optional_function<Function>(symbol);
}

}  // namespace

VendorLibrary ForceDimensionLibrary::find() {
  return VendorLibrary({"force-dimension",
                        "the Force Dimension SDK",
                        {"libdrd.so", "libdrd.so.3", "libdhd.so", "libdhd.so.3"},
                        "",
                        "Install it from forcedimension.com and put the folder of its libraries into LD_LIBRARY_PATH, "
                        "or into /etc/ld.so.conf.d and run ldconfig."});
}

ForceDimensionLibrary::ForceDimensionLibrary(const VendorLibrary& library) {
  require(library, "dhdGetDeviceCount", device_count);
  file = library.file();
  if (library.optional_function<int()>("drdOpen") != nullptr) {
    require(library, "drdOpen", drd_open);
    require(library, "drdOpenID", drd_open_id);
    look_for(library, "drdClose", drd_close);
    require(library, "drdIsInitialized", drd_is_initialized);
    require(library, "drdAutoInit", drd_auto_init);
    require(library, "drdStop", drd_stop);
  }
  require(library, "dhdOpen", open);
  require(library, "dhdOpenID", open_id);
  require(library, "dhdClose", close);
  look_for(library, "dhdStop", stop);
  require(library, "dhdErrorGetLastStr", last_error);
  require(library, "dhdGetSystemName", system_name);
  require(library, "dhdHasWrist", has_wrist);
  require(library, "dhdHasActiveWrist", has_active_wrist);
  require(library, "dhdHasGripper", has_gripper);
  require(library, "dhdIsLeftHanded", is_left_handed);
  require(library, "dhdEnableForce", enable_force);
  require(library, "dhdSetGravityCompensation", set_gravity_compensation);
  require(library, "dhdSetEffectorMass", set_effector_mass);
  look_for(library, "dhdSetMaxForce", set_max_force);
  look_for(library, "dhdSetMaxTorque", set_max_torque);
  require(library, "dhdGetPosition", position);
  require(library, "dhdGetPositionAndOrientationFrame", pose);
  require(library, "dhdGetLinearVelocity", linear_velocity);
  require(library, "dhdGetAngularVelocityRad", angular_velocity);
  require(library, "dhdGetButtonMask", button_mask);
  require(library, "dhdGetGripperGap", gripper_gap);
  require(library, "dhdSetForceAndGripperForce", set_force);
  require(library, "dhdSetForceAndTorqueAndGripperForce", set_wrench);
}

std::string ForceDimensionLibrary::error() const {
  const char* text = last_error();
  return text != nullptr && *text != '\0' ? text : "the SDK does not say why";
}

}  // namespace tegotae
