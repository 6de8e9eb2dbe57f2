// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <string>
#include <vector>

namespace tegotae::bench {

/// A program that serves the live view, in a process of its own. It ends with this object, as by Ctrl-C.
class ServedProgram {
 public:
  /// Starts `command` and waits until it has printed its address. Throws std::runtime_error where it ends before.
  explicit ServedProgram(const std::vector<std::string>& command);
  ~ServedProgram();
  ServedProgram(const ServedProgram&) = delete;
  ServedProgram& operator=(const ServedProgram&) = delete;

  std::uint16_t port() const noexcept { return port_; }

  /// s of processor time of all its threads since it began, in steps of a clock tick (10 ms).
  double processor_time() const;

  /// How many of its threads run under SCHED_FIFO now.
  int real_time_threads() const;

  /// Asks it to end and waits for that. Throws std::runtime_error where it did not end well.
  void stop();

 private:
  void wait_for_address();

  pid_t process_ = 0;  ///< 0: has ended
  int output_ = -1;
  std::uint16_t port_ = 0;
};

}  // namespace tegotae::bench
