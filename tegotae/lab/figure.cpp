// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/figure.hpp>

#include <tegotae/lab/gnuplot.hpp>
#include <tegotae/lab/text_file.hpp>
#include <tegotae/lab/thinning.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <string_view>

namespace tegotae {
namespace {

// Of the picture, in pixels of the PNG and units of the SVG.
constexpr int kWidth = 900, kTopHeight = 90, kPanelHeight = 260, kLineHeight = 22;

// Characters of a title that surely fit into the width: letters are 0.6 of the font's size wide on the average, and the
// PNG's title is 19 pixels high.
constexpr size_t kTitleColumns = 76;

// One curve or two under a reference are wide and in lighter tones of their hues, so that both are seen where they are
// the same. More of them would hide each other.
constexpr std::array<const char*, 2> kTones = {"#cda4ee", "#7fd0b3"};

// Points of a curve after thinning: about one a pixel.
constexpr size_t kMaxPoints = 1000;

// The parts of a curve between its gaps, thinned out alike.
std::vector<std::vector<PlotPoint>> parts_of(const Panel& panel, const Figure& figure, const Curve& curve,
                                             const RunSamples& run) {
  std::vector<std::vector<PlotPoint>> parts;
  bool in_gap = true;
  for (const TickRecord& record : run.records) {
    PlotPoint point{figure.x(record, run.settings), curve.quantity(record, run.settings)};
    const bool is_drawn = std::isfinite(point.x) && std::isfinite(point.y);
    if (panel.logarithmic_from > 0.0) point.y = std::max(point.y, panel.logarithmic_from);
    if (is_drawn && in_gap) parts.emplace_back();
    if (is_drawn) parts.back().push_back(point);
    in_gap = !is_drawn;
  }
  size_t drawn = 0;
  for (const std::vector<PlotPoint>& part : parts) drawn += part.size();
  for (std::vector<PlotPoint>& part : parts) {
    part = thinned(part, std::max<size_t>(2, kMaxPoints * part.size() / drawn));
  }
  return parts;
}

// One block of "x y" lines a curve, in the order of the panels; gnuplot finds them by their index. An empty line is a
// gap.
std::string data_of(const Figure& figure, std::span<const RunSamples> runs) {
  std::string text;
  for (const Panel& panel : figure.panels) {
    for (const Curve& curve : panel.curves) {
      fmt::format_to(std::back_inserter(text), "# {}: {}\n", panel.label, curve.label);
      const auto parts = parts_of(panel, figure, curve, runs[curve.variant]);
      for (const std::vector<PlotPoint>& part : parts) {
        if (&part != &parts.front()) text.append("\n");
        for (const PlotPoint& point : part) {
          fmt::format_to(std::back_inserter(text), "{:.7g} {:.7g}\n", point.x, point.y);
        }
      }
      if (parts.empty()) text.append("nan nan\n");  // an index of its own all the same
      text.append("\n\n");
    }
  }
  return text;
}

std::string style_of(const Panel& panel, size_t i) {
  if (panel.curves[i].is_reference) return "lw 1.5 dt (10,6) lc rgb '#000000'";
  const auto references = static_cast<size_t>(
      std::count_if(panel.curves.begin(), panel.curves.end(), [](const Curve& curve) { return curve.is_reference; }));
  const bool is_wide = references > 0 && i < kTones.size() && panel.curves.size() - references <= kTones.size();
  return is_wide ? fmt::format("lw 5 lc rgb '{}'", kTones[i]) : fmt::format("lw 2 lt {}", i + 1);
}

std::string commands_of_panel(const Figure& figure, const Panel& panel, int& index) {
  const bool is_logarithmic = panel.logarithmic_from > 0.0;
  std::string text = is_logarithmic ? fmt::format("set logscale y\nset format y '10^{{%T}}'\nset yrange [{:g}:*]\n",
                                                  panel.logarithmic_from)
                                    : "";
  if (panel.bottom < panel.top) text += fmt::format("set yrange [{:.7g}:{:.7g}]\n", panel.bottom, panel.top);
  text += fmt::format("set ylabel \"{}\"\nplot ", panel.label);
  for (size_t i = 0; i < panel.curves.size(); ++i) {
    const Curve& curve = panel.curves[i];
    const std::string title =
        panel.curves.size() > 1 && !curve.label.empty() ? fmt::format("title \"{}\"", curve.label) : "notitle";
    fmt::format_to(std::back_inserter(text), "{}'{}.dat' index {} with lines {} {}", i > 0 ? ", \\\n  " : "",
                   figure.name, index, style_of(panel, i), title);
    ++index;
  }
  text += "\nset yrange [*:*]\n";
  if (is_logarithmic) text += "unset logscale y\nset format y\n";
  return text;
}

// The same drawing for both formats.
std::string script_of(const Figure& figure) {
  const std::vector<std::string> title = lines_of(figure.title, kTitleColumns);
  const int height = kTopHeight + kLineHeight * static_cast<int>(title.size() - 1) +
                     kPanelHeight * static_cast<int>(figure.panels.size());
  std::string drawing =
      fmt::format("set multiplot layout {},1 title \"{}\" font ',14'\n", figure.panels.size(), fmt::join(title, "\\n"));
  int index = 0;
  for (size_t i = 0; i < figure.panels.size(); ++i) {
    if (i + 1 == figure.panels.size()) drawing += fmt::format("set xlabel \"{}\"\n", figure.x_label);
    drawing += commands_of_panel(figure, figure.panels[i], index);
  }
  drawing += "unset multiplot\nunset xlabel\n";

  std::string settings = "set grid\nset key outside top center horizontal\nset lmargin 11\n";
  if (figure.x_descends) settings += "set xrange [*:*] reverse\n";
  return gnuplot_script(figure.name, settings, drawing, kWidth, height);
}

}  // namespace

void draw(const Figure& figure, std::span<const RunSamples> runs, const std::filesystem::path& folder) {
  make_folder(folder);
  write_text(folder / (figure.name + ".dat"), data_of(figure, runs));
  write_text(folder / (figure.name + ".gnuplot"), script_of(figure));
  run_gnuplot(figure.name, folder);
}

}  // namespace tegotae
