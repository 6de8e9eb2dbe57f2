// SPDX-License-Identifier: Apache-2.0
#include <tegotae/device/force_dimension_device.hpp>

#include <tegotae/device/assumed_ratings.hpp>
#include <tegotae/device/interface_driver.hpp>
#include <tegotae/device/interface_options.hpp>
#include <tegotae/device/tolerances.hpp>

#include <algorithm>
#include <cctype>
#include <stdexcept>
#include <string>

namespace tegotae {
namespace {

// s, of the finite differences where the SDK gives no velocity.
constexpr double kDifferenceWindow = 0.01;

struct Model {
  std::string_view name;
  double force, torque, stiffness;  // N, N m where the wrist has motors, N/m
};
constexpr Model kModels[] = {
    {"omega", 12.0, 0.0, 5000.0}, {"sigma", 12.0, 0.2, 4000.0}, {"lambda", 12.0, 0.2, 8000.0},
    {"delta", 20.0, 0.0, 5000.0}, {"falcon", 8.0, 0.0, 3000.0},
};
constexpr Model kUnknownModel = {"", 5.0, 0.1, 1000.0};

[[noreturn]] void refuse_force_dimension(const std::string& text) { throw InterfaceError("force-dimension: " + text); }

// Handle of the device, below 0: none.
int open_handle(const ForceDimensionLibrary& library, const std::optional<int>& id) noexcept {
  const bool by_drd = library.drd_open != nullptr;
  if (!id) return by_drd ? library.drd_open() : library.open();
  const char index = static_cast<char>(*id);
  return by_drd ? library.drd_open_id(index) : library.open_id(index);
}

bool command_zero(const ForceDimensionLibrary& library, char id, bool has_active_wrist) noexcept {
  return (has_active_wrist ? library.set_wrench(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, id)
                           : library.set_force(0.0, 0.0, 0.0, 0.0, id)) >= 0;
}

bool is_rotation(const Matrix3& R) noexcept {
  return (R * R.transpose() - Matrix3::Identity()).cwiseAbs().maxCoeff() <= tolerance::kRotationMatrix &&
         R.determinant() > 0.0;
}

// Zero, forces off, closed: each whatever became of the one before. False where the zero was refused.
bool let_go(const ForceDimensionLibrary& library, char id, bool has_active_wrist) noexcept {
  const bool is_zero = command_zero(library, id, has_active_wrist);
  library.enable_force(0, id);
  if (library.stop != nullptr) library.stop(id);
  if (library.drd_close != nullptr) {
    library.drd_close(id);
  } else {
    library.close(id);
  }
  return is_zero;
}

}  // namespace

ForceDimensionOptions ForceDimensionOptions::parse(std::string_view text) {
  InterfaceOptions given("force-dimension", text);
  ForceDimensionOptions options;
  if (!given.value().empty()) {
    const std::string& id = given.value();
    if (id.size() > 2 || !std::all_of(id.begin(), id.end(), [](unsigned char c) { return std::isdigit(c) != 0; })) {
      refuse_force_dimension("'" + id + "' is no number of a device; the first is 0.");
    }
    options.id = std::stoi(id);
  }
  try {
    if (const auto axes = given.text("axes")) options.axes = AxisMap(*axes);
  } catch (const std::invalid_argument& error) {
    refuse_force_dimension(error.what());
  }
  options.gravity_compensation = given.text("gravity-compensation", "on|off").value_or("on") == "on";
  options.effector_mass = given.number("effector-mass", 0.0, 1.0);
  options.auto_init = given.text("auto-init", "on|off").value_or("on") == "on";
  given.refuse_others();
  return options;
}

InterfaceCapability force_dimension_capability(std::string_view model, bool has_wrist, bool has_active_wrist) {
  std::string name(model);
  std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::tolower(c); });
  const Model* known = std::find_if(std::begin(kModels), std::end(kModels),
                                    [&name](const Model& each) { return name.find(each.name) != std::string::npos; });
  const Model& limits = known == std::end(kModels) ? kUnknownModel : *known;
  InterfaceCapability result;
  result.name = "force-dimension:" + (model.empty() ? "unknown" : std::string(model));
  result.input_degrees_of_freedom = has_wrist ? 6 : 3;
  result.output_degrees_of_freedom = has_active_wrist ? 6 : 3;
  result.max_force = limits.force;
  // A wrist with motors on a model that is known without: of motors that nobody described the weakest is assumed.
  const double torque = limits.torque > 0.0 ? limits.torque : kUnknownModel.torque;
  result.max_torque = has_active_wrist ? torque : 0.0;
  result.max_stiffness = limits.stiffness;
  return with_assumed_ratings(result);
}

ForceDimensionDevice::ForceDimensionDevice(const ForceDimensionLibrary& library, const ForceDimensionOptions& options,
                                           bool may_move)
    : library_(library), options_(options) {
  const int handle = open_handle(library_, options_.id);
  if (handle < 0) {
    const std::string which = options_.id ? "device " + std::to_string(*options_.id) : "a device";
    refuse_force_dimension(
        which + " cannot be opened (" + library_.error() +
        "): check its power and cable, that no other program has it, and your rights on USB devices of vendor 1451.");
  }
  id_ = static_cast<char>(handle);
  try {
    const char* model = library_.system_name(id_);
    has_wrist_ = library_.has_wrist(id_);
    has_active_wrist_ = has_wrist_ && library_.has_active_wrist(id_);
    has_gripper_ = library_.has_gripper(id_);
    gripper_sign_ = library_.is_left_handed(id_) ? -1.0 : 1.0;
    capability_ = force_dimension_capability(model != nullptr ? model : "", has_wrist_, has_active_wrist_);
    capability_.name += serial_number();
    calibrate(may_move);
    prepare();
  } catch (...) {
    let_go(library_, id_, has_active_wrist_);
    throw;
  }
}

