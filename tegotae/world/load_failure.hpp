// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace tegotae {

/// One sentence about a scene that MuJoCo refused, made of the text that MuJoCo gave: file, line where known, what is
/// wrong, and the mend. Markup that a MuJoCo newer than 2.2.2 understands is said to need that.
std::string describe_load_failure(std::string_view file, std::string_view engine_text);

}  // namespace tegotae
