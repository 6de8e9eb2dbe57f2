// SPDX-License-Identifier: Apache-2.0
#include <tegotae/device/spidar_device.hpp>

#include <tegotae/device/assumed_ratings.hpp>
#include <tegotae/device/interface_driver.hpp>
#include <tegotae/device/interface_options.hpp>
#include <tegotae/device/spidar_file.hpp>
#include <tegotae/device/spidar_reach.hpp>

#include <chrono>
#include <cmath>
#include <stdexcept>
#include <thread>
#include <utility>

namespace tegotae {
namespace {

// m by which a string may come and go with a grip that is held still: a hand trembles by less.
constexpr double kStill = 1e-3;
// Between two looks at it: often enough that the board's own watchdog does not let go.
constexpr std::chrono::milliseconds kBetweenReadings{2};
// Readings that fail on end.
constexpr int kFailures = 20;

[[noreturn]] void refuse_spidar(const std::string& text) { throw InterfaceError("spidar-g6: " + text); }

[[noreturn]] void refuse_silent(const std::string& why) {
  refuse_spidar("the board does not answer (" + why + "): check its power and its cable.");
}

SpidarSettings settings_of(const SpidarOptions& options) {
  SpidarSettings settings;
  settings.geometry = options.geometry;
  settings.rate = options.rate;
  return settings;
}

bool is_still(const SpidarGeometry& geometry, const SpidarVector& counts, const SpidarVector& others) {
  for (int i = 0; i < kSpidarStrings; ++i) {
    const double pulse = geometry.strings[static_cast<std::size_t>(i)].metres_per_pulse;
    if (!(std::abs(pulse * (counts[i] - others[i])) < kStill)) return false;
  }
  return true;
}

}  // namespace

SpidarOptions SpidarOptions::parse(std::string_view text) {
  InterfaceOptions given("spidar-g6", text);
  SpidarOptions options;
  if (given.value().empty()) refuse_spidar("say which it is: a preset or a file, as spidar-g6:x3r,transport=LIBRARY.");
  try {
    options.geometry = find_spidar_geometry(given.value());
    check_force_closure(options.geometry);
    if (const auto axes = given.text("axes")) options.axes = AxisMap(*axes);
  } catch (const SpidarFileError& error) {
    refuse_spidar(error.what());
  } catch (const std::invalid_argument& error) {
    refuse_spidar(error.what());
  }
  options.transport = given.text("transport").value_or("");
  options.board = given.text("board").value_or("");
  options.rate = given.number("rate", 100.0, 20000.0).value_or(options.rate);
  options.stiffness = given.number("stiffness", 1.0, 100000.0).value_or(options.stiffness);
  options.is_zero_kept = given.text("zero", "here|kept").value_or("here") == "kept";
  options.hold_time = given.number("hold", 0.0, 60.0).value_or(options.hold_time);
  given.refuse_others();
  return options;
}

SpidarDevice::SpidarDevice(const SpidarBoardLibrary& library, const SpidarOptions& options, SpidarZero zero)
    : options_(options), interface_(take_into_use(std::make_unique<SpidarBoard>(library, options.board), zero)) {}

SpidarInterface SpidarDevice::take_into_use(std::unique_ptr<SpidarBoard> board, SpidarZero zero) {
  board_ = board.get();
  if (zero == SpidarZero::kHere) {
    wait_for_a_still_grip();
  } else {
    require_zero();
  }
  try {
    return SpidarInterface(settings_of(options_), std::move(board), zero);
  } catch (const std::runtime_error& error) {
    refuse_spidar(error.what());
  }
}

void SpidarDevice::require_zero() const {
  SpidarVector counts;
  for (int failures = 0; !board_->read_uncalibrated(counts); ++failures) {
    if (failures == kFailures) refuse_silent(board_->why());
  }
  if (board_->is_calibrated()) return;
  refuse_spidar(
      "the counters have lost their zero: start the program with the grip held in the middle of the frame, unrotated, "
      "and without zero=kept.");
}

// Least tensions take up what hung slack, so the counts run at first.
void SpidarDevice::wait_for_a_still_grip() const {
  using Clock = std::chrono::steady_clock;
  const std::chrono::duration<double> hold(options_.hold_time), patience(options_.hold_time + kPatience);
  const SpidarVector least = min_tensions(options_.geometry);
  const Clock::time_point begin = Clock::now();
  Clock::time_point since = begin;
  SpidarVector counts, rest;
  bool has_read = false;
  for (int failures = 0;; std::this_thread::sleep_for(kBetweenReadings)) {
    const bool answers = board_->write(least) && board_->read_uncalibrated(counts);
    const Clock::time_point now = Clock::now();
    failures = answers ? 0 : failures + 1;
    if (failures >= kFailures) refuse_silent(board_->why());
    if (answers && (!has_read || !is_still(options_.geometry, counts, rest))) {
      rest = counts;
      since = now;
      has_read = true;
    }
    if (answers && now - since >= hold) return;
    if (now - begin <= patience) continue;
    refuse_spidar(
        "the grip does not stand still: hold it in the middle of the frame, unrotated, while the program starts.");
  }
}

InterfaceCapability SpidarDevice::capability() const {
  InterfaceCapability result = interface_.capability();
  result.max_stiffness = options_.stiffness;
  return with_assumed_ratings(result);
}

DeviceAnswer SpidarDevice::read(double time, InterfaceState& state) noexcept {
  const DeviceAnswer result = answer(interface_.read(time, state));
  if (result != DeviceAnswer::kOk) return result;
  state.X_WT = options_.axes.to_world(state.X_WT.p, state.X_WT.q.toRotationMatrix());
  state.X_WT.q.normalize();
  state.V_WT = {options_.axes.to_world(state.V_WT.linear), options_.axes.to_world(state.V_WT.angular)};
  return result;
}

DeviceAnswer SpidarDevice::write(const InterfaceCommand& command) noexcept {
  const Wrench& wrench = command.wrench;
  return answer(
      interface_.write({{options_.axes.to_device(wrench.force), options_.axes.to_device(wrench.torque)}, 0.0}));
}

DeviceAnswer SpidarDevice::answer(InterfaceStatus status) noexcept {
  if (board_->take_failure()) return DeviceAnswer::kFailed;
  return status == InterfaceStatus::kOk ? DeviceAnswer::kOk : DeviceAnswer::kNotReady;
}

std::string SpidarDevice::remarks() {
  std::string text;
  if (!board_->is_calibrated()) {
    text =
        "the SPIDAR's counters lost their zero: start the program again, with the grip held in the middle of the "
        "frame, unrotated.";
  }
  if (interface_.shortfalls() > 0) {
    text += (text.empty() ? "" : " ");
    text += "The SPIDAR's motors displayed less than was asked for, ticks: " + std::to_string(interface_.shortfalls()) +
            ".";
  }
  return text;
}

}  // namespace tegotae
