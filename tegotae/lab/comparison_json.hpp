// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/lab/comparison.hpp>

#include <string>

namespace tegotae {

/// As JSON: an entry an experiment with a row a method, then the stability; keys carry their units. What is not finite
/// is null. What the wall clock measured stands under `timing` of a row; all else repeats.
std::string comparison_json(const ComparisonResult& result);

}  // namespace tegotae
