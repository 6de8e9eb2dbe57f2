// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/spidar_workspace.hpp>

#include <tegotae/lab/axes.hpp>
#include <tegotae/lab/gnuplot.hpp>
#include <tegotae/lab/text_file.hpp>
#include <tegotae/math/rotation.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <string>

namespace tegotae {
namespace {

constexpr int kCells = 80;  // of a map, along each axis
constexpr const char* kAxes[] = {"x", "y", "z"};

// A plane through the middle of the frame, as one looks at it.
struct Slice {
  int across, up;  ///< axes of S
  const char* title;
};
constexpr Slice kSlices[] = {
    {0, 2, "from the front, y = 0"}, {1, 2, "from the right, x = 0"}, {0, 1, "from above, z = 0"}};

bool holds(const SpidarGeometry& geometry, const Pose& X_SG) { return spidar_reach(geometry, X_SG).force > 0.0; }

// The first place along `at`, from 0 on, where the strings no longer hold the grip.
template <class PoseAt>
double limit_along(const SpidarGeometry& geometry, double step, double greatest, double accuracy, const PoseAt& at) {
  double inside = 0.0;
  while (inside < greatest && holds(geometry, at(std::min(inside + step, greatest)))) inside += step;
  if (inside >= greatest) return greatest;
  double outside = inside + step;
  while (outside - inside > accuracy) {
    const double middle = 0.5 * (inside + outside);
    (holds(geometry, at(middle)) ? inside : outside) = middle;
  }
  return inside;
}

// Half the way between the motors along each axis, m.
Vector3 half_frame(const SpidarGeometry& geometry) {
  Vector3 half = Vector3::Zero();
  for (const SpidarString& string : geometry.strings) half = half.cwiseMax(string.motor_S.cwiseAbs());
  return half;
}

std::string position_table(const SpidarGeometry& geometry) {
  std::string text = fmt::format(
      "# SPIDAR '{}': greatest force and torque in every direction, grip unrotated\n"
      "# nan: the strings do not hold the grip there\nplane,x[m],y[m],z[m],force[N],torque[N m]\n",
      geometry.name);
  const Vector3 half = half_frame(geometry);
  for (const Slice& slice : kSlices) {
    for (int j = 0; j <= kCells; ++j) {
      for (int i = 0; i <= kCells; ++i) {
        Vector3 p = Vector3::Zero();
        p[slice.across] = half[slice.across] * (2.0 * i / kCells - 1.0);
        p[slice.up] = half[slice.up] * (2.0 * j / kCells - 1.0);
        const SpidarReach reach = spidar_reach(geometry, {p, Quaternion::Identity()});
        const bool is_held = reach.force > 0.0;
        fmt::format_to(std::back_inserter(text), "{}{},{:.6g},{:.6g},{:.6g},{:.5g},{:.5g}\n", kAxes[slice.across],
                       kAxes[slice.up], p.x(), p.y(), p.z(), is_held ? reach.force : std::nan(""),
                       is_held ? reach.torque : std::nan(""));
      }
      text += "\n";  // a row of the map
    }
    text += "\n";
  }
  return text;
}

std::string rotation_table(const SpidarGeometry& geometry) {
  constexpr int kGreatest = 90;  // degrees; beyond, strings cross the grip
  std::string text = fmt::format(
      "# SPIDAR '{}': greatest force and torque in every direction, in the middle of the frame\n"
      "# nan: the strings do not hold the grip there\naxis,angle[deg],force[N],torque[N m]\n",
      geometry.name);
  for (int axis = 0; axis < 3; ++axis) {
    for (int angle = -kGreatest; angle <= kGreatest; ++angle) {
      const Pose X_SG{Vector3::Zero(), rotation_from_vector(angle * kDegree * Vector3::Unit(axis))};
      const SpidarReach reach = spidar_reach(geometry, X_SG);
      const bool is_held = reach.force > 0.0;
      fmt::format_to(std::back_inserter(text), "{},{},{:.5g},{:.5g}\n", kAxes[axis], angle,
                     is_held ? reach.force : std::nan(""), is_held ? reach.torque : std::nan(""));
    }
    text += "\n\n";
  }
  return text;
}

// What gnuplot reads best: the names in a comment, blanks between the values.
std::string with_blanks(std::string csv) {
  const size_t names = csv.find('\n', csv.rfind('#')) + 1;
  csv.insert(names, "# ");
  std::replace(csv.begin(), csv.end(), ',', ' ');
  return csv;
}

void write_figure(const std::filesystem::path& folder, const std::string& name, const std::string& csv,
                  const std::string& script) {
  write_text(folder / (name + ".csv"), csv);
  write_text(folder / (name + ".dat"), with_blanks(csv));
  write_text(folder / (name + ".gnuplot"), script);
  run_gnuplot(name, folder);
}

// One map: colours, lines of equal value, the motors, and the cube of 40 mm in which the accuracy of poses is stated.
std::string map_commands(const Slice& slice, int index, int column, const Vector3& half, double step) {
  const double across = 1e3 * half[slice.across], up = 1e3 * half[slice.up];
  const std::string points =
      fmt::format("index {} using (1e3*column({})):(1e3*column({})):{}", index, slice.across + 2, slice.up + 2, column);
  return fmt::format(
      "set contour base\nset cntrparam levels incremental {0:g},{0:g},100\nunset surface\nset table $lines\n"
      "splot 'workspace-position.dat' {1}\nunset table\nset surface\nunset contour\n"
      "set title \"{2}\"\nset xlabel \"{3} [mm]\"\nset ylabel \"{4} [mm]\"\n"
      "set xrange [{5:g}:{6:g}]\nset yrange [{7:g}:{8:g}]\n"
      "set object 1 rectangle from -20,-20 to 20,20 fillstyle empty border rgb '#ffffff' dt 3 front\n"
      "plot 'workspace-position.dat' {1} with image notitle, $lines with lines lc rgb '#ffffff' lw 0.7 notitle, \\\n"
      "  $motors using 1:2 with points pt 7 ps 1 lc rgb '#202020' notitle\n",
      step, points, slice.title, kAxes[slice.across], kAxes[slice.up], -1.1 * across, 1.1 * across, -1.1 * up,
      1.1 * up);
}

std::string motors_of(const SpidarGeometry& geometry, const Slice& slice) {
  std::string text = "$motors << EOD\n";
  for (const SpidarString& string : geometry.strings) {
    fmt::format_to(std::back_inserter(text), "{:g} {:g}\n", 1e3 * string.motor_S[slice.across],
                   1e3 * string.motor_S[slice.up]);
  }
  return text + "EOD\n";
}

// A round step of which about eight make the greatest value.
double step_of_lines(double greatest) {
  const double power = std::pow(10.0, std::floor(std::log10(greatest / 8.0)));
  for (const double step : {2.0, 2.5, 5.0}) {
    if (8.0 * step * power >= greatest) return step * power;
  }
  return 10.0 * power;
}

std::string position_script(const SpidarGeometry& geometry) {
  constexpr int kPositionWidth = 1200, kPositionHeight = 780;
  const SpidarReach reach = spidar_reach(geometry, {});
  const Vector3 half = half_frame(geometry);
  std::string drawing = fmt::format(
      "set multiplot layout 2,3 title \"SPIDAR '{}': greatest force and torque in every direction, grip unrotated\\n"
      "{{/*0.75 dots: motors; dotted: within 20 mm; white: the strings do not hold the grip}}\" font ',15' \\\n"
      "  margins 0.07,0.89,0.08,0.86 spacing 0.08,0.14\n",
      geometry.name);
  const struct {
    const char* label;
    int column;
    double greatest;
  } rows[] = {{"force [N]", 5, reach.force}, {"torque [N m]", 6, reach.torque}};
  for (const auto& row : rows) {
    const double step = step_of_lines(row.greatest);
    drawing +=
        fmt::format("set cblabel \"{}, a line each {:g}\"\nset cbrange [0:{:g}]\n", row.label, step, row.greatest);
    drawing += fmt::format("set colorbox user origin 0.915,{} size 0.015,0.33\n", row.column == 5 ? 0.55 : 0.08);
    for (size_t i = 0; i < std::size(kSlices); ++i) {
      drawing += motors_of(geometry, kSlices[i]);
      drawing += map_commands(kSlices[i], static_cast<int>(i), row.column, half, step);
    }
  }
  drawing += "unset multiplot\n";
  const std::string settings =
      "set size ratio -1\nset tics out\nset view map\n"
      "set palette defined (0 '#440154', 1 '#3b528b', 2 '#21918c', 3 '#5ec962', 4 '#fde725')\n";
  return gnuplot_script("workspace-position", settings, drawing, kPositionWidth, kPositionHeight);
}

std::string rotation_script(const SpidarGeometry& geometry) {
  constexpr int kRotationWidth = 900, kRotationHeight = 610;
  std::string drawing = fmt::format(
      "set multiplot layout 2,1 title \"SPIDAR '{}': greatest force and torque in every direction, grip in the "
      "middle\" "
      "font ',14'\n",
      geometry.name);
  const struct {
    const char* label;
    int column;
  } rows[] = {{"force [N]", 3}, {"torque [N m]", 4}};
  for (const auto& row : rows) {
    drawing += fmt::format("set ylabel \"{}\"\n", row.label);
    if (row.column == 4) drawing += "set xlabel \"angle [deg]\"\n";
    drawing += "plot ";
    for (int axis = 0; axis < 3; ++axis) {
      drawing += fmt::format("{}'workspace-rotation.dat' index {} using 2:{} with lines lw {} lt {} title \"about {}\"",
                             axis > 0 ? ", " : "", axis, row.column, axis == 0 ? 5 : 2, axis + 1, kAxes[axis]);
    }
    drawing += "\n";
  }
  drawing += "unset multiplot\nunset xlabel\n";
  const std::string settings =
      "set grid\nset key outside top center horizontal\n"
      "set lmargin 11\nset xtics 15\nset xrange [-90:90]\nset yrange [0:*]\n";
  return gnuplot_script("workspace-rotation", settings, drawing, kRotationWidth, kRotationHeight);
}

}  // namespace

SpidarWorkspace spidar_workspace(const SpidarGeometry& geometry) {
  constexpr double kStep = 0.5e-3, kAccuracy = 1e-5;                             // m
  constexpr double kAngleStep = 0.5 * kDegree, kAngleAccuracy = 0.01 * kDegree;  // rad
  check_force_closure(geometry);
  SpidarWorkspace workspace;
  workspace.at_centre = spidar_reach(geometry, {});
  const Vector3 half = half_frame(geometry);
  for (int axis = 0; axis < 3; ++axis) {
    const auto way = [&](double sign) {
      return limit_along(geometry, kStep, half[axis], kAccuracy, [&](double distance) {
        return Pose{sign * distance * Vector3::Unit(axis), Quaternion::Identity()};
      });
    };
    const auto angle = [&](double sign) {
      return limit_along(geometry, kAngleStep, std::numbers::pi, kAngleAccuracy, [&](double turn) {
        return Pose{Vector3::Zero(), rotation_from_vector(sign * turn * Vector3::Unit(axis))};
      });
    };
    const auto i = static_cast<size_t>(axis);
    workspace.way[i] = {way(-1.0), way(1.0)};
    workspace.angle[i] = {angle(-1.0), angle(1.0)};
  }
  return workspace;
}

void draw_spidar_workspace(const SpidarGeometry& geometry, const std::filesystem::path& folder) {
  check_force_closure(geometry);
  make_folder(folder);
  write_figure(folder, "workspace-position", position_table(geometry), position_script(geometry));
  write_figure(folder, "workspace-rotation", rotation_table(geometry), rotation_script(geometry));
}

}  // namespace tegotae
