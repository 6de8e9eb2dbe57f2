// SPDX-License-Identifier: Apache-2.0
#include <tegotae/world/model_names.hpp>

#include <fmt/format.h>
#include <mujoco/mujoco.h>

namespace tegotae {

std::string body_name(const mjModel_& model, int body) {
  const char* name = mj_id2name(&model, mjOBJ_BODY, body);
  return name != nullptr && *name != '\0' ? std::string(name) : fmt::format("body {}", body);
}

std::string geom_label(const mjModel_& model, int geom) {
  const char* name = mj_id2name(&model, mjOBJ_GEOM, geom);
  if (name != nullptr && *name != '\0') return fmt::format("geom '{}'", name);
  const int body = model.geom_bodyid[geom];
  return fmt::format("geom {} of body '{}'", geom - model.body_geomadr[body], body_name(model, body));
}

}  // namespace tegotae
