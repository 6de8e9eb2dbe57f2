// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/doctor.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>

namespace tegotae {

std::string_view name_of(Verdict verdict) noexcept {
  switch (verdict) {
    case Verdict::kOk:
      return "ok";
    case Verdict::kCouldBeBetter:
      return "could be better";
    case Verdict::kNotPossible:
      return "not possible";
  }
  return "";
}

bool is_possible(std::span<const Finding> findings) noexcept {
  return std::none_of(findings.begin(), findings.end(),
                      [](const Finding& finding) { return finding.verdict == Verdict::kNotPossible; });
}

std::string findings_json(std::span<const Finding> findings) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Finding& finding : findings) {
    list.push_back({{"subject", finding.subject},
                    {"verdict", name_of(finding.verdict)},
                    {"found", finding.found},
                    {"mend", finding.mend}});
  }
  return list.dump(2) + "\n";
}

}  // namespace tegotae
