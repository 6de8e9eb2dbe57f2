// SPDX-License-Identifier: Apache-2.0
#include <tegotae/world/scene_builder.hpp>

#include <tegotae/runtime/impulse_sums.hpp>
#include <tegotae/world/contact_rules.hpp>
#include <tegotae/world/geom_shape.hpp>
#include <tegotae/world/limits.hpp>
#include <tegotae/world/model_names.hpp>
#include <tegotae/world/model_poses.hpp>
#include <tegotae/world/scene_error.hpp>

#include <fmt/format.h>
#include <mujoco/mujoco.h>

#include <algorithm>
#include <cmath>

namespace tegotae {
namespace {

struct Pieces {
  std::vector<GeomPiece> of_tool;  // placed on the tool's own frame
  std::vector<GeomPiece> of_bodies;
};

Pieces collect_pieces(const mjModel& m, const ToolBody& tool, const ContactRules& rules, const std::string& file,
                      std::vector<std::string>& warnings) {
  Pieces pieces;
  for (int geom = 0; geom < static_cast<int>(m.ngeom); ++geom) {
    if (!rules.is_contact_geom(geom)) continue;
    const int part = tool.part_of[static_cast<size_t>(m.geom_bodyid[geom])];
    GeomPiece piece{geom, shape_of_geom(m, geom, file, warnings)};
    if (part < 0) {
      pieces.of_bodies.push_back(std::move(piece));
      continue;
    }
    if (!piece.shape.is_bounded()) {
      throw SceneError(fmt::format("{}: {} of the tool is a plane, which has no end; make it a thin box", file,
                                   geom_label(m, geom)));
    }
    piece.shape.X_BS = tool.X_TB[static_cast<size_t>(part)] * piece.shape.X_BS;
    pieces.of_tool.push_back(std::move(piece));
  }
  return pieces;
}

void refuse_empty(const mjModel& m, const ToolBody& tool, const Pieces& pieces, const std::string& file) {
  const char* mend = "give its geoms a contype or a conaffinity that is not 0";
  if (pieces.of_tool.empty()) {
    throw SceneError(fmt::format("{}: the tool '{}' has no contact geometry; add a geom to it, or {}", file,
                                 body_name(m, tool.id), mend));
  }
  if (pieces.of_bodies.empty()) {
    throw SceneError(
        fmt::format("{}: nothing but the tool has contact geometry; add a body to touch, or {}", file, mend));
  }
}

MassProperties mass_of_tool(const mjModel& m, const ToolBody& tool, const std::vector<Shape>& pieces) {
  MassProperties given = tool_mass(m, tool);
  if (given.mass > 0.0 && given.inertia.trace() > 0.0) return given;
  std::vector<MassProperties> parts;
  parts.reserve(pieces.size());
  for (const Shape& piece : pieces) parts.push_back(mass_properties(piece, world_limits::kToolDensity));
  return combined(parts);
}

// A body that a joint moves has a weld root of its own; MuJoCo welds all others to the world.
bool is_moving(const mjModel& m, int body) {
  return m.body_weldid[body] != 0 && m.body_dofnum[m.body_weldid[body]] > 0;
}

double gyration_length_of(const mjModel& m, int body) {
  const double mass = m.body_mass[body];
  return mass > 0.0 ? std::sqrt(vector_from(m.body_inertia, body).sum() / (3.0 * mass)) : 0.0;
}

// Pieces come in the order of their bodies, as MuJoCo's geoms do.
void add_bodies(const mjModel& m, const mjData& d, const std::vector<GeomPiece>& pieces, BuiltScene& built) {
  int last_body = -1;
  for (const GeomPiece& piece : pieces) {
    const int id = m.geom_bodyid[piece.geom];
    if (id != last_body) {
      Body& body = built.geometry.bodies.emplace_back();
      body.name = body_name(m, id);
      body.X_WB = pose_from(d.xpos, d.xquat, id);
      if (is_moving(m, id)) {
        body.moving_index = static_cast<int>(built.moving_bodies.size());
        body.p_BC = vector_from(m.body_ipos, id);
        body.mass = m.body_mass[id];
        body.gyration_length = gyration_length_of(m, id);
        built.moving_bodies.push_back(id);
      }
      last_body = id;
    }
    built.geometry.bodies.back().pieces.push_back(piece.shape);
  }
  built.geometry.moving_count = static_cast<int>(built.moving_bodies.size());
}

void warn_if_untouchable(const SceneGeometry& geometry, const std::string& file, std::vector<std::string>& warnings) {
  for (const Shape& tool_piece : geometry.tool.pieces) {
    for (const Body& body : geometry.bodies) {
      for (const Shape& piece : body.pieces) {
        if (may_touch(tool_piece, piece)) return;
      }
    }
  }
  warnings.push_back(fmt::format("{}: by contype, conaffinity, <exclude> and <pair> the tool '{}' may touch nothing",
                                 file, geometry.tool.name));
}

}  // namespace

BuiltScene build_scene(const mjModel_& model, const mjData_& data, const ToolBody& tool, const std::string& file) {
  BuiltScene built;
  const ContactRules rules(model, tool);
  Pieces pieces = collect_pieces(model, tool, rules, file, built.warnings);
  refuse_empty(model, tool, pieces, file);
  rules.encode(pieces.of_tool, pieces.of_bodies, file);
  built.geometry.tool.name = body_name(model, tool.id);
  built.geometry.tool.X_WT = pose_from(data.xpos, data.xquat, tool.id);
  for (GeomPiece& piece : pieces.of_tool) built.geometry.tool.pieces.push_back(std::move(piece.shape));
  built.geometry.tool.mass = mass_of_tool(model, tool, built.geometry.tool.pieces);
  add_bodies(model, data, pieces.of_bodies, built);
  if (built.geometry.moving_count > kMaxMovingBodies) {
    throw SceneError(
        fmt::format("{}: the scene has {} moving bodies that the tool could touch, and {} is the most; "
                    "remove joints or bodies, or give those out of reach contype=\"0\" conaffinity=\"0\"",
                    file, built.geometry.moving_count, kMaxMovingBodies));
  }
  warn_if_untouchable(built.geometry, file, built.warnings);
  return built;
}

}  // namespace tegotae
