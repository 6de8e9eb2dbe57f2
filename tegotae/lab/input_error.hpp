// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>

namespace tegotae {

/// Something that a person gave and that cannot be used: a file, a folder, a name. `what()` is one sentence that names
/// it, with line and column where they are known, says what is wrong and how to mend it.
struct InputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace tegotae
