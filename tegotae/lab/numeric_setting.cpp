// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/numeric_setting.hpp>

#include <tegotae/lab/input_error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace tegotae {
namespace {

using Request = SettingsRequest;

// Rates: below the least nothing is felt as firm, above the most no interface is served. Margins: from a rounding error
// to the size of a room.
constexpr NumericSetting kSettings[] = {
    {"stiffness", &Request::stiffness, 1e-3, 1e6, "N/m", false, false, false,
     "Stiffness k of the coupling; default: the scene's, else 1000"},
    {"damping", &Request::damping, 0.0, 1e4, "N s/m", false, false, false,
     "Damping d of the coupling; default: the scene's, else 0"},
    {"metric_length", &Request::metric_length, 1e-6, 1e3, "m", true, false, false,
     "Length l that weighs rotation against translation, or 'gyration' for the tool's gyration length; default: the "
     "scene's, else the method's (paper: 1, others: gyration)"},
    {"rotational_stiffness", &Request::rotational_stiffness, 1e-9, 1e9, "N m/rad", false, false, false,
     "Rotational stiffness k l^2, in place of the metric length"},
    {"rotational_damping", &Request::rotational_damping, 0.0, 1e4, "N m s/rad", false, false, false,
     "Rotational damping; default: the scene's, else d l^2"},
    {"physics_rate", &Request::physics_rate, 1.0, 2000.0, "Hz", false, false, false,
     "Rate of the physics steps; default: the scene's, else 500, and in real time what the scene affords"},
    {"haptic_rate", &Request::haptic_rate, 10.0, 20000.0, "Hz", false, false, false,
     "Rate of the haptic ticks; default: the scene's, else 1000"},
    {"margin", &Request::margin, 1e-6, 10.0, "m", false, false, false,
     "Distance below which objects are near, beyond what the speeds ask for; default: the scene's, else 0.002"},
    {"contact_margin", &Request::contact_margin, 1e-5, 0.1, "m", false, true, false,
     "How far one linearisation may move the tool; default: the scene's, else 0.001"},
    {"friction", &Request::friction, 0.0, 10.0, "", false, true, false,
     "Coefficient of sliding friction of all contacts; default: the scene's, else that of each geom"},
    {"kinetic_friction", &Request::kinetic_friction, 0.0, 1.0, "", false, true, false,
     "Friction while slipping, as a part of the coefficient; default: the scene's, else 1"},
    {"viscous_friction", &Request::viscous_friction, 0.0, 1e4, "N s/m", false, true, false,
     "Viscous friction of a sliding contact; default: the scene's, else 0"},
    {"tool_weight", &Request::tool_weight, 0.0, 1.0, "", false, true, true,
     "The tool's own weight is felt; default: the scene's, else off"},
    {"tool_inertia", &Request::tool_inertia, 0.0, 1.0, "", false, true, true,
     "The tool's own inertia is felt; default: the scene's, else off"},
    {"transient", &Request::transient, 0.0, 1e4, "N s/m", false, true, false,
     "Amplitude of the short vibration at an impact, per speed of it; default: the scene's, else 0"},
    {"translation_scale", &Request::translation_scale, 1e-3, 1e3, "", false, false, false,
     "How many times as far as the grip the tool moves; default: 1", true},
    {"rotation_scale", &Request::rotation_scale, 0.1, 10.0, "", false, false, false,
     "How many times as far as the grip the tool turns; default: 1", true},
    {"force_scale", &Request::force_scale, 1e-3, 1e3, "", false, false, false,
     "N displayed for a newton of the world (torque follows, so that power is scaled by one number); default: 1", true},
    {"clutch_button", &Request::clutch_button, 0.0, 31.0, "", false, false, false,
     "Button of the interface, from 0, that lets the grip move without the tool while it is held down; default: none",
     true, true},
    {"dead_man_button", &Request::dead_man_button, 0.0, 31.0, "", false, false, false,
     "Button of the interface, from 0, that must be held down for anything to be displayed; default: none", true, true},
    {"energy_bound", &Request::energy_bound, 0.0, 1.0, "", false, false, true,
     "Keeps what is displayed from giving the hand energy that it did not put in; default: on where a hand holds the "
     "interface",
     true},
    {"beyond_rating", &Request::beyond_rating, 0.0, 1.0, "", false, false, true,
     "Stiffness and damping may exceed what the interface is rated for; limits of force and torque hold all the same; "
     "default: off",
     true},
};

std::string in_words(std::string_view name) {
  std::string words(name);
  std::replace(words.begin(), words.end(), '_', ' ');
  return words;
}

}  // namespace

std::span<const NumericSetting> numeric_settings() noexcept { return kSettings; }

void check_range(const NumericSetting& setting, double value) {
  const bool inside = value >= setting.least && value <= setting.most;
  if (setting.is_switch && value != 0.0 && value != 1.0) {
    throw InputError(fmt::format("the {} is 1 (on) or 0 (off), not {:g}.", in_words(setting.name), value));
  }
  if (setting.is_whole && inside && value != std::floor(value)) {
    throw InputError(fmt::format("the {} is a whole number, not {:g}.", in_words(setting.name), value));
  }
  if (std::isfinite(value) && (inside || (setting.zero_too && value == 0.0))) return;
  const std::string unit = setting.unit.empty() ? "" : fmt::format(" {}", setting.unit);
  throw InputError(fmt::format("the {} of {:g}{} is out of range; permitted are {:g} to {:g}{}.",
                               in_words(setting.name), value, unit, setting.least, setting.most, unit));
}

}  // namespace tegotae
