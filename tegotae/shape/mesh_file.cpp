// SPDX-License-Identifier: Apache-2.0
#include <tegotae/shape/mesh.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstring>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>

namespace tegotae {
namespace {

constexpr size_t kStlHeader = 84, kStlTriangle = 50;  // bytes

[[noreturn]] void refuse(const std::filesystem::path& file, size_t line, const std::string& what) {
  throw MeshError(line > 0 ? fmt::format("{}:{}: {}", file.string(), line, what)
                           : fmt::format("{}: {}", file.string(), what));
}

std::string read_all(const std::filesystem::path& file) {
  std::error_code error;
  std::ifstream stream(file, std::ios::binary);
  if (!stream || std::filesystem::is_directory(file, error)) {
    refuse(file, 0, "no such mesh file, or it may not be read; name an OBJ or STL file");
  }
  return {std::istreambuf_iterator<char>(stream), {}};
}

bool all_finite(const Vector3& p) { return std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z()); }

// The vertex that a corner of an OBJ face names ("3", "3/1", "-1//2"), from 0; -1: none.
int obj_corner(const std::string& word, size_t vertex_count) {
  std::istringstream text(word.substr(0, word.find('/')));
  long index = 0;
  if (!(text >> index) || !text.eof()) return -1;
  const long count = static_cast<long>(vertex_count);
  if (index < 0) index += count + 1;
  return index >= 1 && index <= count ? static_cast<int>(index - 1) : -1;
}

void add_obj_face(std::istringstream& words, const std::filesystem::path& file, size_t line, Mesh& mesh) {
  std::vector<int> corners;
  for (std::string word; words >> word;) {
    corners.push_back(obj_corner(word, mesh.vertices.size()));
    if (corners.back() < 0) {
      refuse(file, line,
             fmt::format("the face names the vertex '{}', and there are {} above it; mend the number", word,
                         mesh.vertices.size()));
    }
  }
  if (corners.size() < 3) refuse(file, line, "the face has fewer than 3 corners; remove it");
  for (size_t k = 2; k < corners.size(); ++k) mesh.triangles.push_back({corners[0], corners[k - 1], corners[k]});
}

Mesh read_obj(const std::filesystem::path& file, const std::string& text) {
  Mesh mesh;
  std::istringstream lines(text);
  std::string line;
  for (size_t number = 1; std::getline(lines, line); ++number) {
    std::istringstream words(line);
    std::string kind;
    words >> kind;
    if (kind == "v") {
      Vector3 p;
      if (!(words >> p.x() >> p.y() >> p.z()) || !all_finite(p)) {
        refuse(file, number, "a vertex needs three finite numbers; write 'v x y z'");
      }
      mesh.vertices.push_back(p);
    } else if (kind == "f") {
      add_obj_face(words, file, number, mesh);
    }
  }
  return mesh;
}

// Corners of equal coordinates are one vertex.
class Welder {
 public:
  int index_of(const Vector3& p) {
    const auto [place, is_new] = places_.try_emplace({p.x(), p.y(), p.z()}, static_cast<int>(mesh.vertices.size()));
    if (is_new) mesh.vertices.push_back(p);
    return place->second;
  }
  // A sliver between equal corners has no surface.
  void add(const std::array<Vector3, 3>& corners) {
    const std::array<int, 3> triangle{index_of(corners[0]), index_of(corners[1]), index_of(corners[2])};
    if (triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[2] == triangle[0]) return;
    mesh.triangles.push_back(triangle);
  }

  Mesh mesh;

 private:
  std::map<std::array<double, 3>, int> places_;
};

Mesh read_binary_stl(const std::filesystem::path& file, const std::string& bytes) {
  Welder welder;
  const size_t count = (bytes.size() - kStlHeader) / kStlTriangle;
  for (size_t i = 0; i < count; ++i) {
    float values[12];
    std::memcpy(values, bytes.data() + kStlHeader + i * kStlTriangle, sizeof values);
    std::array<Vector3, 3> corners;
    for (size_t k = 0; k < 3; ++k) {
      const float* v = values + 3 + 3 * k;
      corners[k] = Vector3(static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2]));
      if (!all_finite(corners[k])) {
        refuse(file, 0, fmt::format("triangle {} has a corner that is not finite; export the mesh anew", i + 1));
      }
    }
    welder.add(corners);
  }
  return std::move(welder.mesh);
}

Mesh read_text_stl(const std::filesystem::path& file, const std::string& text) {
  Welder welder;
  std::istringstream lines(text);
  std::string line;
  std::array<Vector3, 3> corners;
  size_t corner = 0;
  for (size_t number = 1; std::getline(lines, line); ++number) {
    std::istringstream words(line);
    std::string kind;
    words >> kind;
    if (kind == "endfacet") {
      if (corner != 3) refuse(file, number, fmt::format("the facet has {} corners and needs 3", corner));
      welder.add(corners);
      corner = 0;
    } else if (kind == "vertex") {
      Vector3 p;
      if (!(words >> p.x() >> p.y() >> p.z()) || !all_finite(p)) {
        refuse(file, number, "a corner needs three finite numbers; write 'vertex x y z'");
      }
      if (corner == 3) refuse(file, number, "the facet has more than 3 corners");
      corners[corner++] = p;
    }
  }
  return std::move(welder.mesh);
}

// A binary file tells how many triangles it has; some of them begin with "solid" as text files do.
bool is_binary_stl(const std::string& bytes) {
  if (bytes.size() < kStlHeader) return false;
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + kStlHeader - sizeof count, sizeof count);
  return bytes.size() == kStlHeader + kStlTriangle * static_cast<size_t>(count);
}

}  // namespace

Mesh read_mesh(const std::filesystem::path& file) {
  std::string ending = file.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return std::tolower(c); });
  const bool is_obj = ending == ".obj";
  if (!is_obj && ending != ".stl") refuse(file, 0, "mesh files end in .obj or .stl; convert it to one of them");
  const std::string bytes = read_all(file);
  Mesh mesh;
  if (is_obj) {
    mesh = read_obj(file, bytes);
  } else if (is_binary_stl(bytes)) {
    mesh = read_binary_stl(file, bytes);
  } else if (bytes.compare(0, 5, "solid") == 0) {
    mesh = read_text_stl(file, bytes);
  } else {
    refuse(file, 0, "this is no STL file: neither its size nor its beginning fits; export the mesh anew");
  }
  if (mesh.triangles.empty()) refuse(file, 0, "the mesh has no triangle; export a surface");
  return mesh;
}

}  // namespace tegotae
