// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/math/pose.hpp>
#include <tegotae/math/wrench.hpp>

#include <tests/doubles/double_state.hpp>

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <new>
#include <stdexcept>
#include <string>

namespace tegotae::test {

/// A simulated device on its cable, for one test: makes the file, names it in this process' environment (which children
/// inherit) and takes both back. No test library may be in a call, nor a device open, when it goes.
class DoubleStateFile {
 public:
  explicit DoubleStateFile(const char* model) {
    path_ = (std::filesystem::temp_directory_path() / "tegotae-double-XXXXXX").string();
    const int file = mkstemp(path_.data());
    if (file < 0 || ftruncate(file, sizeof(DoubleState)) != 0) throw std::runtime_error("no file for a double");
    memory_ = mmap(nullptr, sizeof(DoubleState), PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
    close(file);
    if (memory_ == MAP_FAILED) throw std::runtime_error("no memory for a double");
    state_ = new (memory_) DoubleState;
    std::strncpy(state_->model.data(), model, state_->model.size() - 1);
    setenv(kDoubleStateVariable, path_.c_str(), 1);
  }
  DoubleStateFile(const DoubleStateFile&) = delete;
  DoubleStateFile& operator=(const DoubleStateFile&) = delete;
  ~DoubleStateFile() {
    unsetenv(kDoubleStateVariable);
    munmap(memory_, sizeof(DoubleState));
    unlink(path_.c_str());
  }

  DoubleState* operator->() const noexcept { return state_; }
  DoubleState& operator*() const noexcept { return *state_; }
  const std::string& path() const noexcept { return path_; }

  void unplug() const noexcept {
    state_->unplugged_times.fetch_add(1);
    state_->unplugged.store(true);
  }
  void plug_in() const noexcept { state_->unplugged.store(false); }

  /// Where the hand means to be, in the maker's axes. Not torn enough to matter: the double reads number by number.
  void move_hand(const Pose& X) const noexcept { store(state_->hand, X); }
  /// Puts the grip there at rest, and the hand with it. Only while nobody has it open.
  void place(const Pose& X) const noexcept {
    move_hand(X);
    store(state_->pose, X);
    for (auto& each : state_->twist) each.store(0.0);
  }
  Pose pose() const noexcept {
    const auto& s = state_->pose;
    return {{s[0].load(), s[1].load(), s[2].load()}, {s[3].load(), s[4].load(), s[5].load(), s[6].load()}};
  }
  /// What the motors give now, in the maker's axes: zero where it is not plugged in.
  Wrench displayed() const noexcept { return state_->unplugged.load() ? Wrench{} : wrench(state_->displayed); }
  Wrench commanded() const noexcept { return wrench(state_->commanded); }

 private:
  static void store(std::array<std::atomic<double>, 7>& to, const Pose& X) noexcept {
    const double values[] = {X.p.x(), X.p.y(), X.p.z(), X.q.w(), X.q.x(), X.q.y(), X.q.z()};
    for (std::size_t i = 0; i < to.size(); ++i) to[i].store(values[i]);
  }
  static Wrench wrench(const std::array<std::atomic<double>, 6>& s) noexcept {
    return {{s[0].load(), s[1].load(), s[2].load()}, {s[3].load(), s[4].load(), s[5].load()}};
  }

  std::string path_;
  void* memory_ = nullptr;
  DoubleState* state_ = nullptr;
};

}  // namespace tegotae::test
