// SPDX-License-Identifier: Apache-2.0
#include <tegotae/device/openhaptics_device.hpp>

#include <tegotae/device/assumed_ratings.hpp>
#include <tegotae/device/interface_driver.hpp>
#include <tegotae/device/interface_options.hpp>
#include <tegotae/runtime/periodic_timer.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <exception>
#include <stdexcept>
#include <thread>

namespace tegotae {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::seconds kFirstFrames{5};         // until the servo loop must run
constexpr std::chrono::milliseconds kCalibration{100};  // between looks at it
constexpr int kCalibrationLooks = 20;
constexpr std::chrono::milliseconds kLastFrame{500};  // until the last callback must have come
constexpr std::chrono::milliseconds kLook{1};
constexpr std::uint64_t kMeasuredFrames = 100, kSilentFrames = 50;
constexpr double kMostSilence = 0.1;  // s without a callback: a hundred of them are missing

// What the weakest device of the maker (Touch; of those with torque, Premium 1.5) bears.
constexpr double kLeastStiffness = 400.0;  // N/m
constexpr double kLeastTorque = 0.188;     // N m

std::string device_name(const OpenHapticsOptions& options) {
  return options.name.empty() ? "the default device" : fmt::format("the device '{}'", options.name);
}

// The newest error of this thread, the others forgotten.
unsigned newest_error(const OpenHapticsLibrary& library) noexcept {
  unsigned newest = hd::kSuccess;
  for (int i = 0; i < OpenHapticsLibrary::kMostErrors; ++i) {
    const unsigned code = library.get_error().code;
    if (code == hd::kSuccess) break;
    if (newest == hd::kSuccess) newest = code;
  }
  return newest;
}

// Not a number where the library does not know the parameter.
double number_of(const OpenHapticsLibrary& library, hd::Parameter parameter) {
  double value = 0.0;
  library.get_doubles(parameter, &value);
  return newest_error(library) == hd::kSuccess ? value : std::nan("");
}

int degrees_of(const OpenHapticsLibrary& library, hd::Parameter parameter) {
  int value = 0;
  library.get_integers(parameter, &value);
  if (newest_error(library) == hd::kSuccess && value >= 3 && value <= 8) return value;
  throw InterfaceError(fmt::format(
      "openhaptics: the library says that the device has {} degrees of freedom (parameter {:#x}), which is not what is "
      "known of such devices, so nothing of it is believed.",
      value, static_cast<unsigned>(parameter)));
}

double believed(double value, double least, double most, double otherwise) {
  return value >= least && value <= most ? value : otherwise;
}

std::string model_of(const OpenHapticsLibrary& library) {
  const char* model = library.get_string(hd::kDeviceModelType);
  newest_error(library);
  return model != nullptr && *model != '\0' ? model : "device of 3D Systems";
}

InterfaceCapability capability_of(const OpenHapticsLibrary& library) {
  InterfaceCapability result;
  result.name = model_of(library);
  result.input_degrees_of_freedom = std::min(degrees_of(library, hd::kInputDegrees), 6);
  result.output_degrees_of_freedom = degrees_of(library, hd::kOutputDegrees) >= 6 ? 6 : 3;
  result.max_force = number_of(library, hd::kNominalMaxForce);
  if (!(result.max_force >= 0.5 && result.max_force <= 60.0)) {
    throw InterfaceError(
        fmt::format("openhaptics: the library gives {} N as the greatest force of '{}', which is not what is known of "
                    "such devices, "
                    "so nothing of it is believed.",
                    result.max_force, result.name));
  }
  constexpr double kNewtonPerMillimetre = 1e3;  // N/m
  constexpr double kMillinewtonMetre = 1e-3;    // N m
  result.max_stiffness =
      believed(kNewtonPerMillimetre * number_of(library, hd::kNominalMaxStiffness), 50.0, 2e4, kLeastStiffness);
  result.max_torque = believed(kMillinewtonMetre * number_of(library, hd::kNominalMaxTorque), 0.01, 5.0, kLeastTorque);
  return result;
}

}  // namespace

OpenHapticsOptions OpenHapticsOptions::parse(std::string_view text) {
  InterfaceOptions given("openhaptics", text);
  OpenHapticsOptions options;
  options.name = given.value();
  if (const auto axes = given.text("axes")) {
    try {
      options.axes = AxisMap(*axes);
    } catch (const std::invalid_argument& error) {
      throw InterfaceError(fmt::format("openhaptics: {}", error.what()));
    }
  }
  given.refuse_others();
  return options;
}

