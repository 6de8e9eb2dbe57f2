// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace tegotae {

/// What nobody guesses: 128 bits from the system's source of randomness as 32 hexadecimal figures.
std::string random_token();

}  // namespace tegotae
