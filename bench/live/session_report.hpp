// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bench/live/measured_session.hpp>

#include <string>

namespace tegotae::bench {

/// Figures of a session as a JSON object, with the units in the names.
std::string json_of(const SessionFigures& figures);

/// The same as tables for people.
std::string text_of(const SessionFigures& figures);

}  // namespace tegotae::bench
