// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>

#include <string>

namespace tegotae {

// Checks of what an option is given. Each says what the option takes.

/// A decimal number, with the unit that the sentence names ("takes a number in N/m, not 'stiff'"). Its range is checked
/// with the settings.
CLI::Validator number_in(const std::string& unit);

/// A whole number within these bounds ("takes a port from 0 to 65535, not '99999'").
CLI::Validator whole_number(const std::string& what, long least, long most);

/// Anything but nothing ("takes a folder, not ''").
CLI::Validator not_empty(const std::string& what);

}  // namespace tegotae
