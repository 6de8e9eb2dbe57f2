// SPDX-License-Identifier: Apache-2.0
#include <apps/commands.hpp>
#include <apps/validators.hpp>
#include <tegotae/lab/convex_split.hpp>

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <string>

namespace tegotae {
namespace {

struct SplitOptions {
  std::string mesh, out;
  SplitSettings settings;
};

// The stem names meshes in a scene: what XML would not take as it is, is refused.
std::string stem_of(const std::filesystem::path& mesh) {
  std::string stem = mesh.stem().string();
  if (stem.find_first_of("<>&\"'") != std::string::npos) {
    throw UsageError(
        fmt::format("the name of {} cannot stand in a scene file; rename it without < > & and quotes.", mesh.string()));
  }
  return stem;
}

void report(const ConvexSplit& split, const std::filesystem::path& folder, const std::string& stem) {
  const double sum = split.sum_volume / split.mesh_volume, together = split.union_volume / split.mesh_volume;
  fmt::print("{} convex pieces in {}/{}-1.obj ... {}-{}.obj\n", split.pieces.size(), folder.string(), stem, stem,
             split.pieces.size());
  fmt::print(
      "volume: the mesh {:.6g} (cubed units of its file), the pieces together {:.1f} % of it, their sum {:.1f} %\n",
      split.mesh_volume, 100.0 * together, 100.0 * sum);
  fmt::print(
      "in the scene, beside these files: <asset><include file=\"{0}-assets.xml\"/></asset> and, in the body, "
      "<include file=\"{0}-geoms.xml\"/>\n",
      stem);
  constexpr double kCloseEnough = 0.05;
  if (std::abs(together - 1.0) > kCloseEnough) {
    fmt::print(stderr,
               "tegotae: warning: the pieces fill {:.1f} % of the mesh's volume; more --pieces or a greater "
               "--resolution come closer.\n",
               100.0 * together);
  }
}

void run(const SplitOptions& options) {
  const std::filesystem::path mesh_file = options.mesh;
  const std::string stem = stem_of(mesh_file);
  std::filesystem::path folder = options.out.empty() ? mesh_file.parent_path() : std::filesystem::path(options.out);
  if (folder.empty()) folder = ".";
  const Mesh mesh = read_mesh(mesh_file);
  const ConvexSplit split = split_convex(mesh, options.settings, mesh_file);
  write_pieces(split, folder, stem);
  report(split, folder, stem);
}

}  // namespace

void add_split_command(CLI::App& program) {
  auto options = std::make_shared<SplitOptions>();
  CLI::App* const command = program.add_subcommand(
      "split", "Split a mesh into convex pieces (V-HACD), and write what a scene needs to use them.");
  command->add_option("MESH", options->mesh, "Closed mesh: OBJ or STL")->type_name("FILE")->required();
  command->add_option("--out", options->out, "Folder for the pieces (default: the mesh's)")
      ->type_name("DIR")
      ->check(not_empty("a folder"));
  command->add_option("--pieces", options->settings.pieces, "Pieces at most")
      ->check(CLI::Range(1, 1000))
      ->type_name("N")
      ->capture_default_str();
  command->add_option("--resolution", options->settings.resolution, "Voxels that the mesh is filled with")
      ->check(CLI::Range(10000, 10000000))
      ->type_name("N")
      ->capture_default_str();
  command->callback([options] { run(*options); });
}

}  // namespace tegotae
