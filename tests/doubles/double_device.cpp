// SPDX-License-Identifier: Apache-2.0
#include <tests/doubles/double_device.hpp>

#include <fcntl.h>
#include <sys/mman.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <limits>

namespace tegotae::test {
namespace {

constexpr double kSubstep = 50e-6;                // s
constexpr double kLongestStep = 0.1;              // s
constexpr std::int64_t kMillisecond = 1'000'000;  // ns

void sleep_for(std::int64_t nanoseconds) {
  timespec left{static_cast<time_t>(nanoseconds / 1'000'000'000), static_cast<long>(nanoseconds % 1'000'000'000)};
  while (nanosleep(&left, &left) != 0) {
  }
}

// A process that is gone, or is only waiting for its parent to notice, has let go of its devices.
bool lives(int process) {
  std::ifstream file("/proc/" + std::to_string(process) + "/stat");
  std::string text;
  std::getline(file, text);
  const std::size_t end = text.rfind(") ");
  return end != std::string::npos && text[end + 2] != 'Z' && text[end + 2] != 'X';
}

Pose pose_of(const std::array<std::atomic<double>, 7>& s) {
  return {{s[0].load(), s[1].load(), s[2].load()},
          Quaternion(s[3].load(), s[4].load(), s[5].load(), s[6].load()).normalized()};
}

void store(std::array<std::atomic<double>, 6>& to, const Vector3& first, const Vector3& second) {
  for (std::size_t i = 0; i < 3; ++i) {
    to[i].store(first[static_cast<int>(i)]);
    to[i + 3].store(second[static_cast<int>(i)]);
  }
}

Vector3 first_of(const std::array<std::atomic<double>, 6>& s) { return {s[0].load(), s[1].load(), s[2].load()}; }
Vector3 second_of(const std::array<std::atomic<double>, 6>& s) { return {s[3].load(), s[4].load(), s[5].load()}; }

void store(std::array<std::atomic<double>, 7>& to, const Pose& X) {
  const double values[] = {X.p.x(), X.p.y(), X.p.z(), X.q.w(), X.q.x(), X.q.y(), X.q.z()};
  for (std::size_t i = 0; i < to.size(); ++i) to[i].store(values[i]);
}

// A double has one writer of these.
void raise(std::atomic<double>& largest, double value) {
  if (value > largest.load()) largest.store(value);
}

Vector3 clipped(const Vector3& vector, double limit) {
  const double size = vector.norm();
  return size > limit ? Vector3(limit / size * vector) : vector;
}

}  // namespace

// Not a mutex, so that a test that counts the locks of a driver does not count those of its double.
class DoubleDevice::Guard {
 public:
  explicit Guard(DoubleDevice& device) : busy_(device.busy_) {
    while (busy_.exchange(true, std::memory_order_acquire)) sleep_for(20'000);
  }
  Guard(const Guard&) = delete;
  Guard& operator=(const Guard&) = delete;
  ~Guard() { busy_.store(false, std::memory_order_release); }

 private:
  std::atomic<bool>& busy_;
};

DoubleDevice& DoubleDevice::instance() {
  static DoubleDevice device;
  return device;
}

// An older file stays mapped: another thread may still look at it.
bool DoubleDevice::map() {
  if (open_) return true;
  const char* path = std::getenv(kDoubleStateVariable);
  if (path == nullptr) {
    state_ = nullptr;
    path_.clear();
    return false;
  }
  if (state_ != nullptr && path_ == path) return true;
  state_ = nullptr;
  const int file = ::open(path, O_RDWR | O_CLOEXEC);
  if (file < 0) return false;
  void* memory = mmap(nullptr, sizeof(DoubleState), PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
  ::close(file);
  if (memory == MAP_FAILED) return false;
  state_ = static_cast<DoubleState*>(memory);
  path_ = path;
  return true;
}

DoubleState* DoubleDevice::state() {
  const Guard guard(*this);
  return map() ? state_ : nullptr;
}

bool DoubleDevice::is_present() {
  const Guard guard(*this);
  return map() && !state_->unplugged.load();
}

bool DoubleDevice::open() {
  const Guard guard(*this);
  if (open_ && usable()) return true;
  open_ = false;
  if (!map()) return false;
  const int opener = state_->opener.load();
  const bool is_taken = opener != 0 && opener != getpid() && !state_->shared.load() && lives(opener);
  if (state_->unplugged.load() || is_taken) {
    state_->refused_opens.fetch_add(1);
    return false;
  }
  try {
    grip_.emplace(GripMechanics{state_->mass.load(), state_->inertia.load(), state_->damping.load(),
                                state_->rotational_damping.load(), 0.0, 0.0},
                  HandImpedance{0.0, 0.0, state_->hand_damping.load(), state_->hand_rotational_damping.load(),
                                state_->hand_stiffness.load(), state_->hand_rotational_stiffness.load()},
                  kSubstep);
  } catch (const std::exception&) {
    return false;
  }
  plugged_in_ = state_->unplugged_times.load();
  if (state_->plugged_in.exchange(plugged_in_) != plugged_in_) lose_power();
  is_frozen_ = false;
  state_->stepped_at.store(now());
  state_->opener.store(getpid());
  state_->opens.fetch_add(1);
  open_ = true;
  return true;
}

bool DoubleDevice::close() {
  const Guard guard(*this);
  if (!open_) return false;
  open_ = false;
  state_->opener.store(0);
  state_->closes.fetch_add(1);
  return true;
}

bool DoubleDevice::is_open() {
  const Guard guard(*this);
  return usable();
}

bool DoubleDevice::usable() const {
  return open_ && !state_->unplugged.load() && state_->unplugged_times.load() == plugged_in_;
}

std::int64_t DoubleDevice::now() const {
  const std::int64_t manual = state_->manual_time.load();
  if (manual >= 0) return manual;
  timespec time{};
  clock_gettime(CLOCK_MONOTONIC, &time);
  return std::int64_t{time.tv_sec} * 1'000'000'000 + time.tv_nsec;
}

bool DoubleDevice::begin_call() {
  if (!open_) return false;
  state_->calls.fetch_add(1);
  const int stall = state_->stall.exchange(0);
  if (stall > 0) sleep_for(stall * kMillisecond);
  if (!usable()) lose_power();
  const int every = state_->fail_every.load();
  const bool fails = every > 0 && ++turns_ % static_cast<std::uint64_t>(every) == 0;
  if (usable() && !fails) return true;
  state_->failed_calls.fetch_add(1);
  return false;
}

// Off the cable it forgets all that it was told.
void DoubleDevice::lose_power() {
  state_->forces_on.store(false);
  state_->powered.store(false);
  state_->gravity_compensated.store(false);
  display({});
}

void DoubleDevice::step() {
  const std::int64_t time = now();
  const double duration = std::min(1e-9 * static_cast<double>(time - state_->stepped_at.load()), kLongestStep);
  const int timeout = state_->command_timeout.load();
  if (timeout > 0 && time - state_->last_command.load() > timeout * kMillisecond) display({});
  state_->stepped_at.store(time);
  grip_->set_state({pose_of(state_->pose), {first_of(state_->twist), second_of(state_->twist)}});
  grip_->integrate(duration, {first_of(state_->displayed), second_of(state_->displayed)}, pose_of(state_->hand), {});
  const GripState& moved = grip_->state();
  store(state_->pose, moved.X_WG);
  store(state_->twist, moved.V_WG.linear, moved.V_WG.angular);
}

bool DoubleDevice::read(DoubleReading& reading) {
  const Guard guard(*this);
  if (!begin_call()) return false;
  step();
  reading = {grip_->state().X_WG, grip_->state().V_WG, state_->buttons.load(), state_->gripper.load(),
             state_->gripper_angle.load()};
  for (int i = 0; i < 3; ++i) reading.X.p[i] += state_->jump[static_cast<std::size_t>(i)].load();
  if (state_->frozen_pose.load()) {
    if (!is_frozen_) frozen_ = reading;
    reading = frozen_;
  }
  is_frozen_ = state_->frozen_pose.load();
  if (state_->nan_pose.load()) reading.X.p.x() = std::numeric_limits<double>::quiet_NaN();
  return true;
}

bool DoubleDevice::command(const Wrench& wrench, double gripper_force) {
  const Guard guard(*this);
  if (!begin_call()) return false;
  step();
  count(wrench);
  state_->gripper_force.store(gripper_force);
  const bool drives = state_->forces_on.load() && wrench.is_finite() && !state_->emergency_stop.load() &&
                      !state_->power_off.load() && !state_->hand_off.load();
  display(drives ? wrench : Wrench{});
  return true;
}

void DoubleDevice::display(const Wrench& wrench) {
  const bool turns = state_->degrees.load() == 6;
  store(state_->displayed, clipped(wrench.force, state_->max_force.load()),
        turns ? clipped(wrench.torque, state_->max_torque.load()) : Vector3(Vector3::Zero()));
}

void DoubleDevice::count(const Wrench& wrench) {
  const Wrench before{first_of(state_->commanded), second_of(state_->commanded)};
  if (!wrench.is_finite()) state_->bad_commands.fetch_add(1);
  raise(state_->largest_force, wrench.force.norm());
  raise(state_->largest_torque, wrench.torque.norm());
  raise(state_->largest_force_growth, wrench.force.norm() - before.force.norm());
  raise(state_->largest_torque_growth, wrench.torque.norm() - before.torque.norm());
  store(state_->commanded, wrench.force, wrench.torque);
  const std::int64_t time = now();
  DoubleCommand& kept = state_->commands[state_->command_count.load() % DoubleState::kCommands];
  kept.time.store(time);
  for (std::size_t i = 0; i < 3; ++i) {
    kept.force[i].store(wrench.force[static_cast<int>(i)]);
    kept.torque[i].store(wrench.torque[static_cast<int>(i)]);
  }
  state_->last_command.store(time);
  state_->command_count.fetch_add(1);
}

bool DoubleDevice::set_forces(bool on) {
  const Guard guard(*this);
  if (!usable()) return false;
  step();
  state_->forces_on.store(on);
  if (!on) display({});
  return true;
}

bool DoubleDevice::calibrate() {
  const Guard guard(*this);
  if (!usable() || state_->cannot_calibrate.load()) return false;
  state_->uncalibrated.store(false);
  state_->calibrations.fetch_add(1);
  return true;
}

}  // namespace tegotae::test
