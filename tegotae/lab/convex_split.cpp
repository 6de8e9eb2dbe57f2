// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/convex_split.hpp>

#include <tegotae/lab/child_process.hpp>
#include <tegotae/lab/input_error.hpp>
#include <tegotae/lab/text_file.hpp>
#include <tegotae/shape/mass_properties.hpp>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cstdlib>
#include <fstream>

namespace tegotae {
namespace {

constexpr int kNoPackage = 3;  // exit code of the script
constexpr int kUnionPointsPerAxis = 96;

// The script lies beside the program where it is installed, else in the source tree.
std::filesystem::path find_script() {
  std::error_code error;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error);
  const std::filesystem::path beside = program.parent_path().parent_path() / "share" / "tegotae" / "split";
  for (const std::filesystem::path& folder : {beside, std::filesystem::path(TEGOTAE_SOURCE_SPLIT)}) {
    if (std::filesystem::is_regular_file(folder / "split.js", error)) return folder / "split.js";
  }
  throw InputError(fmt::format("there is no split.js in {} nor in {}; install tegotae anew.", beside.string(),
                               TEGOTAE_SOURCE_SPLIT));
}

// A folder of its own for the exchange with the script, gone afterwards.
class ExchangeFolder {
 public:
  ExchangeFolder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "tegotae-split-XXXXXX").string();
    if (mkdtemp(pattern.data()) == nullptr) throw InputError(fmt::format("cannot write to {}.", pattern));
    path_ = pattern;
  }
  ExchangeFolder(const ExchangeFolder&) = delete;
  ExchangeFolder& operator=(const ExchangeFolder&) = delete;
  ~ExchangeFolder() {
    std::error_code error;
    std::filesystem::remove_all(path_, error);
  }
  std::filesystem::path file(const char* name) const { return path_ / name; }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

nlohmann::json request_of(const Mesh& mesh, const SplitSettings& settings) {
  std::vector<double> positions;
  std::vector<int> indices;
  for (const Vector3& p : mesh.vertices) positions.insert(positions.end(), {p.x(), p.y(), p.z()});
  for (const auto& triangle : mesh.triangles) indices.insert(indices.end(), triangle.begin(), triangle.end());
  return {{"positions", positions},
          {"indices", indices},
          {"pieces", settings.pieces},
          {"resolution", settings.resolution},
          {"vertices", settings.vertices}};
}

nlohmann::json run_script(const nlohmann::json& request, const std::filesystem::path& file) {
  const std::filesystem::path script = find_script();
  const ExchangeFolder exchange;
  write_text(exchange.file("mesh.json"), request.dump());
  const ChildResult result =
      run_child({"node", script.string(), exchange.file("mesh.json").string(), exchange.file("pieces.json").string()},
                exchange.path());
  if (result.not_found) {
    throw InputError(
        "splitting a mesh needs Node.js, and there is no program 'node'; install Debian's package nodejs.");
  }
  if (result.exit_code == kNoPackage) {
    throw InputError(fmt::format(
        "splitting a mesh needs the npm package vhacd-js; install it with: npm install --prefix '{}' vhacd-js@0.0.1",
        script.parent_path().string()));
  }
  if (result.exit_code != 0) {
    throw InputError(
        fmt::format("{}: V-HACD failed (exit code {}); try a lower --resolution.", file.string(), result.exit_code));
  }
  std::ifstream stream(exchange.file("pieces.json"));
  return nlohmann::json::parse(stream);
}

double volume_of_hull(const std::vector<Vector3>& points) { return mass_properties(make_hull(points), 1.0).mass; }

// Whether a mesh of this volume is its own hull, but for rounding in its file.
bool is_filled(const Polytope& hull, double mesh_volume) {
  constexpr double kRounding = 1e-4;
  return mesh_volume >= (1.0 - kRounding) * volume_of_hull(hull.vertices);
}

}  // namespace

ConvexSplit split_convex(const Mesh& mesh, const SplitSettings& settings, const std::filesystem::path& file) {
  if (const std::string flaw = flaw_of(mesh); !flaw.empty()) {
    throw InputError(
        fmt::format("{}: the mesh {}; close it and let its triangles run counter-clockwise seen from "
                    "outside.",
                    file.string(), flaw));
  }
  ConvexSplit split;
  split.mesh_volume = volume_of(mesh);
  if (const Polytope whole = convex_hull(mesh.vertices); is_filled(whole, split.mesh_volume)) {
    split.pieces = {whole};
    split.sum_volume = split.union_volume = volume_of_hull(whole.vertices);
    return split;
  }
  const nlohmann::json answer = run_script(request_of(mesh, settings), file);
  for (const auto& coordinates : answer.at("pieces")) {
    std::vector<Vector3> points;
    for (size_t i = 0; i + 2 < coordinates.size(); i += 3) {
      points.emplace_back(coordinates[i], coordinates[i + 1], coordinates[i + 2]);
    }
    try {
      split.pieces.push_back(convex_hull(points));
    } catch (const std::invalid_argument&) {
      continue;  // flat: nothing to touch that its neighbours do not have
    }
    split.sum_volume += volume_of_hull(split.pieces.back().vertices);
  }
  if (split.pieces.empty()) {
    throw InputError(fmt::format("{}: no piece was found; try a greater --resolution.", file.string()));
  }
  split.union_volume = union_volume(split.pieces, kUnionPointsPerAxis);
  return split;
}

}  // namespace tegotae
