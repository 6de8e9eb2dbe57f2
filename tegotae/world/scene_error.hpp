// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>

namespace tegotae {

/// A scene that cannot be used. `what()` is one sentence that names the file, the line where it is known, what is wrong
/// and the mend.
struct SceneError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace tegotae