ForceDimensionDevice::~ForceDimensionDevice() { let_go(library_, id_, has_active_wrist_); }

// Two devices of a model, for either hand, are told apart by it when one comes back.
std::string ForceDimensionDevice::serial_number() const {
  unsigned short number = 0;
  if (library_.serial_number == nullptr || library_.serial_number(&number, id_) < 0) return {};
  return " (serial number " + std::to_string(number) + ")";
}

void ForceDimensionDevice::calibrate(bool may_move) const {
  if (library_.drd_open == nullptr || library_.drd_is_initialized(id_)) return;
  if (!may_move || !options_.auto_init) {
    refuse_force_dimension(
        "the device is not calibrated and may not move by itself: move it to its stops by hand until its light says "
        "that it is.");
  }
  if (library_.drd_auto_init(id_) < 0) {
    refuse_force_dimension("the device cannot calibrate itself (" + library_.error() +
                           "): clear the space that it moves in.");
  }
  library_.drd_stop(true, id_);
}

void ForceDimensionDevice::prepare() const {
  if (library_.set_gravity_compensation(options_.gravity_compensation ? 1 : 0, id_) < 0) {
    refuse_force_dimension("gravity compensation cannot be set (" + library_.error() + ").");
  }
  if (options_.effector_mass && library_.set_effector_mass(*options_.effector_mass, id_) < 0) {
    refuse_force_dimension("the effector's mass cannot be set (" + library_.error() + ").");
  }
  // A second limit behind the safety stage's, where the SDK has one: models that refuse it keep their own.
  if (library_.set_max_force != nullptr) library_.set_max_force(capability_.max_force, id_);
  if (library_.set_max_torque != nullptr && has_active_wrist_) library_.set_max_torque(capability_.max_torque, id_);
  if (!command_zero(library_, id_, has_active_wrist_) || library_.enable_force(1, id_) < 0) {
    refuse_force_dimension("forces cannot be enabled (" + library_.error() +
                           "): check its power and its force button.");
  }
}

DeviceAnswer ForceDimensionDevice::read(double time, InterfaceState& state) noexcept {
  Vector3 p_DG;
  double frame[3][3];
  const int result = has_wrist_ ? library_.pose(&p_DG.x(), &p_DG.y(), &p_DG.z(), frame, id_)
                                : library_.position(&p_DG.x(), &p_DG.y(), &p_DG.z(), id_);
  if (result < 0) {
    history_.clear();
    return DeviceAnswer::kFailed;
  }
  Matrix3 R_DG = Matrix3::Identity();
  for (int i = 0; has_wrist_ && i < 9; ++i) R_DG(i / 3, i % 3) = frame[i / 3][i % 3];
  if (!is_rotation(R_DG)) {
    history_.clear();
    return DeviceAnswer::kFailed;
  }
  state = {};
  state.X_WT = options_.axes.to_world(p_DG, R_DG);
  state.X_WT.q.normalize();
  history_.add(time, state.X_WT);
  state.V_WT = velocity();
  state.time = age_.measured(time, state.X_WT, state.V_WT);
  state.buttons = library_.button_mask(id_);
  if (has_gripper_) library_.gripper_gap(&state.gripper, id_);
  return DeviceAnswer::kOk;
}

Twist ForceDimensionDevice::velocity() const noexcept {
  const Twist differences = history_.velocity(kDifferenceWindow);
  Vector3 linear, angular = Vector3::Zero();
  const bool has_linear = library_.linear_velocity(&linear.x(), &linear.y(), &linear.z(), id_) >= 0;
  const bool has_angular = !has_wrist_ || library_.angular_velocity(&angular.x(), &angular.y(), &angular.z(), id_) >= 0;
  return {has_linear ? options_.axes.to_world(linear) : differences.linear,
          has_angular ? options_.axes.to_world(angular) : differences.angular};
}

DeviceAnswer ForceDimensionDevice::write(const InterfaceCommand& command) noexcept {
  const bool is_finite = command.wrench.is_finite() && std::isfinite(command.gripper_force);
  const InterfaceCommand fine = is_finite ? command : InterfaceCommand{};
  const Vector3 f = options_.axes.to_device(fine.wrench.force), t = options_.axes.to_device(fine.wrench.torque);
  const double gripper = has_gripper_ ? gripper_sign_ * fine.gripper_force : 0.0;
  const int result = has_active_wrist_ ? library_.set_wrench(f.x(), f.y(), f.z(), t.x(), t.y(), t.z(), gripper, id_)
                                       : library_.set_force(f.x(), f.y(), f.z(), gripper, id_);
  return result < 0 ? DeviceAnswer::kFailed : DeviceAnswer::kOk;
}

bool ForceDimensionDevice::silence(const ForceDimensionLibrary& library,
                                   const ForceDimensionOptions& options) noexcept {
  const int handle = open_handle(library, options.id);
  if (handle < 0) return false;
  const char id = static_cast<char>(handle);
  return let_go(library, id, library.has_active_wrist(id));
}

}  // namespace tegotae