struct OpenHapticsDevice::Claim {
  Claim() {
    if (is_taken.exchange(true)) {
      throw InterfaceError("openhaptics: this program has a device open already; its scheduler serves one at a time.");
    }
  }
  Claim(const Claim&) = delete;
  Claim& operator=(const Claim&) = delete;
  ~Claim() { is_taken.store(false); }

  static inline std::atomic<bool> is_taken{false};
};

struct OpenHapticsDevice::Handle {
  Handle(const OpenHapticsLibrary& the_library, const OpenHapticsOptions& options)
      : library(the_library), device(library.init_device(options.name.empty() ? nullptr : options.name.c_str())) {
    const unsigned error = newest_error(library);
    if (device != hd::kInvalidHandle && error == hd::kSuccess) {
      library.make_current_device(device);
      return;
    }
    if (device != hd::kInvalidHandle) library.disable_device(device);
    throw InterfaceError(fmt::format(
        "openhaptics: {} does not answer (error {:#06x}); switch it on, check its cable and your rights on its port "
        "(/dev/ttyACM*), give it that name with the maker's set-up program, and set GTDD_HOME.",
        device_name(options), error));
  }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  ~Handle() {
    library.make_current_device(device);
    library.disable(hd::kForceOutput);
    library.disable_device(device);
    newest_error(library);
  }

  const OpenHapticsLibrary& library;
  hd::Handle device;
};

struct OpenHapticsDevice::Schedule {
  Schedule(const OpenHapticsLibrary& the_library, OpenHapticsServo& the_servo)
      : library(the_library),
        servo(the_servo),
        callback(library.schedule_asynchronous(OpenHapticsServo::callback, &servo, hd::kHighestPriority)) {
    library.enable(hd::kForceOutput);
    const unsigned error = newest_error(library);
    // The device's own bounds; not all have them.
    library.enable(hd::kMaxForceClamping);
    library.enable(hd::kForceRamping);
    newest_error(library);
    library.start_scheduler();
    const unsigned start_error = newest_error(library);
    if (error == hd::kSuccess && start_error == hd::kSuccess) return;
    stop();
    throw InterfaceError(fmt::format(
        "openhaptics: the servo loop does not start (errors {:#06x}, {:#06x}); unplug the device and plug it in again.",
        error, start_error));
  }
  Schedule(const Schedule&) = delete;
  Schedule& operator=(const Schedule&) = delete;
  ~Schedule() {
    servo.end();
    const Clock::time_point deadline = Clock::now() + kLastFrame;
    while (!servo.has_ended() && Clock::now() < deadline) std::this_thread::sleep_for(kLook);
    stop();
  }

  void stop() const {
    library.stop_scheduler();
    library.unschedule(callback);
    newest_error(library);
  }

  const OpenHapticsLibrary& library;
  OpenHapticsServo& servo;
  hd::Schedule callback;
};

OpenHapticsDevice::OpenHapticsDevice(const OpenHapticsLibrary& library, const OpenHapticsOptions& options,
                                     Calibrate calibrate_it)
    : library_(library),
      options_(options),
      claim_(std::make_unique<Claim>()),
      handle_(std::make_unique<Handle>(library_, options_)) {
  capability_ = capability_of(library_);
  servo_ = std::make_unique<OpenHapticsServo>(library_, handle_->device, options_.axes,
                                              capability_.output_degrees_of_freedom == 6);
  schedule_ = std::make_unique<Schedule>(library_, *servo_);
  await_frames(1);
  const OpenHapticsSample first = servo_->samples().get();
  await_frames(kMeasuredFrames);
  const OpenHapticsSample last = servo_->samples().get();
  const double measured =
      static_cast<double>(last.counts.frames - first.counts.frames) / seconds_between(first.time, last.time);
  capability_.rate = std::max(10.0 * std::round(measured / 10.0), 10.0);
  capability_.delay = 1.0 / capability_.rate;  // at most, until the callback that takes a command
  if (!servo_->turns()) {
    capability_.output_degrees_of_freedom = 3;
    capability_.max_torque = 0.0;
  }
  capability_ = with_assumed_ratings(capability_);
  if (calibrate_it == Calibrate::kNo) return;
  calibrate();
  await_frames(servo_->samples().get().counts.frames + 2);  // a pose by the new calibration
  if (servo_->samples().get().is_plausible) return;
  throw InterfaceError(fmt::format(
      "openhaptics: '{}' does not report its pose as is known of this library (16 numbers column by column, in "
      "millimetres), so nothing of it is believed.",
      capability_.name));
}

