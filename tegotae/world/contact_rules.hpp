// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/world/tool_body.hpp>

#include <cstdint>
#include <set>
#include <string>
#include <utility>
#include <vector>

struct mjModel_;

namespace tegotae {

/// A geom and its shape.
struct GeomPiece {
  int geom = 0;
  Shape shape;
};

/// Which geoms of a scene may touch the tool: MuJoCo's contype and conaffinity, `<exclude>` and `<pair>`. Made before
/// the tool is detached from MuJoCo's own collisions.
class ContactRules {
 public:
  ContactRules(const mjModel_& model, const ToolBody& tool);

  /// Whether the geom takes part in contact at all; the others are there to be seen.
  bool is_contact_geom(int geom) const;
  bool allows(int tool_geom, int geom) const;

  /// Where `<exclude>`, `<pair>` or the scene's collision mode say more than the bits do, renumbers the bits of the
  /// shapes so that `may_touch` answers as `allows`: each tool piece has a bit of its own. Else leaves the scene's
  /// bits. Throws SceneError for more tool pieces than there are bits.
  void encode(std::vector<GeomPiece>& tool_pieces, std::vector<GeomPiece>& pieces, const std::string& file) const;

 private:
  const mjModel_& model_;
  bool only_pairs_ = false;
  bool with_pairs_ = true;
  std::set<std::pair<int, int>> pairs_;     // tool geom, other geom
  std::set<int> paired_geoms_;              // of both sides
  std::set<std::pair<int, int>> excludes_;  // tool's body, other body
};

/// Takes the tool out of MuJoCo's own collisions: no contact bits, no `<pair>`. Returns the number of pairs removed.
int detach_from_collisions(mjModel_& model, const ToolBody& tool);

}  // namespace tegotae
