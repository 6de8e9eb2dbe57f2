// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/contact_experiment.hpp>

#include <tegotae/lab/quantities.hpp>

#include <fmt/format.h>

namespace tegotae {

Experiment contact_experiment(const std::string& name, const std::string& summary, const std::string& scene,
                              double friction) {
  Experiment experiment;
  experiment.name = name;
  experiment.summary = summary;
  experiment.scene = scene;
  experiment.tool = "tool";
  experiment.settings.friction = friction;
  experiment.settings.metric_length = 0.0;
  experiment.variants = {{"only", "metric length of the tool's own gyration length", {}, {}}};
  experiment.force_axis = {"z", Vector3::UnitZ()};
  experiment.torque_axis = {"y", Vector3::UnitY()};
  return experiment;
}

Figure wrench_over_time(const Experiment& experiment, const std::string& title, const ReportedAxis& way) {
  const ReportedAxis &force = experiment.force_axis, &torque = experiment.torque_axis;
  Figure figure{.name = "force-and-torque", .title = title};
  figure.panels = {{fmt::format("{} [m]", way.name), {{way.name, 0, position_along(way.direction), false}}},
                   {fmt::format("f_{} [N]", force.name), {{"f_" + force.name, 0, force_along(force.direction), false}}},
                   {fmt::format("{{/Symbol t}}_{} [N m]", torque.name),
                    {{"{/Symbol t}_" + torque.name, 0, torque_along(torque.direction), false}}}};
  return figure;
}

}  // namespace tegotae
