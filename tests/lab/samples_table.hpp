// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tests/lab/temporary_folder.hpp>

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

namespace tegotae {

/// A samples file as a reader with no knowledge of tegotae sees it.
struct SamplesTable {
  std::vector<std::string> comments;
  std::vector<std::string> names;
  std::vector<std::vector<std::string>> rows;

  size_t column(const std::string& name) const {
    const auto found = std::find(names.begin(), names.end(), name);
    EXPECT_NE(found, names.end()) << "no column " << name;
    return static_cast<size_t>(found - names.begin());
  }
  double at(size_t row, const std::string& name) const { return std::stod(rows.at(row).at(column(name))); }
};

inline std::vector<std::string> split_at_commas(const std::string& line) {
  std::vector<std::string> fields;
  std::istringstream stream(line);
  for (std::string field; std::getline(stream, field, ',');) fields.push_back(field);
  return fields;
}

inline SamplesTable read_samples(const std::filesystem::path& file) {
  SamplesTable table;
  std::istringstream stream(contents_of(file));
  for (std::string line; std::getline(stream, line);) {
    if (line.rfind('#', 0) == 0) {
      table.comments.push_back(line);
    } else if (table.names.empty()) {
      table.names = split_at_commas(line);
    } else {
      table.rows.push_back(split_at_commas(line));
    }
  }
  return table;
}

/// The text without the last column, which is the one that need not repeat.
inline std::string without_last_column(const std::filesystem::path& file) {
  std::istringstream stream(contents_of(file));
  std::string result;
  for (std::string line; std::getline(stream, line);) {
    const bool is_comment = line.rfind('#', 0) == 0;
    result += (is_comment ? line : line.substr(0, line.rfind(','))) + "\n";
  }
  return result;
}

}  // namespace tegotae
