// SPDX-License-Identifier: Apache-2.0
#include <tegotae/shape/mesh.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <fstream>

namespace tegotae {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

// A box of 1 x 2 x 3 as quadrilaterals, faces counter-clockwise seen from outside.
const std::string kBox = R"(# a box
o box
v 0 0 0
v 1 0 0
v 1 2 0
v 0 2 0
v 0 0 3
v 1 0 3
v 1 2 3
v 0 2 3
vn 0 0 1
f 4 3 2 1
f 5/1/1 6/1/1 7/1/1 8/1/1
f 1//1 2//1 6//1 5//1
f 2 3 7 6
f -6 -5 -1 -2
f 4 1 5 8
)";

class MeshTest : public ::testing::Test {
 protected:
  MeshTest()
      : folder_(std::filesystem::path(::testing::TempDir()) /
                ::testing::UnitTest::GetInstance()->current_test_info()->name()) {
    std::filesystem::create_directories(folder_);
  }
  ~MeshTest() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return folder_ / name;
  }

  std::string refusal(const std::string& name, const std::string& text) const {
    try {
      read_mesh(write(name, text));
    } catch (const MeshError& error) {
      return error.what();
    }
    return "";
  }

  std::filesystem::path folder_;
};

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

std::string binary_stl(const Mesh& mesh) {
  std::string bytes = "solid in name only";
  bytes.resize(80);
  const auto count = static_cast<std::uint32_t>(mesh.triangles.size());
  bytes.append(reinterpret_cast<const char*>(&count), sizeof count);
  for (const auto& triangle : mesh.triangles) {
    float values[12] = {};
    for (size_t k = 0; k < 3; ++k) {
      const Vector3& p = mesh.vertices[static_cast<size_t>(triangle[k])];
      for (int axis = 0; axis < 3; ++axis) values[3 + 3 * k + static_cast<size_t>(axis)] = static_cast<float>(p(axis));
    }
    bytes.append(reinterpret_cast<const char*>(values), sizeof values);
    bytes.append(2, '\0');
  }
  return bytes;
}

std::string text_stl(const Mesh& mesh) {
  std::string text = "solid box\n";
  for (const auto& triangle : mesh.triangles) {
    text += "facet normal 0 0 0\nouter loop\n";
    for (const int corner : triangle) {
      const Vector3& p = mesh.vertices[static_cast<size_t>(corner)];
      text += "vertex " + std::to_string(p.x()) + " " + std::to_string(p.y()) + " " + std::to_string(p.z()) + "\n";
    }
    text += "endloop\nendfacet\n";
  }
  return text + "endsolid box\n";
}

TEST_F(MeshTest, ABoxHasItsVolumeInEveryFormat) {
  const Mesh box = read_mesh(write("box.obj", kBox));
  for (const auto& [name, text] : {std::pair<std::string, std::string>("box.obj", kBox),
                                   {"box.STL", binary_stl(box)},
                                   {"text.stl", text_stl(box)}}) {
    const Mesh mesh = read_mesh(write(name, text));
    EXPECT_EQ(mesh.vertices.size(), 8U) << name;
    EXPECT_EQ(mesh.triangles.size(), 12U) << name;
    EXPECT_NEAR(volume_of(mesh), 6.0, 1e-12) << name;
    EXPECT_EQ(flaw_of(mesh), "") << name;
  }
}

TEST_F(MeshTest, VolumeDoesNotDependOnThePlace) {
  Mesh mesh = read_mesh(write("box.obj", kBox));
  for (Vector3& p : mesh.vertices) p += Vector3(1e6, -2e6, 3e6);
  EXPECT_NEAR(volume_of(mesh), 6.0, 1e-8);
}

TEST_F(MeshTest, FlawsAreNamed) {
  Mesh mesh = read_mesh(write("box.obj", kBox));
  Mesh holed = mesh, flipped = mesh, inside_out = mesh;
  holed.triangles.pop_back();
  EXPECT_THAT(flaw_of(holed), HasSubstr("hole or a border"));
  std::swap(flipped.triangles[3][0], flipped.triangles[3][1]);
  EXPECT_THAT(flaw_of(flipped), HasSubstr("in the same direction"));
  for (auto& triangle : inside_out.triangles) std::swap(triangle[0], triangle[1]);
  EXPECT_THAT(flaw_of(inside_out), HasSubstr("inside out"));
  EXPECT_THAT(flaw_of(Mesh{}), HasSubstr("no triangle"));
}

TEST_F(MeshTest, BadFilesAreRefusedWithFileAndLine) {
  const std::string obj = (folder_ / "m.obj").string(), stl = (folder_ / "m.stl").string();
  EXPECT_THAT(refusal("m.obj", replaced(kBox, "v 1 0 0", "v 1 0")), StartsWith(obj + ":4: a vertex needs three"));
  EXPECT_THAT(refusal("m.obj", replaced(kBox, "v 1 0 0", "v 1 nan 0")), StartsWith(obj + ":4: "));
  EXPECT_THAT(refusal("m.obj", replaced(kBox, "f 2 3 7 6", "f 2 3 9 6")),
              AllOf(StartsWith(obj + ":15: "), HasSubstr("vertex '9', and there are 8")));
  EXPECT_THAT(refusal("m.obj", replaced(kBox, "f 2 3 7 6", "f 0 3 7 6")), StartsWith(obj + ":15: "));
  EXPECT_THAT(refusal("m.obj", replaced(kBox, "f 2 3 7 6", "f 2 x3 7 6")), StartsWith(obj + ":15: "));
  EXPECT_THAT(refusal("m.obj", replaced(kBox, "f 2 3 7 6", "f 2 3")), HasSubstr("fewer than 3 corners"));
  EXPECT_THAT(refusal("m.obj", "v 0 0 0\n"), HasSubstr("no triangle"));
  EXPECT_THAT(refusal("m.stl", ""), HasSubstr("no STL"));
  EXPECT_THAT(refusal("m.stl", std::string(500, 'x')), HasSubstr("no STL"));
  EXPECT_THAT(refusal("m.stl", "solid a\nfacet\nvertex 0 0\n"), StartsWith(stl + ":3: "));
  EXPECT_THAT(refusal("m.stl", "solid a\nfacet\nvertex 0 0 0\nvertex 1 0 0\nendfacet\n"), StartsWith(stl + ":5: "));
  EXPECT_THAT(refusal("m.stl", "solid a\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\nvertex 1 2 0\nendfacet\n"),
              StartsWith(stl + ":5: "));
  EXPECT_THAT(refusal("m.ply", kBox), HasSubstr(".obj or .stl"));
  EXPECT_THROW(read_mesh(folder_ / "gone.obj"), MeshError);
  std::string infinite = binary_stl(read_mesh(write("box.obj", kBox)));
  const float infinity = HUGE_VALF;
  std::memcpy(infinite.data() + 84 + 12, &infinity, sizeof infinity);
  EXPECT_THAT(refusal("m.stl", infinite), HasSubstr("triangle 1 has a corner that is not finite"));
}

}  // namespace
}  // namespace tegotae
