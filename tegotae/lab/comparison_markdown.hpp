// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/lab/comparison.hpp>

#include <string>

namespace tegotae {

/// Errors of force and of torque, experiments by methods, in tables of Markdown.
std::string comparison_overview(const ComparisonResult& result);

/// Largest stable stiffness and energy, a row a method, as a table of Markdown; empty where none was measured.
std::string stability_table(const ComparisonResult& result);

/// All of a comparison as a page of Markdown: the overview, a table an experiment with all metrics, the stability.
std::string comparison_markdown(const ComparisonResult& result);

}  // namespace tegotae
