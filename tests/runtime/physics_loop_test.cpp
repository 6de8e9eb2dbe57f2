// SPDX-License-Identifier: Apache-2.0
#include <tegotae/runtime/physics_loop.hpp>

#include <tests/free_body_world.hpp>

#include <gtest/gtest.h>

#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace tegotae {
namespace {

// A world of nothing but a geometry, right or wrong.
class GeometryOnly : public World {
 public:
  GeometryOnly(const std::vector<int>& moving_indices, int moving_count) : geometry_(test::cube_over_floor()) {
    const Body block = geometry_.bodies.front();
    geometry_.bodies.clear();
    for (const int index : moving_indices) {
      Body& body = geometry_.bodies.emplace_back(block);
      body.name = std::string(1, static_cast<char>('a' + static_cast<int>(geometry_.bodies.size()) - 1));
      body.moving_index = index;
    }
    geometry_.moving_count = moving_count;
  }
  const SceneGeometry& geometry() const override { return geometry_; }
  void read_bodies(std::span<BodyState>) const override {}
  void advance(double, const ToolState&, std::span<const BodyImpulse>) override {}

 private:
  SceneGeometry geometry_;
};

// The sentence with which the world is refused; empty if it is not.
std::string refusal(const std::vector<int>& moving_indices, int moving_count) {
  GeometryOnly world(moving_indices, moving_count);
  try {
    const PhysicsLoop loop(world, {0.05, 0.002}, ModelNeeds{});
    EXPECT_EQ(loop.body_count(), moving_count);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return {};
}

void expect_refused(const std::vector<int>& moving_indices, int moving_count, const std::string& reason) {
  const std::string sentence = refusal(moving_indices, moving_count);
  EXPECT_NE(sentence.find("the world's geometry is not consistent: " + reason + "; give"), std::string::npos)
      << sentence;
}

TEST(PhysicsLoop, TakesMovingBodiesInAnyOrderAmongStaticOnes) {
  EXPECT_EQ(refusal({}, 0), "");
  EXPECT_EQ(refusal({-1, -1}, 0), "");
  EXPECT_EQ(refusal({2, -1, 0, 1}, 3), "");
}

TEST(PhysicsLoop, RefusesMovingIndicesThatAreNotEachOnce) {
  expect_refused({0, 1}, 1, "body 'b' has the moving_index 1, but moving_count is 1");
  expect_refused({0}, 0, "body 'a' has the moving_index 0, but moving_count is 0");
  expect_refused({0, 0}, 2, "body 'b' has the moving_index 0, which another body has too");
  expect_refused({0, -1}, 2, "no body has the moving_index 1, but moving_count is 2");
  expect_refused({-1}, -1, "moving_count is -1");
}

// At rest 45 mm over the floor. A brisk hand is there before the model made now has served its time, two periods.
TEST(PhysicsLoop, NamesWhatAHandThatSpeedsUpMayComeTo) {
  GeometryOnly world({-1}, 0);
  const Pose X_WT{{0.0, 0.145, 0.0}, Quaternion::Identity()};
  const auto near_at = [&](double period, const ModelNeeds& needs) {
    PhysicsLoop loop(world, {period, 0.002}, needs);
    auto model = std::make_unique<IntermediateRepresentation>();
    loop.build(0.0, {X_WT, Twist{}}, *model);
    return model->near_object_count;
  };
  EXPECT_EQ(near_at(0.05, {false, true}), 1);
  EXPECT_EQ(near_at(0.02, {false, true}), 0) << "8 mm of speeding up";
  EXPECT_EQ(near_at(0.05, {true, false}), 0) << "the others get no more points for it";
}

}  // namespace
}  // namespace tegotae
