// SPDX-License-Identifier: Apache-2.0
// The references of friction against statics written down by itself: balance of force and torque, Coulomb's law.
#include <tegotae/lab/friction_references.hpp>
#include <tegotae/math/rotation.hpp>

#include <gtest/gtest.h>

#include <cmath>

namespace tegotae {
namespace {

constexpr double kHalf = 0.02, kDraggedDepth = 1e-3, kDraggedSkin = 2e-6, kMu = 0.5;  // m, m, m

struct Cube {
  SceneGeometry scene;
  SessionSettings settings;

  Cube() {
    scene.tool.pieces = {make_box(Vector3::Constant(kHalf))};
    settings.stiffness = 1000.0;
    settings.metric_length = 0.02;
  }

  std::vector<ReferenceSample> asked(const Reference& reference, const std::vector<Pose>& X_WT) const {
    return reference({scene, X_WT, 1e-3, settings}, [](double) {});
  }
};

// Along x by 0.1 mm a sample, its lowest point in the floor.
std::vector<Pose> along_x(const Quaternion& q, double height, int samples, double sign = 1.0) {
  std::vector<Pose> poses;
  for (int i = 0; i < samples; ++i) poses.push_back({{sign * 1e-4 * i, 0.0, height - kDraggedDepth}, q});
  return poses;
}

TEST(FlatFaceReference, SticksElasticallyThenSlipsAtTheCone) {
  const Cube cube;
  const auto samples = cube.asked(flat_face_reference(kMu, 0.015), along_x(Quaternion::Identity(), kHalf, 100));
  const double N = 1000.0 * (kDraggedDepth + kDraggedSkin);
  for (size_t i = 0; i < samples.size(); ++i) {
    const Vector3& f = samples[i].wrench.force;
    EXPECT_NEAR(f.z(), N, 1e-12);
    EXPECT_NEAR(f.x(), -std::min(0.1 * static_cast<double>(i), kMu * N), 1e-12);
    EXPECT_TRUE(samples[i].touches && samples[i].defined);
  }
}

TEST(FlatFaceReference, TurnedAroundItUnloadsFirst) {
  const Cube cube;
  std::vector<Pose> poses = along_x(Quaternion::Identity(), kHalf, 100);
  for (int i = 98; i >= 0; --i) poses.push_back(poses[static_cast<size_t>(i)]);
  const auto samples = cube.asked(flat_face_reference(kMu, 0.015), poses);
  const double limit = kMu * 1000.0 * (kDraggedDepth + kDraggedSkin);
  EXPECT_NEAR(samples[99].wrench.force.x(), -limit, 1e-12);
  EXPECT_NEAR(samples[104].wrench.force.x(), 0.5 - limit, 1e-12) << "5 steps back: 0.5 N less";
  EXPECT_NEAR(samples.back().wrench.force.x(), limit, 1e-12);
}

TEST(FlatFaceReference, TwistIsLimitedByTheMeanDistance) {
  const Cube cube;
  std::vector<Pose> poses;
  for (int i = 0; i < 200; ++i) {
    poses.push_back({{0.0, 0.0, kHalf - kDraggedDepth}, rotation_from_vector(1e-3 * i * Vector3::UnitZ())});
  }
  const auto samples = cube.asked(flat_face_reference(kMu, 0.015), poses);
  const double limit = kMu * 1000.0 * (kDraggedDepth + kDraggedSkin) * 0.015;
  for (size_t i = 0; i < samples.size(); ++i) {
    const double elastic = 1000.0 * 4e-4 * 1e-3 * static_cast<double>(i);
    EXPECT_NEAR(samples[i].wrench.torque.z(), -std::min(elastic, limit), 1e-12);
  }
  EXPECT_LT(limit, 1000.0 * 4e-4 * 0.199);
}

TEST(FlatFaceReference, AboveTheFloorThereIsNothing) {
  const Cube cube;
  const auto samples = cube.asked(flat_face_reference(kMu, 0.015), along_x(Quaternion::Identity(), kHalf + 0.01, 20));
  for (const ReferenceSample& sample : samples) {
    EXPECT_FALSE(sample.touches);
    EXPECT_EQ(sample.wrench.force.norm() + sample.wrench.torque.norm(), 0.0);
  }
}

struct DraggedCase {
  Vector3 turn;  // rotation vector, rad
  Vector3 p_T;   // m
};

class DraggedPoint : public testing::TestWithParam<DraggedCase> {};

// Balance at the pose that the answer itself turns the tool to: the torque is the arm times the force, the force is on
// the cone against the drag, and the point rests on the floor.
TEST_P(DraggedPoint, ForceAndTorqueBalanceAtTheTurnedPose) {
  const Cube cube;
  const Quaternion q = rotation_from_vector(GetParam().turn);
  const double height = -(q * GetParam().p_T).z();
  for (const double sign : {1.0, -1.0}) {
    const auto samples = cube.asked(dragged_point_reference(GetParam().p_T, kMu), along_x(q, height, 400, sign));
    EXPECT_FALSE(samples[3].defined) << "before the slip is steady nothing is known";
    const ReferenceSample& last = samples.back();
    ASSERT_TRUE(last.defined && last.touches);
    const Vector3 f = last.wrench.force, theta = last.wrench.torque / (1000.0 * 4e-4);
    EXPECT_NEAR(f.x(), -sign * kMu * f.z(), 1e-12);
    EXPECT_NEAR(f.y(), 0.0, 1e-12);
    const Vector3 r = rotation_from_vector(theta) * (q * GetParam().p_T);
    EXPECT_LT((r.cross(f) - last.wrench.torque).norm(), 1e-9);
    EXPECT_NEAR(height - kDraggedDepth + f.z() / 1000.0 + r.z(), kDraggedSkin, 1e-9);
    EXPECT_GT(theta.norm(), 0.01) << "it turns noticeably";
  }
}

INSTANTIATE_TEST_SUITE_P(Cases, DraggedPoint,
                         testing::Values(DraggedCase{{0.0, 0.5, 0.0}, {kHalf, 0.0, -kHalf}},
                                         DraggedCase{{0.4, 0.5, 0.0}, {kHalf, -kHalf, -kHalf}}));

// To first order in the depth, on an edge: N = k d / (1 + (x^2 +- mu h x) / l^2).
TEST(DraggedPointReference, IsTheFirstOrderFormulaForLittleDepth) {
  Cube cube;
  cube.settings.stiffness = 1e5;  // the skin is 0.4 um
  const Quaternion q = rotation_from_vector(0.5 * Vector3::UnitY());
  const Vector3 p_T(kHalf, 0.0, -kHalf), r = q * p_T;
  const double depth = 5e-6, l2 = 4e-4;
  for (const double sign : {1.0, -1.0}) {
    std::vector<Pose> poses = along_x(q, -r.z(), 400, sign);
    for (Pose& pose : poses) pose.p.z() = -r.z() - depth;
    const double N = cube.asked(dragged_point_reference(p_T, kMu), poses).back().wrench.force.z();
    const double x = r.x(), h = -r.z(), skin = 0.04 / 1e5;
    const double expected = 1e5 * (depth + skin) / (1.0 + (x * x - sign * kMu * h * x) / l2);
    EXPECT_NEAR(N, expected, 2e-3 * expected) << sign;
  }
}

}  // namespace
}  // namespace tegotae
