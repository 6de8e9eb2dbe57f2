// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

namespace tegotae {

/// Told, from time to time, which part of a long work is done (0 to 1).
using Progress = std::function<void(double)>;

}  // namespace tegotae
