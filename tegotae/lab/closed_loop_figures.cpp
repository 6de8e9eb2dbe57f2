// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/closed_loop_figures.hpp>

#include <tegotae/math/rotation.hpp>

#include <fmt/format.h>

#include <numbers>
#include <utility>

namespace tegotae {
namespace {

constexpr double kDegreesPerRadian = 180.0 / std::numbers::pi;

using WrenchPart = PlainVector3 PlainWrench::*;

Quantity along(PlainWrench TickRecord::*wrench, WrenchPart part, const Vector3& axis) {
  return [=](const TickRecord& record, const SessionSettings&) { return axis.dot((record.*wrench.*part).vector()); };
}

Quantity apart(WrenchPart part, double scale) {
  return [=](const TickRecord& record, const SessionSettings&) {
    return scale * ((record.interface_wrench.*part).vector() - (record.displayed.*part).vector()).norm();
  };
}

Quantity position(PlainPose TickRecord::*pose, const Vector3& axis) {
  return [=](const TickRecord& record, const SessionSettings&) { return axis.dot((record.*pose).p.vector()); };
}

Quantity turn(PlainPose TickRecord::*pose, const Vector3& axis) {
  return [=](const TickRecord& record, const SessionSettings&) {
    return kDegreesPerRadian * axis.dot(rotation_vector((record.*pose).pose().q));
  };
}

// What there is in colour, and over it, thin and dashed, what it ought to be.
Panel both(std::string label, size_t variant, std::pair<const char*, Quantity> real,
           std::pair<const char*, Quantity> ideal) {
  return {
      std::move(label),
      {{real.first, variant, std::move(real.second), false}, {ideal.first, variant, std::move(ideal.second), true}}};
}

Panel difference(const char* label, size_t variant, WrenchPart part) {
  constexpr double kMilli = 1e3;
  return {label, {{"", variant, apart(part, kMilli), false}}};
}

Figure wrench_figure(const char* what, const std::string& label, const char* apart_label, WrenchPart part,
                     const Vector3& axis, size_t variant) {
  Figure figure;
  figure.name = fmt::format("displayed-{}", what);
  figure.title = fmt::format("The {}, commanded and displayed", what);
  figure.panels = {both(label, variant, {"displayed by the motors", along(&TickRecord::interface_wrench, part, axis)},
                        {"commanded", along(&TickRecord::displayed, part, axis)}),
                   difference(apart_label, variant, part)};
  return figure;
}

Figure pose_figure(const Experiment& experiment, size_t variant) {
  const ReportedAxis &way = experiment.force_axis, &axis = experiment.torque_axis;
  Figure figure;
  figure.name = "hand-and-tool";
  figure.title = "The tool, where the hand means it and where it is";
  figure.panels = {
      both(fmt::format("{} [m]", way.name), variant, {"tool", position(&TickRecord::X_WT, way.direction)},
           {"meant by the hand", position(&TickRecord::X_WH, way.direction)}),
      both(fmt::format("{{/Symbol q}}_{} [deg]", axis.name), variant, {"tool", turn(&TickRecord::X_WT, axis.direction)},
           {"meant by the hand", turn(&TickRecord::X_WH, axis.direction)})};
  return figure;
}

}  // namespace

std::vector<Figure> closed_loop_figures(const Experiment& experiment, const std::string& where) {
  const ReportedAxis &force = experiment.force_axis, &torque = experiment.torque_axis;
  std::vector<Figure> figures;
  for (size_t variant = 0; variant < experiment.variants.size(); ++variant) {
    const std::string& name = experiment.variants[variant].name;
    for (Figure figure :
         {wrench_figure("force", fmt::format("f_{} [N]", force.name), "|displayed - commanded| [mN]",
                        &PlainWrench::force, force.direction, variant),
          wrench_figure("torque", fmt::format("{{/Symbol t}}_{} [N m]", torque.name), "|displayed - commanded| [mN m]",
                        &PlainWrench::torque, torque.direction, variant),
          pose_figure(experiment, variant)}) {
      if (variant > 0) figure.name += "-" + name;
      figure.title +=
          (experiment.variants.size() > 1 ? fmt::format(" ({}; {})", name, where) : fmt::format(" ({})", where));
      figures.push_back(std::move(figure));
    }
  }
  return figures;
}

}  // namespace tegotae
