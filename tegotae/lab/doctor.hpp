// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tegotae {

/// What a finding about this machine means for force feedback at 1 kHz.
enum class Verdict : std::uint8_t { kOk, kCouldBeBetter, kNotPossible };

/// One thing that `tegotae doctor` looked at.
struct Finding {
  Verdict verdict = Verdict::kOk;
  std::string subject;  ///< what was looked at, a word or two
  std::string found;    ///< a sentence
  std::string mend;     ///< what to do, with the command or the line of a file; empty where all is well
};

/// "ok", "could be better", "not possible".
std::string_view name_of(Verdict verdict) noexcept;

/// Whether nothing is in the way.
bool is_possible(std::span<const Finding> findings) noexcept;

/// An array of {subject, verdict, found, mend}.
std::string findings_json(std::span<const Finding> findings);

}  // namespace tegotae
