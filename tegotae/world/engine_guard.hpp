// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <type_traits>
#include <vector>

namespace tegotae {

/// What MuJoCo said during guarded calls.
struct EngineMessages {
  std::vector<std::string> warnings;  ///< the first world_limits::kMaxKeptWarnings
  std::string error;                  ///< empty: none
};

/// Runs `call(context)` with MuJoCo's warnings and errors collected in `messages`; false if MuJoCo raised an error, at
/// which the call ends. Without this MuJoCo would write MUJOCO_LOG.TXT into the working folder and end the process.
/// The error leaves by longjmp, so `call` must own nothing that a destructor frees. Guards are per thread and nest.
/// The first one installs the process-wide handlers; messages of threads without a guard go to the handlers that stood
/// there before.
bool run_guarded(EngineMessages& messages, void (*call)(void*), void* context);

template <class Function>
bool run_guarded(EngineMessages& messages, Function&& function) {
  using Callable = std::remove_reference_t<Function>;
  return run_guarded(
      messages, [](void* context) { (*static_cast<Callable*>(context))(); }, &function);
}

}  // namespace tegotae
