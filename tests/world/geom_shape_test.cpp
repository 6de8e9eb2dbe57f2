// SPDX-License-Identifier: Apache-2.0
#include <tests/world/scene_files.hpp>

#include <mujoco/mujoco.h>

#include <array>

namespace tegotae {
namespace {

class GeomShape : public test::SceneFiles {};

// One geom of each kind on a static, a moving and a tool body, all turned and shifted.
const std::string kAllKinds = R"(
  <asset><mesh name="wedge" vertex="0 0 0 0.3 0 0 0 0.2 0 0.3 0.2 0 0 0 0.1 0 0.2 0.1"/></asset>
  <default><geom contype="3" conaffinity="5" friction="0.7 0.01 0.001"/></default>
  <worldbody>
    <geom name="ground" type="plane" size="1 1 1" pos="0 0 -1" euler="5 10 15"/>
    <body name="static" pos="1 2 3" euler="10 20 30">
      <geom name="sphere" size="0.1" pos="0.1 0.2 0.3"/>
      <body name="static child" pos="-0.4 0 0.2" euler="40 0 0">
        <geom name="capsule" type="capsule" fromto="0 0 0 0.1 0.2 0.3" size="0.02"/>
      </body>
    </body>
    <body name="moving" pos="-1 -2 3" euler="-10 0 50">
      <freejoint/>
      <geom name="box" type="box" size="0.1 0.2 0.3" pos="0.3 0 0" euler="0 45 0" condim="1"/>
      <body name="carried" pos="0 1 0" euler="0 0 33"><geom name="ellipsoid" type="ellipsoid" size="0.1 0.2 0.3"/></body>
      <body name="jointed" pos="0 2 0" euler="0 70 0">
        <joint axis="0 1 0"/>
        <geom name="cylinder" type="cylinder" size="0.1 0.2" pos="0 0 0.1"/>
      </body>
    </body>
    <body name="tool" pos="0.5 0.6 0.7" euler="11 22 33" mocap="true">
      <geom name="mesh" type="mesh" mesh="wedge" pos="0.1 0 0" euler="0 0 90"/>
      <body name="tip" pos="0 0 0.3" euler="0 30 0">
        <geom name="tip" type="mesh" mesh="wedge" pos="0.2 0.1 0" euler="20 0 0"/>
      </body>
    </body>
  </worldbody>)";

struct Expected {
  const char* geom;
  ShapeKind kind;
  Vector3 size;
};

// Where MuJoCo itself puts a geom.
class Reference {
 public:
  explicit Reference(const std::string& file) {
    std::array<char, 500> error{};
    model_ = mj_loadXML(file.c_str(), nullptr, error.data(), static_cast<int>(error.size()));
    if (model_ == nullptr) throw std::runtime_error(error.data());
    data_ = mj_makeData(model_);
    mj_forward(model_, data_);
  }
  Reference(const Reference&) = delete;
  Reference& operator=(const Reference&) = delete;
  ~Reference() {
    mj_deleteData(data_);
    mj_deleteModel(model_);
  }
  void expect_at(const Pose& X_WS, const char* geom) const {
    const int id = mj_name2id(model_, mjOBJ_GEOM, geom);
    const Matrix3 R = X_WS.rotation();
    for (int i = 0; i < 3; ++i) {
      EXPECT_NEAR(X_WS.p[i], data_->geom_xpos[3 * id + i], 1e-14) << geom;
      for (int j = 0; j < 3; ++j) EXPECT_NEAR(R(i, j), data_->geom_xmat[9 * id + 3 * i + j], 1e-14) << geom;
    }
  }

