// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/run_metrics.hpp>

#include <tegotae/lab/passivity.hpp>
#include <tegotae/lab/pose_penetration.hpp>
#include <tegotae/render/render_types.hpp>

#include <algorithm>

namespace tegotae {

RunMetrics run_metrics(std::span<const TickRecord> records, const SceneGeometry& scene,
                       const SessionSettings& settings) {
  RunMetrics metrics;
  PosePenetration penetration(scene);
  PassivityObserver observer({settings.stiffness, settings.damping, settings.metric_length},
                             scene.tool.mass.centre_of_mass);
  for (const TickRecord& record : records) {
    metrics.proxy_penetration = std::max(metrics.proxy_penetration, penetration.at(record.X_WP));
    TickRecord of_method = record;
    of_method.displayed = record.wrench;
    observer.add(of_method);
    if (static_cast<RenderStatus>(record.status) != RenderStatus::kOk) ++metrics.not_ok;
    metrics.tick_times.add(record.tick_us * 1e-6);
  }
  metrics.energy_given = observer.given();
  metrics.energy_own = observer.allowed();
  metrics.energy_excess = observer.excess();
  return metrics;
}

}  // namespace tegotae
