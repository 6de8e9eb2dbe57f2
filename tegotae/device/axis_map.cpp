// SPDX-License-Identifier: Apache-2.0
#include <tegotae/device/axis_map.hpp>

#include <stdexcept>
#include <string>

namespace tegotae {

AxisMap::AxisMap(std::string_view names) : R_WD_(Matrix3::Zero()) {
  const std::string given(names);
  for (int row = 0; row < 3; ++row) {
    const bool opposite = !names.empty() && names.front() == '-';
    if (opposite) names.remove_prefix(1);
    const std::size_t column = names.empty() ? std::string_view::npos : std::string_view("xyz").find(names.front());
    if (column == std::string_view::npos) break;
    names.remove_prefix(1);
    R_WD_(row, static_cast<int>(column)) = opposite ? -1.0 : 1.0;
  }
  // Three axes of which none is missing, and nothing after them.
  if (!names.empty() || R_WD_.cwiseAbs().sum() != 3.0 || R_WD_.determinant() != 1.0) {
    throw std::invalid_argument("'" + given +
                                "' does not name a right-handed turn of the axes; write x, y and z, each once, with a "
                                "minus before one that points the other way, as y-xz.");
  }
}

}  // namespace tegotae
