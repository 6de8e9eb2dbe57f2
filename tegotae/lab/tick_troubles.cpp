// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/tick_troubles.hpp>

#include <tegotae/render/render_types.hpp>
#include <tegotae/runtime/safety.hpp>

#include <fmt/format.h>

namespace tegotae {
namespace {

constexpr std::uint32_t bit(SafetyEvent event) { return 1U << static_cast<unsigned>(event); }

}  // namespace

void TickTroubles::add(const TickRecord& record) {
  ++ticks_;
  const auto status = static_cast<RenderStatus>(record.status);
  if (status != RenderStatus::kOk) ++statuses_[name_of(status)];
  dropped_ += static_cast<std::uint64_t>(record.dropped);
  constexpr std::uint32_t kSaturated = bit(SafetyEvent::kForceSaturated) | bit(SafetyEvent::kTorqueSaturated);
  if ((record.safety_events & kSaturated) != 0) ++saturated_;
}

std::string TickTroubles::sentence() const {
  std::string text;
  const auto append = [&text](const std::string& part) { text += (text.empty() ? "" : "; ") + part; };
  for (const auto& [status, count] : statuses_) append(fmt::format("status '{}' in {} ticks", status, count));
  if (dropped_ > 0) append(fmt::format("{} planes, points and pairs beyond a capacity or budget left out", dropped_));
  if (saturated_ > 0) append(fmt::format("displayed force or torque cut to its limit in {} ticks", saturated_));
  return text.empty() ? text : fmt::format("of {} ticks: {}", ticks_, text);
}

}  // namespace tegotae
