// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

struct mjModel_;

namespace tegotae {

/// Name of a body; "body 3" where it has none.
std::string body_name(const mjModel_& model, int body);

/// For messages: "geom 'top'", or "geom 2 of body 'table'" where it has no name.
std::string geom_label(const mjModel_& model, int geom);

}  // namespace tegotae
