// SPDX-License-Identifier: Apache-2.0
#include <tegotae/device/spidar_presets.hpp>

#include <cmath>
#include <initializer_list>
#include <stdexcept>

namespace tegotae {
namespace {

/// Corner of the frame and place of the knot, as signs in the left-handed frame of the tables: x right, y up, z away.
struct Pairing {
  Vector3 corner;
  Vector3 knot;
};
using Table = std::array<Pairing, kSpidarStrings>;

const Table& x3r_table() {
  static const Table table{{{{-1, -1, 1}, {-1, 0, 0}},
                            {{1, -1, 1}, {1, 0, 0}},
                            {{1, -1, -1}, {0, -1, 0}},
                            {{-1, -1, -1}, {0, -1, 0}},
                            {{-1, 1, 1}, {-1, 0, 0}},
                            {{1, 1, 1}, {1, 0, 0}},
                            {{1, 1, -1}, {0, 1, 0}},
                            {{-1, 1, -1}, {0, 1, 0}}}};
  return table;
}

const Table& x3l_table() {
  static const Table table{{{{1, 1, -1}, {0, 0, -1}},
                            {{1, 1, 1}, {0, 0, 1}},
                            {{-1, 1, 1}, {0, 1, 0}},
                            {{-1, 1, -1}, {0, 1, 0}},
                            {{1, -1, -1}, {0, 0, -1}},
                            {{1, -1, 1}, {0, 0, 1}},
                            {{-1, -1, 1}, {0, -1, 0}},
                            {{-1, -1, -1}, {0, -1, 0}}}};
  return table;
}

const Table& x3f_table() {
  static const Table table{{{{-1, -1, 1}, {-1, 0, 0}},
                            {{1, -1, 1}, {0, 0, 1}},
                            {{1, -1, -1}, {1, 0, 0}},
                            {{-1, -1, -1}, {0, 0, -1}},
                            {{-1, 1, 1}, {-1, 0, 0}},
                            {{1, 1, 1}, {0, 0, 1}},
                            {{1, 1, -1}, {1, 0, 0}},
                            {{-1, 1, -1}, {0, 0, -1}}}};
  return table;
}

// Each corner holds the same knot as in the X3R's table; the motors are numbered otherwise.
const Table& x4_table() {
  static const Table table{{{{1, -1, -1}, {0, -1, 0}},
                            {{1, -1, 1}, {1, 0, 0}},
                            {{-1, -1, 1}, {-1, 0, 0}},
                            {{-1, -1, -1}, {0, -1, 0}},
                            {{1, 1, -1}, {0, 1, 0}},
                            {{1, 1, 1}, {1, 0, 0}},
                            {{-1, 1, 1}, {-1, 0, 0}},
                            {{-1, 1, -1}, {0, 1, 0}}}};
  return table;
}

struct Build {
  Vector3 frame;        // m, edges x, y, z of the table's frame
  double knots;         // m, from the grip's origin
  double turn_degrees;  // of frame and knots about the table's y axis, as a matrix in the table's coordinates
  double metres_per_pulse, volts_per_newton, min_tension;
  std::initializer_list<std::size_t> counts_reversed, volts_reversed;
};

SpidarGeometry build(const char* name, const Table& table, const Build& numbers) {
  constexpr double kDegree = 3.14159265358979323846 / 180.0;
  const Matrix3 turn = Eigen::AngleAxisd(numbers.turn_degrees * kDegree, Vector3::UnitY()).toRotationMatrix();
  SpidarGeometry geometry;
  geometry.name = name;
  for (std::size_t i = 0; i < table.size(); ++i) {
    SpidarString& string = geometry.strings[i];
    string.motor_S = from_left_handed(turn * (0.5 * numbers.frame.cwiseProduct(table[i].corner)));
    string.knot_G = from_left_handed(turn * (numbers.knots * table[i].knot));
    string.metres_per_pulse = numbers.metres_per_pulse;
    string.volts_per_newton = numbers.volts_per_newton;
    string.min_tension = numbers.min_tension;
    string.max_tension = 20.0;
  }
  for (const std::size_t i : numbers.counts_reversed) geometry.strings[i].metres_per_pulse *= -1.0;
  for (const std::size_t i : numbers.volts_reversed) geometry.strings[i].volts_per_newton *= -1.0;
  return geometry;
}

// Pulley of 8 mm, 0.0438 N m/A, 0.5 A/V.
constexpr double kX3VoltsPerNewton = 8e-3 / 0.0438 / 0.5;
constexpr double kX3MetresPerPulse = 1.66555e-5;

SpidarGeometry x3(const char* name, const Table& table) {
  return build(name, table,
               {{0.120, 0.152, 0.120}, 0.0225, -45.0, kX3MetresPerPulse, kX3VoltsPerNewton, 0.3, {2, 3, 4, 5}, {}});
}

SpidarGeometry x3f() {
  return build("x3f", x3f_table(),
               {{0.120, 0.146, 0.120}, 0.016, 0.0, kX3MetresPerPulse, kX3VoltsPerNewton, 0.3, {2, 3, 4, 5}, {}});
}

SpidarGeometry x4(const char* name) {
  return build(name, x4_table(), {{0.138, 0.190, 0.138}, 0.0225, 0.0, 3.485e-5, 0.08, 0.2, {0, 1, 6, 7}, {2, 3, 4, 5}});
}

const auto& presets() {
  static const std::array<SpidarPreset, 5> all{
      {{"x3r", "as published; not run on hardware", x3("x3r", x3r_table())},
       {"x3l", "as published; not run on hardware", x3("x3l", x3l_table())},
       {"x3f", "refused: as published all knots turn the grip the same way, so that it has no force closure", x3f(),
        true},
       {"x4r", "as published, where its revisions differ; unverified: compare motors and signs with yours", x4("x4r")},
       {"x4l", "as published, where its revisions differ; unverified: compare motors and signs with yours",
        x4("x4l")}}};
  return all;
}

}  // namespace

std::span<const SpidarPreset> spidar_presets() { return presets(); }

const SpidarPreset& spidar_preset(std::string_view name) {
  std::string names;
  for (const SpidarPreset& preset : presets()) {
    if (preset.name == name) return preset;
    names.append(names.empty() ? "" : ", ").append(preset.name);
  }
  throw std::invalid_argument("there is no SPIDAR '" + std::string(name) + "'; there are: " + names + ".");
}

}  // namespace tegotae
