// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/lab/session_settings.hpp>
#include <tegotae/runtime/tick_record.hpp>

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace tegotae {

/// A number read from a tick, or computed from what it saw (a closed form to compare with). NaN: none, a gap in its
/// curve.
using Quantity = std::function<double(const TickRecord&, const SessionSettings&)>;

struct Curve {
  std::string label;   ///< in the key; empty: not in it
  size_t variant = 0;  ///< of the experiment: which run it is drawn from
  Quantity quantity;
  bool is_reference = false;  ///< drawn thin, dashed and black over the others
};

/// One system of axes. Panels of a figure stand below each other and share the horizontal axis.
struct Panel {
  std::string label;  ///< of the vertical axis, with unit
  std::vector<Curve> curves;
  double logarithmic_from = 0.0;   ///< > 0: the vertical axis is logarithmic and begins there; what is less lies on it
  double bottom = 0.0, top = 0.0;  ///< of the vertical axis; both 0: as the curves ask for. They are cut off beyond
};

struct Figure {
  std::string name;              ///< of the files
  std::string title;             ///< as gnuplot's markup; broken into lines where it is long
  std::string paper_title = {};  ///< added to the title where the method is the paper's
  std::string x_label = "time [s]";
  Quantity x = [](const TickRecord& record, const SessionSettings&) { return record.time; };
  std::vector<Panel> panels = {};
  bool x_descends = false;  ///< the horizontal axis runs from the greatest value to the least
};

/// The records of one run.
struct RunSamples {
  std::span<const TickRecord> records;
  const SessionSettings& settings;
};

/// Draws `figure` from `runs[curve.variant]` with gnuplot, into NAME.svg and NAME.png in `folder`, beside NAME.gnuplot
/// and the data it reads, NAME.dat. Curves are thinned out to their extremes within a pixel or so. Throws InputError
/// where gnuplot is not there, fails, or the folder cannot be written; what is already written stays.
void draw(const Figure& figure, std::span<const RunSamples> runs, const std::filesystem::path& folder);

}  // namespace tegotae