OpenHapticsDevice::~OpenHapticsDevice() = default;

void OpenHapticsDevice::await_frames(std::uint64_t count) {
  const Clock::time_point deadline = Clock::now() + kFirstFrames;
  for (;;) {
    servo_->samples().update();
    const OpenHapticsSample& sample = servo_->samples().get();
    if (sample.counts.frames >= count) return;
    if (sample.has_failed || Clock::now() > deadline) {
      throw InterfaceError(
          fmt::format("openhaptics: the servo loop of '{}' {} (error {:#06x}); check its cable and power, and that no "
                      "other program "
                      "uses it.",
                      capability_.name, sample.has_failed ? "fails" : "does not run", sample.counts.last_failure));
    }
    std::this_thread::sleep_for(kLook);
  }
}

void OpenHapticsDevice::calibrate() const {
  int styles = 0;
  library_.get_integers(hd::kCalibrationStyle, &styles);
  newest_error(library_);
  const auto has = [styles](hd::CalibrationStyle style) { return (static_cast<unsigned>(styles) & style) != 0; };
  for (int look = 0; look < kCalibrationLooks; ++look) {
    const unsigned status = library_.check_calibration();
    if (status == hd::kCalibrationOk) return;
    if (status == hd::kCalibrationByHand) break;
    if (status != hd::kCalibrationNeedsUpdate || !(has(hd::kAutomatic) || has(hd::kInkwell))) break;
    library_.update_calibration(has(hd::kAutomatic) ? hd::kAutomatic : hd::kInkwell);
    newest_error(library_);
    std::this_thread::sleep_for(kCalibration);
  }
  throw InterfaceError(fmt::format(
      "openhaptics: '{}' is not calibrated; put its stylus into the inkwell (a Premium: hold it at its reset position "
      "and calibrate it with the maker's program), and try again.",
      capability_.name));
}

DeviceAnswer OpenHapticsDevice::read(double time, InterfaceState& state) noexcept {
  servo_->samples().update();
  const OpenHapticsSample& sample = servo_->samples().get();
  const double age = seconds_between(sample.time, monotonic_nanoseconds());
  if (sample.has_failed || age > kMostSilence) return DeviceAnswer::kFailed;
  if (!sample.is_plausible || sample.is_withheld) return DeviceAnswer::kNotReady;
  state = {};
  state.time = time - age;
  state.X_WT = sample.X_WT;
  state.V_WT = sample.V_WT;
  state.buttons = sample.buttons;
  return DeviceAnswer::kOk;
}

DeviceAnswer OpenHapticsDevice::write(const InterfaceCommand& command) noexcept {
  servo_->commands().write(command.wrench);
  return servo_->has_ended() ? DeviceAnswer::kFailed : DeviceAnswer::kOk;
}

std::string OpenHapticsDevice::remarks() {
  const OpenHapticsCounts& n = counts();
  std::string text;
  const auto count = [&text](const char* what, std::uint64_t times) {
    if (times > 0) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", what, times);
  };
  count("motors warm", n.warm_motors);
  count("force beyond the greatest", n.exceeded_force);
  count("impulse beyond the greatest", n.exceeded_impulse);
  count("velocity beyond the greatest", n.exceeded_velocity);
  count("force error", n.force_errors);
  count("frames that failed", n.failed_frames);
  count("commands taken back as no other came", n.withheld);
  if (text.empty()) return text;
  if (n.failed_frames > 0) text += fmt::format(" (last error {:#06x})", n.last_failure);
  return fmt::format("{} told of: {}.", capability_.name, text);
}

std::string OpenHapticsDevice::model(const OpenHapticsLibrary& library, const OpenHapticsOptions& options) {
  const Claim claim;
  const Handle handle(library, options);
  return model_of(library);
}

bool OpenHapticsDevice::silence(const OpenHapticsLibrary& library, const OpenHapticsOptions& options) noexcept {
  try {
    OpenHapticsDevice device(library, options, Calibrate::kNo);
    device.await_frames(kMeasuredFrames + kSilentFrames);
    return true;
  } catch (const std::exception&) {
    return false;
  }
}

}  // namespace tegotae