 private:
  mjModel* model_ = nullptr;
  mjData* data_ = nullptr;
};

TEST_F(GeomShape, EveryKindStandsWhereMujocoHasIt) {
  const auto world = load(kAllKinds);
  const SceneGeometry& scene = world->geometry();
  const Reference reference((folder() / "scene.xml").string());
  const std::vector<std::vector<Expected>> expected = {
      {{"ground", ShapeKind::kPlane, {0.0, 0.0, 0.0}}},
      {{"sphere", ShapeKind::kSphere, {0.1, 0.0, 0.0}}},
      {{"capsule", ShapeKind::kCapsule, {0.02, std::sqrt(0.14) / 2.0, 0.0}}},
      {{"box", ShapeKind::kBox, {0.1, 0.2, 0.3}}},
      {{"ellipsoid", ShapeKind::kEllipsoid, {0.1, 0.2, 0.3}}},
      {{"cylinder", ShapeKind::kCylinder, {0.1, 0.2, 0.0}}}};
  ASSERT_EQ(scene.bodies.size(), expected.size());
  for (size_t b = 0; b < expected.size(); ++b) {
    ASSERT_EQ(scene.bodies[b].pieces.size(), expected[b].size());
    for (size_t i = 0; i < expected[b].size(); ++i) {
      const Shape& piece = scene.bodies[b].pieces[i];
      EXPECT_EQ(piece.kind, expected[b][i].kind);
      EXPECT_LT((piece.size - expected[b][i].size).norm(), 1e-15) << expected[b][i].geom;
      reference.expect_at(scene.bodies[b].X_WB * piece.X_BS, expected[b][i].geom);
    }
  }
  ASSERT_EQ(scene.tool.pieces.size(), 2U);
  reference.expect_at(scene.tool.X_WT * scene.tool.pieces[0].X_BS, "mesh");
  reference.expect_at(scene.tool.X_WT * scene.tool.pieces[1].X_BS, "tip");
}

TEST_F(GeomShape, BodiesMoveIfAnyJointAboveThemDoes) {
  const auto world = load(kAllKinds);
  std::vector<std::pair<std::string, int>> found;
  for (const Body& body : world->geometry().bodies) found.emplace_back(body.name, body.moving_index);
  const std::vector<std::pair<std::string, int>> expected = {{"world", -1}, {"static", -1}, {"static child", -1},
                                                             {"moving", 0}, {"carried", 1}, {"jointed", 2}};
  EXPECT_EQ(found, expected);
  EXPECT_EQ(world->geometry().moving_count, 3);
}

TEST_F(GeomShape, MeshesAreHullsAtTheirVertices) {
  const auto world = load(kAllKinds);
  const Shape& wedge = world->geometry().tool.pieces[0];
  ASSERT_EQ(wedge.kind, ShapeKind::kHull);
  EXPECT_EQ(wedge.polytope->vertices.size(), 6U);
  EXPECT_EQ(wedge.polytope->faces.size(), 5U);
  // The file's vertex (0.3, 0, 0), turned by 90 degrees about z and shifted by 0.1 along x.
  double nearest = 1.0;
  for (const Vector3& v : wedge.polytope->vertices) {
    nearest = std::min(nearest, (wedge.X_BS * v - Vector3(0.1, 0.3, 0.0)).norm());
  }
  EXPECT_LT(nearest, 1e-7);
}

TEST_F(GeomShape, TakesFrictionAndFilter) {
  const auto world = load(kAllKinds);
  for (const Body& body : world->geometry().bodies) {
    for (const Shape& piece : body.pieces) {
      EXPECT_EQ(piece.friction, 0.7);
      EXPECT_EQ(piece.contact_type, 3);
      EXPECT_EQ(piece.contact_affinity, 5);
      EXPECT_EQ(piece.frictionless, piece.kind == ShapeKind::kBox);
    }
  }
}

// As MuJoCo draws them: a material's colour, but for geoms with one of their own; else grey.
TEST_F(GeomShape, TakesColoursOfGeomsAndMaterials) {
  const auto world = load(R"(
    <asset><material name="wood" rgba="0.75 0.5 0.25 1"/></asset>
    <worldbody>
      <geom size="0.1" material="wood"/>
      <geom size="0.1" material="wood" rgba="0.125 0.25 0.5 0.5"/>
      <geom size="0.1"/>
      <body name="tool" mocap="true" pos="0 0 5"><geom size="0.05" rgba="1 0 0 1"/></body>
    </worldbody>)");
  const std::vector<Shape>& pieces = world->geometry().bodies.at(0).pieces;
  ASSERT_EQ(pieces.size(), 3U);
  EXPECT_EQ(pieces[0].colour, (Colour{0.75F, 0.5F, 0.25F, 1.0F}));
  EXPECT_EQ(pieces[1].colour, (Colour{0.125F, 0.25F, 0.5F, 0.5F}));
  EXPECT_EQ(pieces[2].colour, Colour{});
  EXPECT_EQ(world->geometry().tool.pieces.at(0).colour, (Colour{1.0F, 0.0F, 0.0F, 1.0F}));
}

TEST_F(GeomShape, MassOfACompoundToolIsThatOfItsParts) {
  const auto world = load(R"(<worldbody><geom type="plane" size="1 1 1"/><body name="tool" mocap="true">
    <geom type="box" size="0.1 0.1 0.1" pos="0.2 0 0"/>
    <body pos="0 0.3 0" euler="0 0 40"><geom type="box" size="0.05 0.1 0.2" density="2000"/></body>
    </body></worldbody>)");
  const MassProperties& mass = world->geometry().tool.mass;
  EXPECT_NEAR(mass.mass, 8.0 + 16.0, 1e-12);
  EXPECT_LT((mass.centre_of_mass - Vector3(0.2 / 3.0, 0.2, 0.0)).norm(), 1e-14);
  const auto& pieces = world->geometry().tool.pieces;
  const MassProperties whole =
      combined(std::vector<MassProperties>{mass_properties(pieces[0], 1000.0), mass_properties(pieces[1], 2000.0)});
  EXPECT_LT((mass.inertia - whole.inertia).norm(), 1e-13);
}

TEST_F(GeomShape, MassIsThatOfTheInertialWhereThereIsOneAndOfWaterWhereThereIsNone) {
  const std::string floor = R"(<geom type="plane" size="1 1 1"/>)";
  const auto given = load("<worldbody>" + floor + R"(<body name="tool" mocap="true">
    <inertial pos="0 0 0.1" mass="3" diaginertia="0.3 0.2 0.1"/><geom size="0.1"/></body></worldbody>)");
  EXPECT_EQ(given->geometry().tool.mass.mass, 3.0);
  EXPECT_LT((given->geometry().tool.mass.centre_of_mass - Vector3(0.0, 0.0, 0.1)).norm(), 1e-15);
  EXPECT_NEAR(given->geometry().tool.mass.inertia(1, 1), 0.2, 1e-15);
  const auto none = load("<worldbody>" + floor + R"(<body name="tool" mocap="true">
    <geom type="box" size="0.1 0.1 0.1" mass="0"/></body></worldbody>)");
  EXPECT_NEAR(none->geometry().tool.mass.mass, 8.0, 1e-12);
}

TEST_F(GeomShape, NonConvexMeshesAreUsedAsTheirHullWithAWarning) {
  // An L-shaped prism: the inner corner is dented.
  const std::string prism = R"(<asset><mesh name="L" vertex="0 0 0 2 0 0 2 1 0 1 1 0 1 2 0 0 2 0
      0 0 1 2 0 1 2 1 1 1 1 1 1 2 1 0 2 1" face="0 2 1 0 3 2 0 4 3 0 5 4 6 7 8 6 8 9 6 9 10 6 10 11
      0 1 7 0 7 6 1 2 8 1 8 7 2 3 9 2 9 8 3 4 10 3 10 9 4 5 11 4 11 10 5 0 6 5 6 11"/></asset>)";
  const auto world =
      load(prism + "<worldbody>" + test::kTool + R"(<geom name="corner" type="mesh" mesh="L"/></worldbody>)");
  ASSERT_EQ(world->warnings().size(), 1U);
  const std::string& warning = world->warnings()[0];
  for (const char* part : {"scene.xml", "geom 'corner'", "not convex", "hull"}) {
    EXPECT_NE(warning.find(part), std::string::npos) << warning;
  }
  EXPECT_NEAR(mass_properties(world->geometry().bodies[0].pieces[0], 1.0).mass, 3.5, 1e-5);
}

// A mesh all of whose vertices are extreme can be dented all the same: here one face of a box leans inwards.
TEST_F(GeomShape, ADentWithoutInnerVerticesIsFound) {
  const std::string dented = R"(<asset><mesh name="dent" vertex="0 0 0 1 0 0 1 1 0 0 1 0 0 0 1 1 0 1 1 1 1.2 0 1 1.0"
      face="0 2 1 0 3 2 4 5 7 5 6 7 0 1 5 0 5 4 1 2 6 1 6 5 2 3 7 2 7 6 3 0 4 3 4 7"/></asset>)";
  const auto world = load(dented + "<worldbody>" + test::kTool + R"(<geom type="mesh" mesh="dent"/></worldbody>)");
  ASSERT_EQ(world->warnings().size(), 1U);
  EXPECT_NE(world->warnings()[0].find("geom 0 of body 'world'"), std::string::npos) << world->warnings()[0];
}

TEST_F(GeomShape, HeightFieldsAreRefusedUnlessTheyAreOnlySeen) {
  const std::string field = R"(<asset><hfield name="hills" nrow="3" ncol="3" size="1 1 0.1 0.1"/></asset>)";
  const std::string refused =
      refusal(field + "<worldbody>" + test::kTool + R"(<geom name="land" type="hfield" hfield="hills"/></worldbody>)");
  for (const char* part : {"scene.xml", "geom 'land'", "height fields", "boxes or convex meshes"}) {
    EXPECT_NE(refused.find(part), std::string::npos) << refused;
  }
  EXPECT_EQ(refusal(field + "<worldbody>" + test::kTool + test::kFloor +
                    R"(<geom type="hfield" hfield="hills" contype="0" conaffinity="0"/></worldbody>)"),
            "");
}

}  // namespace
}  // namespace tegotae
