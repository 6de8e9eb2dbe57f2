// SPDX-License-Identifier: Apache-2.0
#include <tegotae/device/virtuose_device.hpp>

#include <tegotae/device/assumed_ratings.hpp>
#include <tegotae/device/interface_driver.hpp>
#include <tegotae/device/interface_options.hpp>

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace tegotae {
namespace {

// N/m. No rating is public; of what is known of such arms the least that displays a wall.
constexpr double kAssumedStiffness = 1000.0;

[[noreturn]] void refuse_virtuose(const std::string& text) { throw InterfaceError("virtuose: " + text); }

bool command(const VirtuoseLibrary& library, void* context, const Vector3& force, const Vector3& torque) noexcept {
  float values[6];
  for (int i = 0; i < 3; ++i) {
    values[i] = static_cast<float>(force[i]);
    values[i + 3] = static_cast<float>(torque[i]);
  }
  return library.set_force(context, values) == 0;
}

bool command_zero(const VirtuoseLibrary& library, void* context) noexcept {
  return command(library, context, Vector3::Zero(), Vector3::Zero());
}

// Zero, no power, closed: each whatever became of the one before. False where the zero was refused.
bool let_go(const VirtuoseLibrary& library, void* context) noexcept {
  const bool is_zero = command_zero(library, context);
  library.enable_force_feedback(context, 0);
  library.set_power(context, 0);
  library.close(context);
  return is_zero;
}

// What the manual wants before the command type, and the command type. Null: done; else what was refused.
const char* configure(const VirtuoseLibrary& library, void* context, double period) noexcept {
  float identity[7] = {0.0F, 0.0F, 0.0F, 0.0F, 0.0F, 0.0F, 1.0F};
  if (library.set_indexing_mode(context, VirtuoseLibrary::kNoIndexing) != 0) return "the indexing mode";
  if (library.set_force_factor(context, 1.0F) != 0) return "the force factor";
  if (library.set_speed_factor(context, 1.0F) != 0) return "the speed factor";
  if (library.set_time_step(context, static_cast<float>(period)) != 0) return "the time step";
  if (library.set_base_frame(context, identity) != 0) return "the base frame";
  if (library.set_observation_frame(context, identity) != 0) return "the observation frame";
  if (library.set_command_type(context, VirtuoseLibrary::kImpedance) != 0) return "impedance control";
  return nullptr;
}

}  // namespace

VirtuoseOptions VirtuoseOptions::parse(std::string_view text) {
  InterfaceOptions given("virtuose", text);
  VirtuoseOptions options;
  options.address = given.value();
  if (options.address.empty()) refuse_virtuose("give the address of the device's controller, as virtuose:192.168.1.5.");
  try {
    if (const auto axes = given.text("axes")) options.axes = AxisMap(*axes);
  } catch (const std::invalid_argument& error) {
    refuse_virtuose(error.what());
  }
  options.period = given.number("period", 1e-3, 0.01).value_or(options.period);
  options.max_force = given.number("max-force", 0.0, 70.0).value_or(options.max_force);
  options.max_torque = given.number("max-torque", 0.0, 5.0).value_or(options.max_torque);
  given.refuse_others();
  return options;
}

VirtuoseDevice::VirtuoseDevice(const VirtuoseLibrary& library, const VirtuoseOptions& options,
                               EmergencyStopMemory stopped)
    : library_(library),
      options_(options),
      stopped_(std::move(stopped)),
      context_(library_.open(options_.address.c_str())) {
  if (context_ == nullptr) {
    refuse_virtuose("the controller at " + options_.address + " cannot be opened (" + library_.error(nullptr) +
                    "): check that it is on, that this machine reaches it, and that no other program has it.");
  }
  try {
    prepare();
  } catch (...) {
    let_go(library_, context_);
    throw;
  }
  find_buttons();
}

VirtuoseDevice::~VirtuoseDevice() { let_go(library_, context_); }

void VirtuoseDevice::prepare() const {
  if (const char* refused = configure(library_, context_, options_.period)) {
    refuse_virtuose(std::string(refused) + " cannot be set (" + library_.error(context_) + ").");
  }
  if (library_.saturate(context_, static_cast<float>(options_.max_force), static_cast<float>(options_.max_torque)) !=
      0) {
    refuse_virtuose("the controller does not take limits of force and torque (" + library_.error(context_) + ").");
  }
  int chain_is_closed = 0;
  if (library_.get_emergency_stop(context_, &chain_is_closed) != 0 || chain_is_closed != 1) {
    refuse_virtuose("the emergency stop is pressed or not plugged in: release it.");
  }
  const int power = stopped_->load() ? 0 : 1;
  if (!command_zero(library_, context_) || library_.enable_force_feedback(context_, 1) != 0 ||
      library_.set_power(context_, power) != 0) {
    refuse_virtuose("force feedback cannot be switched on (" + library_.error(context_) + ").");
  }
}

// A number that answers once exists: asking for each of them at every tick is a call too many, and one that fails now
// may be a packet that was lost.
void VirtuoseDevice::find_buttons() noexcept {
  constexpr int kTries = 3;
  for (int i = 0; i < kTries * kMostButtons; ++i) {
    int pressed = 0;
    const int number = i % kMostButtons;
    if (library_.get_button(context_, number, &pressed) == 0) existing_buttons_ |= std::uint32_t{1} << number;
  }
}

std::uint32_t VirtuoseDevice::buttons() const noexcept {
  std::uint32_t bits = 0;
  for (int number = 0; number < kMostButtons; ++number) {
    const std::uint32_t bit = std::uint32_t{1} << number;
    int pressed = 0;
    if ((existing_buttons_ & bit) != 0 && library_.get_button(context_, number, &pressed) == 0 && pressed == 1) {
      bits |= bit;
    }
  }
  return bits;
}

bool VirtuoseDevice::is_shifting() const noexcept {
  int shifting = 0;
  return library_.is_shifting != nullptr && library_.is_shifting(context_, &shifting) == 0 && shifting == 1;
}

// At each tick while the chain is open, as a single call may fail.
void VirtuoseDevice::stop() noexcept {
  stopped_->store(true);
  had_no_power_ = false;
  released_readings_ = 0;
  command_zero(library_, context_);
  library_.set_power(context_, 0);
}

// The chain is closed. Power that comes back by itself with it is switched off again: what comes after that is a
// person's doing, and so is a button after none was pressed for a while (asking may fail while one is held).
bool VirtuoseDevice::waits_for_a_person(bool has_power, std::uint32_t buttons) noexcept {
  if (!stopped_->load()) return false;
  const bool is_pressed = released_readings_ >= kReleased && buttons != 0;
  if ((had_no_power_ && has_power) || (is_pressed && library_.set_power(context_, 1) == 0)) {
    stopped_->store(false);
    return false;
  }
  if (!had_no_power_) library_.set_power(context_, 0);
  had_no_power_ = had_no_power_ || !has_power;
  released_readings_ = buttons == 0 ? std::min(released_readings_ + 1, kReleased) : 0;
  return true;
}

InterfaceCapability VirtuoseDevice::capability() const {
  InterfaceCapability result;
  result.name = "virtuose:" + options_.address;
  result.max_force = options_.max_force;
  result.max_torque = options_.max_torque;
  result.max_stiffness = kAssumedStiffness;
  result.rate = 1.0 / options_.period;
  return with_assumed_ratings(result);
}

DeviceAnswer VirtuoseDevice::read(double time, InterfaceState& state) noexcept {
  int chain_is_closed = 0, power = 0;
  float pose[7], speed[6];
  if (library_.get_emergency_stop(context_, &chain_is_closed) != 0) return DeviceAnswer::kFailed;
  if (chain_is_closed != 1) {
    stop();
    return DeviceAnswer::kNotReady;
  }
  if (library_.get_power(context_, &power) != 0 || library_.get_pose(context_, pose) != 0 ||
      library_.get_speed(context_, speed) != 0) {
    return DeviceAnswer::kFailed;
  }
  const Vector3 p(pose[0], pose[1], pose[2]), v(speed[0], speed[1], speed[2]), w(speed[3], speed[4], speed[5]);
  // Dividing leaves what is no rotation not finite, which the safety stage refuses.
  Quaternion q(pose[6], pose[3], pose[4], pose[5]);
  q.coeffs() /= q.norm();
  state = {};
  state.X_WT = options_.axes.to_world(p, q.toRotationMatrix());
  state.V_WT = {options_.axes.to_world(v), options_.axes.to_world(w)};
  state.time = age_.measured(time, state.X_WT, state.V_WT);
  state.buttons = buttons();
  const bool waits = waits_for_a_person(power == 1, state.buttons);
  return power == 1 && !waits && !is_shifting() ? DeviceAnswer::kOk : DeviceAnswer::kNotReady;
}

DeviceAnswer VirtuoseDevice::write(const InterfaceCommand& given) noexcept {
  const Wrench wrench = given.wrench.is_finite() ? given.wrench : Wrench{};
  const bool taken =
      command(library_, context_, options_.axes.to_device(wrench.force), options_.axes.to_device(wrench.torque));
  return taken ? DeviceAnswer::kOk : DeviceAnswer::kFailed;
}

bool VirtuoseDevice::silence(const VirtuoseLibrary& library, const VirtuoseOptions& options) noexcept {
  void* context = library.open(options.address.c_str());
  if (context == nullptr) return false;
  // A force is taken under impedance control alone.
  const bool is_configured = configure(library, context, options.period) == nullptr;
  return let_go(library, context) && is_configured;
}

}  // namespace tegotae
