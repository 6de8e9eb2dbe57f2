// SPDX-License-Identifier: Apache-2.0
#include <tegotae/world/contact_rules.hpp>

#include <tegotae/world/scene_error.hpp>

#include <fmt/format.h>
#include <mujoco/mjxmacro.h>
#include <mujoco/mujoco.h>

#include <algorithm>
#include <cstring>
#include <string_view>

namespace tegotae {
namespace {

// Bits of an int that a mask may use without becoming negative.
constexpr size_t kPieceBits = 31;

// MuJoCo packs the two bodies of an exclude into one number, before 3.0 each plus one.
std::pair<int, int> bodies_of_exclude(const mjModel& m, int exclude) {
  const auto signature = static_cast<unsigned>(m.exclude_signature[exclude]);
  const int first = static_cast<int>(signature >> 16), second = static_cast<int>(signature & 0xffffU);
#if mjVERSION_HEADER >= 300
  return {first, second};
#else
  return {first - 1, second - 1};
#endif
}

bool concerns_tool(const mjModel& m, const ToolBody& tool, int pair) {
  return tool.has_body(m.geom_bodyid[m.pair_geom1[pair]]) || tool.has_body(m.geom_bodyid[m.pair_geom2[pair]]);
}

// Keeps the rows named of an array of `width` bytes a row.
void keep_rows(void* array, size_t width, const std::vector<int>& rows) {
  auto* bytes = static_cast<char*>(array);
  for (size_t to = 0; to < rows.size(); ++to) {
    std::memmove(bytes + to * width, bytes + static_cast<size_t>(rows[to]) * width, width);
  }
}

}  // namespace

ContactRules::ContactRules(const mjModel_& model, const ToolBody& tool) : model_(model) {
#if mjVERSION_HEADER < 300
  only_pairs_ = model.opt.collision == mjCOL_PAIR;
  with_pairs_ = model.opt.collision != mjCOL_DYNAMIC;
#endif
  const auto body_of = [&](int geom) { return model.geom_bodyid[geom]; };
  for (int i = 0; with_pairs_ && i < static_cast<int>(model.npair); ++i) {
    int first = model.pair_geom1[i], second = model.pair_geom2[i];
    if (!tool.has_body(body_of(first))) std::swap(first, second);
    if (!tool.has_body(body_of(first)) || tool.has_body(body_of(second))) continue;
    pairs_.emplace(first, second);
    paired_geoms_.insert({first, second});
  }
  for (int i = 0; i < static_cast<int>(model.nexclude); ++i) {
    auto [first, second] = bodies_of_exclude(model, i);
    if (!tool.has_body(first)) std::swap(first, second);
    if (tool.has_body(first) && !tool.has_body(second)) excludes_.emplace(first, second);
  }
}

bool ContactRules::is_contact_geom(int geom) const {
  const bool has_bits = model_.geom_contype[geom] != 0 || model_.geom_conaffinity[geom] != 0;
  return (has_bits && !only_pairs_) || paired_geoms_.count(geom) != 0;
}

bool ContactRules::allows(int tool_geom, int geom) const {
  if (pairs_.count({tool_geom, geom}) != 0) return true;
  if (only_pairs_ || excludes_.count({model_.geom_bodyid[tool_geom], model_.geom_bodyid[geom]}) != 0) return false;
  return ((model_.geom_contype[tool_geom] & model_.geom_conaffinity[geom]) |
          (model_.geom_contype[geom] & model_.geom_conaffinity[tool_geom])) != 0;
}

void ContactRules::encode(std::vector<GeomPiece>& tool_pieces, std::vector<GeomPiece>& pieces,
                          const std::string& file) const {
  if (pairs_.empty() && excludes_.empty() && !only_pairs_) return;
  if (tool_pieces.size() > kPieceBits) {
    throw SceneError(
        fmt::format("{}: the tool has {} contact geoms, and {} at most can be told apart by <pair> and "
                    "<exclude>; use contype and conaffinity instead",
                    file, tool_pieces.size(), kPieceBits));
  }
  for (GeomPiece& piece : pieces) {
    unsigned mask = 0;
    for (size_t i = 0; i < tool_pieces.size(); ++i) {
      if (allows(tool_pieces[i].geom, piece.geom)) mask |= 1U << i;
    }
    piece.shape.contact_type = 0;
    piece.shape.contact_affinity = static_cast<int>(mask);
  }
  for (size_t i = 0; i < tool_pieces.size(); ++i) {
    tool_pieces[i].shape.contact_type = static_cast<int>(1U << i);
    tool_pieces[i].shape.contact_affinity = 0;
  }
}

int detach_from_collisions(mjModel_& model, const ToolBody& tool) {
  mjModel* m = &model;
  for (int geom = 0; geom < static_cast<int>(m->ngeom); ++geom) {
    if (!tool.has_body(m->geom_bodyid[geom])) continue;
    m->geom_contype[geom] = 0;
    m->geom_conaffinity[geom] = 0;
  }
  std::vector<int> kept;
  for (int i = 0; i < static_cast<int>(m->npair); ++i) {
    if (!concerns_tool(*m, tool, i)) kept.push_back(i);
  }
  const int removed = static_cast<int>(m->npair) - static_cast<int>(kept.size());
  if (removed == 0) return 0;
    // Every array of the model that has a row for each pair, whatever this version of MuJoCo calls them.
#define X(type, name, rows, columns) \
  if (std::string_view(#rows) == "npair") keep_rows(m->name, sizeof(type) * static_cast<size_t>(columns), kept);
  MJMODEL_POINTERS_PREAMBLE(m)
  MJMODEL_POINTERS
#undef X
  m->npair = static_cast<int>(kept.size());
  return removed;
}

}  // namespace tegotae
