// SPDX-License-Identifier: Apache-2.0
#include <tegotae/world/engine_guard.hpp>

#include <tegotae/world/limits.hpp>

#include <mujoco/mujoco.h>

#include <csetjmp>
#include <cstdio>
#include <cstdlib>

namespace tegotae {
namespace {

using Handler = void (*)(const char*);

struct Guard {
  EngineMessages* messages = nullptr;
  Guard* outer = nullptr;
  std::jmp_buf jump;
};

thread_local Guard* innermost_guard = nullptr;
Handler handler_of_warnings_before = nullptr;
Handler handler_of_errors_before = nullptr;

void handle_warning(const char* text) {
  if (innermost_guard != nullptr) {
    auto& warnings = innermost_guard->messages->warnings;
    if (warnings.size() < static_cast<size_t>(world_limits::kMaxKeptWarnings)) warnings.emplace_back(text);
  } else if (handler_of_warnings_before != nullptr) {
    handler_of_warnings_before(text);
  } else {
    std::fprintf(stderr, "MuJoCo warns: %s\n", text);
  }
}

void handle_error(const char* text) {
  if (innermost_guard != nullptr) {
    innermost_guard->messages->error = text;
    std::longjmp(innermost_guard->jump, 1);  // NOLINT(cert-err52-cpp): through frames of C alone
  }
  if (handler_of_errors_before != nullptr) return handler_of_errors_before(text);
  std::fprintf(stderr, "MuJoCo fails: %s\n", text);
  std::abort();  // MuJoCo does not go on after an error
}

bool install_handlers() {
  handler_of_warnings_before = mju_user_warning;
  handler_of_errors_before = mju_user_error;
  mju_user_warning = handle_warning;
  mju_user_error = handle_error;
  return true;
}

// Apart from the caller, so that no variable lives in registers across setjmp.
bool call_within(Guard& guard, void (*call)(void*), void* context) {
  if (setjmp(guard.jump) != 0) return false;  // NOLINT(cert-err52-cpp)
  call(context);
  return true;
}

}  // namespace

bool run_guarded(EngineMessages& messages, void (*call)(void*), void* context) {
  static const bool installed = install_handlers();
  static_cast<void>(installed);
  Guard guard{&messages, innermost_guard, {}};
  innermost_guard = &guard;
  const bool finished = call_within(guard, call, context);
  innermost_guard = guard.outer;
  return finished;
}

}  // namespace tegotae
