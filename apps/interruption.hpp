// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <stdexcept>
#include <string>

namespace tegotae {

/// Becomes true with the first SIGINT, SIGTERM or SIGHUP after `listen_for_interruption`, or by `interrupt`.
const std::atomic<bool>& interrupted() noexcept;

/// From here on those signals no longer end the program: what runs looks at `interrupted`, leaves the interface at zero
/// and its files whole. A signal that is ignored already (by nohup, say) stays ignored.
void listen_for_interruption();

/// As if such a signal had come, without its number. Any thread.
void interrupt() noexcept;

/// A command that a signal ended early. `what()` is one sentence.
class Interruption : public std::runtime_error {
 public:
  /// To be thrown once `interrupted`.
  explicit Interruption(const std::string& what);

  /// As shells have it: 128 and the number of the signal.
  int exit_code() const noexcept { return exit_code_; }

 private:
  int exit_code_;
};

}  // namespace tegotae
