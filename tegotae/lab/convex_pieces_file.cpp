// SPDX-License-Identifier: Apache-2.0
// The pieces of a split mesh as files that a scene includes, and the volume that they fill.
#include <tegotae/lab/convex_split.hpp>
#include <tegotae/lab/text_file.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace tegotae {
namespace {

// Faces as fans of triangles.
std::string obj_of(const Polytope& piece) {
  std::string text;
  for (const Vector3& p : piece.vertices) text += fmt::format("v {:.9g} {:.9g} {:.9g}\n", p.x(), p.y(), p.z());
  for (const Polytope::Face& face : piece.faces) {
    const auto corners = piece.vertices_of(face);
    for (size_t k = 2; k < corners.size(); ++k) {
      text += fmt::format("f {} {} {}\n", corners[0] + 1, corners[k - 1] + 1, corners[k] + 1);
    }
  }
  return text;
}

bool is_inside(const Polytope& piece, const Vector3& p) {
  return std::all_of(piece.faces.begin(), piece.faces.end(),
                     [&p](const Polytope::Face& face) { return face.normal.dot(p) <= face.offset; });
}

struct Box {
  Vector3 lower = Vector3::Constant(1e300), upper = Vector3::Constant(-1e300);

  void include(const Polytope& piece) {
    for (const Vector3& p : piece.vertices) lower = lower.cwiseMin(p), upper = upper.cwiseMax(p);
  }
  bool contains(const Vector3& p) const {
    return (p.array() >= lower.array()).all() && (p.array() <= upper.array()).all();
  }
};

}  // namespace

std::vector<std::filesystem::path> write_pieces(const ConvexSplit& split, const std::filesystem::path& folder,
                                                const std::string& stem) {
  make_folder(folder);
  std::vector<std::filesystem::path> files;
  std::string assets = "<mujocoinclude>\n", geoms = "<mujocoinclude>\n";
  for (size_t i = 0; i < split.pieces.size(); ++i) {
    const std::string name = fmt::format("{}-{}", stem, i + 1);
    files.push_back(folder / (name + ".obj"));
    write_text(files.back(), obj_of(split.pieces[i]));
    assets += fmt::format("  <mesh name=\"{0}\" file=\"{0}.obj\"/>\n", name);
    geoms += fmt::format("  <geom type=\"mesh\" mesh=\"{}\"/>\n", name);
  }
  files.push_back(folder / (stem + "-assets.xml"));
  write_text(files.back(), assets + "</mujocoinclude>\n");
  files.push_back(folder / (stem + "-geoms.xml"));
  write_text(files.back(), geoms + "</mujocoinclude>\n");
  return files;
}

double union_volume(const std::vector<Polytope>& pieces, int points_per_axis) {
  std::vector<Box> boxes(pieces.size());
  Box all;
  for (size_t i = 0; i < pieces.size(); ++i) {
    boxes[i].include(pieces[i]);
    all.include(pieces[i]);
  }
  const Vector3 step = (all.upper - all.lower) / points_per_axis;
  long inside = 0;
  for (int x = 0; x < points_per_axis; ++x) {
    for (int y = 0; y < points_per_axis; ++y) {
      for (int z = 0; z < points_per_axis; ++z) {
        const Vector3 p = all.lower + step.cwiseProduct(Vector3(x + 0.5, y + 0.5, z + 0.5));
        for (size_t i = 0; i < pieces.size(); ++i) {
          if (!boxes[i].contains(p) || !is_inside(pieces[i], p)) continue;
          ++inside;
          break;
        }
      }
    }
  }
  return static_cast<double>(inside) * step.prod();
}

}  // namespace tegotae
