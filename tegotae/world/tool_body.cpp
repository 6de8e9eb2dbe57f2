// SPDX-License-Identifier: Apache-2.0
#include <tegotae/world/tool_body.hpp>

#include <tegotae/world/model_names.hpp>
#include <tegotae/world/model_poses.hpp>
#include <tegotae/world/scene_error.hpp>

#include <fmt/format.h>
#include <mujoco/mujoco.h>

#include <algorithm>

namespace tegotae {
namespace {

constexpr int kListedBodies = 10;

bool is_named(const mjModel& m, int body) {
  const char* name = mj_id2name(&m, mjOBJ_BODY, body);
  return name != nullptr && *name != '\0';
}

std::string list_of_bodies(const mjModel& m) {
  std::string list;
  const int count = static_cast<int>(m.nbody) - 1;
  for (int body = 1; body <= std::min(count, kListedBodies); ++body) {
    list += body > 1 ? ", " : "";
    list += is_named(m, body) ? fmt::format("'{}'", body_name(m, body))
                              : fmt::format("{} (unnamed: give it a name)", body_name(m, body));
  }
  if (count > kListedBodies) list += fmt::format(" and {} more", count - kListedBodies);
  return count > 0 ? list : "none";
}

[[noreturn]] void refuse_unknown(const mjModel& m, const std::string& name, const std::string& file) {
  // MuJoCo's URDF reader merges links that cannot move into the world, and their names are lost.
  const bool may_be_fused = file.size() > 5 && file.compare(file.size() - 5, 5, ".urdf") == 0;
  throw SceneError(fmt::format(
      "{}: there is no body '{}' to be the tool; the bodies are: {}{}", file, name, list_of_bodies(m),
      may_be_fused ? "; links that cannot move are kept with <mujoco><compiler fusestatic=\"false\"/></mujoco>" : ""));
}

void refuse_joints(const mjModel& m, const ToolBody& tool, const std::string& file) {
  const std::string name = body_name(m, tool.id);
  const auto refuse = [&](int body, const std::string& relation) {
    // MuJoCo takes mocap bodies as children of the world only.
    const bool may_be_mocap = body == tool.id && m.body_parentid[body] == 0;
    throw SceneError(
        fmt::format("{}: {} has joints, so that MuJoCo would move the tool and not the hand: remove its joints{}", file,
                    relation, may_be_mocap ? " (mocap=\"true\" may be added then)" : ""));
  };
  for (int body = m.body_parentid[tool.id]; body > 0; body = m.body_parentid[body]) {
    if (m.body_jntnum[body] > 0) {
      refuse(body, fmt::format("body '{}', which carries the tool '{}',", body_name(m, body), name));
    }
  }
  for (const int body : tool.bodies) {
    if (m.body_jntnum[body] == 0) continue;
    refuse(body, body == tool.id ? fmt::format("tool body '{}'", name)
                                 : fmt::format("body '{}' on the tool '{}'", body_name(m, body), name));
  }
}

bool equality_holds_tool(const mjModel& m, const ToolBody& tool, int equality) {
  const auto body_of = [&](int object) {
    const int type = m.eq_type[equality];
    if (object < 0) return -1;
#if mjVERSION_HEADER < 300
    if (type == mjEQ_DISTANCE) return m.geom_bodyid[object];
#endif
#if mjVERSION_HEADER >= 323
    if (m.eq_objtype[equality] == mjOBJ_SITE) return m.site_bodyid[object];
#endif
    return type == mjEQ_CONNECT || type == mjEQ_WELD ? object : -1;
  };
  const int first = body_of(m.eq_obj1id[equality]), second = body_of(m.eq_obj2id[equality]);
  return (first >= 0 && tool.has_body(first)) || (second >= 0 && tool.has_body(second));
}

bool wrap_is_on_tool(const mjModel& m, const ToolBody& tool, int wrap) {
  const int type = m.wrap_type[wrap], object = m.wrap_objid[wrap];
  if (type == mjWRAP_SITE) return tool.has_body(m.site_bodyid[object]);
  if (type == mjWRAP_SPHERE || type == mjWRAP_CYLINDER) return tool.has_body(m.geom_bodyid[object]);
  return false;
}

void refuse_ties(const mjModel& m, const ToolBody& tool, const std::string& file) {
  const auto refuse = [&](const char* kind, int type, int id) {
    const char* name = mj_id2name(&m, type, id);
    throw SceneError(fmt::format("{}: the {} {} holds the tool '{}', whose hand would not feel its force; remove it",
                                 file, kind, name != nullptr ? fmt::format("'{}'", name) : fmt::format("number {}", id),
                                 body_name(m, tool.id)));
  };
  for (int i = 0; i < static_cast<int>(m.neq); ++i) {
    if (equality_holds_tool(m, tool, i)) refuse("equality constraint", mjOBJ_EQUALITY, i);
  }
  for (int i = 0; i < static_cast<int>(m.ntendon); ++i) {
    for (int k = 0; k < m.tendon_num[i]; ++k) {
      if (wrap_is_on_tool(m, tool, m.tendon_adr[i] + k)) refuse("tendon", mjOBJ_TENDON, i);
    }
  }
}

}  // namespace

ToolBody find_tool_body(const mjModel_& model, const std::string& name, const std::string& file) {
  ToolBody tool;
  tool.id = mj_name2id(&model, mjOBJ_BODY, name.c_str());
  if (tool.id <= 0) refuse_unknown(model, name, file);
  tool.part_of.assign(static_cast<size_t>(model.nbody), -1);
  // Parents precede their children.
  for (int body = tool.id; body < static_cast<int>(model.nbody); ++body) {
    const int parent = tool.part_of[static_cast<size_t>(model.body_parentid[body])];
    if (body != tool.id && parent < 0) continue;
    tool.part_of[static_cast<size_t>(body)] = static_cast<int>(tool.bodies.size());
    tool.bodies.push_back(body);
    tool.X_TB.push_back(body == tool.id ? Pose{}
                                        : tool.X_TB[static_cast<size_t>(parent)] *
                                              pose_from(model.body_pos, model.body_quat, body));
  }
  refuse_joints(model, tool, file);
  refuse_ties(model, tool, file);
  return tool;
}

MassProperties tool_mass(const mjModel_& model, const ToolBody& tool) {
  std::vector<MassProperties> parts;
  for (size_t i = 0; i < tool.bodies.size(); ++i) {
    const int body = tool.bodies[i];
    if (!(model.body_mass[body] > 0.0)) continue;
    const Pose X_TI = tool.X_TB[i] * pose_from(model.body_ipos, model.body_iquat, body);
    const Matrix3 R = X_TI.rotation();
    const Matrix3 inertia = R * vector_from(model.body_inertia, body).asDiagonal() * R.transpose();
    parts.push_back({model.body_mass[body], X_TI.p, inertia});
  }
  return parts.empty() ? MassProperties{} : combined(parts);
}

}  // namespace tegotae
