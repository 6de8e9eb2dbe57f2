// SPDX-License-Identifier: Apache-2.0
#include <tegotae/render/rendering_method.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>
#include <string>

namespace tegotae {
namespace {

constexpr MethodName kMethods[] = {
    {"paper", "Susu and Hasegawa: least displacement that frees the penetrating contact points"},
    {"proxy", "where the tool may be, contacts refreshed at the haptic rate, with friction"},
    {"adachi", "Adachi, Kumano and Ogino: one point and one plane, force only"},
    {"berkelman", "Berkelman and Hollis: a spring at each penetrating contact point, summed"},
    {"otaduy-lin", "Otaduy and Lin: tool with mass, penalty contact, implicit integration, virtual coupling"},
    {"ortega", "Ortega, Redon and Coquillart: god-object, constrained minus unconstrained acceleration"},
};

// Ranges beyond which a setting is a slip of the pen: no interface displays more, no tool is larger.
constexpr double kMaxStiffness = 1e6;     // N/m
constexpr double kMaxDamping = 1e4;       // N s/m
constexpr double kMaxMetricLength = 1e3;  // m

void require_range(const char* what, double value, double least, double most, const char* unit) {
  if (std::isfinite(value) && value >= least && value <= most) return;
  throw std::invalid_argument(std::string(what) + " " + std::to_string(value) + " " + unit + " is out of range: " +
                              std::to_string(least) + " to " + std::to_string(most) + " " + unit);
}

Coupling make_coupling(const MethodSettings& settings, double default_metric_length) {
  const double metric_length = settings.metric_length.value_or(default_metric_length);
  require_range("stiffness", settings.stiffness, 1e-3, kMaxStiffness, "N/m");
  require_range("damping", settings.damping, 0.0, kMaxDamping, "N s/m");
  require_range("metric length", metric_length, 1e-6, kMaxMetricLength, "m");
  if (settings.rotational_damping) {
    require_range("rotational damping", *settings.rotational_damping, 0.0, kMaxDamping, "N m s/rad");
  }
  return {settings.stiffness, settings.damping, metric_length, settings.rotational_damping};
}

[[noreturn]] void throw_unknown(std::string_view name) {
  std::string names;
  for (const MethodName& method : kMethods) names.append(names.empty() ? "" : ", ").append(method.name);
  throw std::invalid_argument("there is no method '" + std::string(name) + "'; there are: " + names);
}

ProxyMethod::Parameters proxy_parameters(const MethodSettings& settings, const Tool& tool) {
  constexpr double kMaxFriction = 10.0, kMaxViscous = 1e4, kMaxGravity = 1e3;
  require_range("friction scale", settings.friction_scale, 0.0, kMaxFriction, "");
  if (settings.friction) require_range("friction", *settings.friction, 0.0, kMaxFriction, "");
  require_range("kinetic friction", settings.kinetic_friction, 0.0, 1.0, "of the static");
  require_range("viscous friction", settings.viscous_friction, 0.0, kMaxViscous, "N s/m");
  require_range("contact margin", settings.contact_margin, 1e-5, 0.1, "m");
  require_range("gravity", settings.gravity.norm(), 0.0, kMaxGravity, "m/s^2");
  require_range("transient amplitude", settings.transient.amplitude, 0.0, kMaxDamping, "N s/m");
  require_range("transient frequency", settings.transient.frequency, 1.0, 1e3, "Hz");
  require_range("transient decay", settings.transient.decay, 1.0, 1e4, "1/s");
  ProxyMethod::Parameters parameters;
  parameters.coupling = make_coupling(settings, default_metric_length("proxy", tool));
  parameters.margin = settings.contact_margin;
  parameters.friction = settings.friction;
  parameters.friction_scale = settings.friction_scale;
  parameters.kinetic_friction = settings.kinetic_friction;
  parameters.viscous_friction = settings.viscous_friction;
  parameters.weight = settings.tool_weight;
  parameters.inertia = settings.tool_inertia;
  parameters.gravity = settings.gravity;
  parameters.transient = settings.transient;
  return parameters;
}

}  // namespace

std::span<const MethodName> method_names() noexcept { return kMethods; }

double default_metric_length(std::string_view name, const Tool& tool) {
  constexpr double kPaperMetricLength = 1.0;
  return name == "paper" ? kPaperMetricLength : tool.mass.gyration_length();
}

RenderingMethod make_method(std::string_view name, const MethodSettings& settings, const SceneGeometry& geometry) {
  const Tool& tool = geometry.tool;
  const auto is_known = [name](const MethodName& method) { return method.name == name; };
  if (std::none_of(std::begin(kMethods), std::end(kMethods), is_known)) throw_unknown(name);
  if (name == "proxy") return ProxyMethod(proxy_parameters(settings, tool), geometry);
  const Coupling coupling = make_coupling(settings, default_metric_length(name, tool));
  const Vector3& p_TCm = tool.mass.centre_of_mass;
  if (name == "adachi") return AdachiMethod(coupling, p_TCm);
  if (name == "berkelman") return BerkelmanMethod(coupling, p_TCm);
  if (name == "otaduy-lin") return OtaduyLinMethod({coupling}, tool.mass);
  if (name == "ortega") return OrtegaMethod(coupling, tool.mass);
  return PaperMethod({coupling, settings.constraint_set}, p_TCm);
}

ModelNeeds needs_of(const RenderingMethod& method) noexcept {
  return std::holds_alternative<ProxyMethod>(method) ? ProxyMethod::needs() : ModelNeeds{};
}

}  // namespace tegotae
