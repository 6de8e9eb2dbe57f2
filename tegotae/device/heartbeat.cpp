// SPDX-License-Identifier: Apache-2.0
#include <tegotae/device/heartbeat.hpp>

#include <tegotae/device/interface_driver.hpp>

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <new>
#include <string>

namespace tegotae {
namespace {

[[noreturn]] void refuse_heartbeat(const char* why) {
  throw InterfaceError(std::string("no memory can be shared with the process that guards the interface: ") + why + ".");
}

// Above those of standard input, output and error: where one of these was closed, the memory must not take its place.
int new_memory() {
  const int made = memfd_create("tegotae-heartbeat", MFD_CLOEXEC);
  if (made < 0 || made > STDERR_FILENO) return made;
  const int result = fcntl(made, F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
  const int error = errno;
  close(made);
  errno = error;
  return result;
}

}  // namespace

HeartbeatMemory::HeartbeatMemory() : descriptor_(new_memory()), owns_descriptor_(true) {
  if (descriptor_ < 0) refuse_heartbeat(std::strerror(errno));  // NOLINT(concurrency-mt-unsafe)
  if (ftruncate(descriptor_, sizeof(Heartbeat)) != 0) {
    close(descriptor_);
    refuse_heartbeat("it cannot be made large enough");
  }
  map();
  new (heart_) Heartbeat;
}

HeartbeatMemory::HeartbeatMemory(int descriptor) : descriptor_(descriptor) {
  struct stat found {};
  if (fstat(descriptor_, &found) != 0 || found.st_size != sizeof(Heartbeat)) {
    refuse_heartbeat("the descriptor that was inherited is none of it");
  }
  map();
}

HeartbeatMemory::~HeartbeatMemory() {
  munmap(heart_, sizeof(Heartbeat));
  if (owns_descriptor_) close(descriptor_);
}

void HeartbeatMemory::map() {
  void* memory = mmap(nullptr, sizeof(Heartbeat), PROT_READ | PROT_WRITE, MAP_SHARED, descriptor_, 0);
  if (memory == MAP_FAILED) {
    if (owns_descriptor_) close(descriptor_);
    refuse_heartbeat(std::strerror(errno));  // NOLINT(concurrency-mt-unsafe)
  }
  heart_ = static_cast<Heartbeat*>(memory);
}

InterfaceStatus BeatingInterface::read(double time, InterfaceState& state) noexcept {
  const double period = std::clamp(time - last_read_, 0.0, Heartbeat::kSlowest);
  last_read_ = time;
  heart_.period.store(period, std::memory_order_relaxed);  // seen with the beat that follows
  return interface_.read(time, state);
}

// A call that hangs on its way to a force must not look like one to zero, so `displays` rises before the call and falls
// after it.
InterfaceStatus BeatingInterface::write(const InterfaceCommand& command) noexcept {
  const bool is_zero =
      command.wrench.force.isZero(0.0) && command.wrench.torque.isZero(0.0) && command.gripper_force == 0.0;
  if (!is_zero) heart_.displays.store(true, std::memory_order_release);
  const InterfaceStatus status = interface_.write(command);
  if (is_zero && status == InterfaceStatus::kOk) heart_.displays.store(false, std::memory_order_release);
  heart_.beats.fetch_add(1, std::memory_order_release);
  return status;
}

bool Standstill::see(double time, const Heartbeat& heart) noexcept {
  const std::uint64_t beats = heart.beats.load(std::memory_order_acquire);
  if (!has_seen_ || beats != beats_ || !heart.displays.load(std::memory_order_acquire)) {
    has_seen_ = true;
    beats_ = beats;
    since_ = time;
  }
  return time - since_ >= std::max(kLongest, kPeriods * heart.period.load(std::memory_order_relaxed));
}

}  // namespace tegotae
