// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>

namespace tegotae {

/// Now by the system's clock: milliseconds since the Unix epoch.
inline double unix_milliseconds() {
  return std::chrono::duration<double, std::milli>(std::chrono::system_clock::now().time_since_epoch()).count();
}

}  // namespace tegotae
