// SPDX-License-Identifier: Apache-2.0
#include <tegotae/render/coupling.hpp>

#include <gtest/gtest.h>

namespace tegotae {
namespace {

TEST(Coupling, MetricOfOneMetreGivesThePapersEquations) {
  const Coupling coupling{9000.0, 3.0, 1.0};
  Vector6 now, before;
  now << 1e-3, -2e-3, 3e-3, 0.01, 0.02, -0.03;
  before << 0.5e-3, -1e-3, 3e-3, 0.01, 0.0, -0.01;
  const Wrench wrench = coupling.wrench(now, before, 1e-3);
  for (int i = 0; i < 3; ++i) {
    EXPECT_DOUBLE_EQ(wrench.force(i), 9000.0 * now(i) + 3.0 * (now(i) - before(i)) / 1e-3);
    EXPECT_DOUBLE_EQ(wrench.torque(i), 9000.0 * now(3 + i) + 3.0 * (now(3 + i) - before(3 + i)) / 1e-3);
  }
}

TEST(Coupling, RotationalTermsScaleWithTheSquareOfTheMetricLength) {
  Vector6 turn = Vector6::Zero();
  turn(4) = 0.1;
  const Wrench one = Coupling{1000.0, 2.0, 1.0}.wrench(turn, Vector6::Zero(), 1e-3);
  const Wrench tenth = Coupling{1000.0, 2.0, 0.1}.wrench(turn, Vector6::Zero(), 1e-3);
  EXPECT_NEAR(tenth.torque.y(), 0.01 * one.torque.y(), 1e-12);
  EXPECT_EQ(tenth.force, Vector3::Zero());
}

TEST(Coupling, DampsRotationByItsOwnTermWhereThereIsOne) {
  Coupling coupling{1000.0, 2.0, 0.1};
  coupling.rotational_damping = 0.3;
  Vector6 turn = Vector6::Zero();
  turn(4) = 0.1;
  EXPECT_NEAR(coupling.wrench(turn, Vector6::Zero(), 1e-3).torque.y(), 1000.0 * 0.01 * 0.1 + 0.3 * 100.0, 1e-12);
  EXPECT_NEAR(coupling.wrench(turn, turn, 1e-3).torque.y(), 1.0, 1e-12);
}

TEST(Coupling, StiffnessMatrixGivesTheElasticWrench) {
  const Coupling coupling{1234.0, 0.0, 0.2};
  Vector6 x;
  x << 1, 2, 3, 4, 5, 6;
  const Wrench wrench = coupling.wrench(x, x, 1e-3);
  const Vector6 Kx = coupling.stiffness_matrix() * x;
  EXPECT_LT((Kx.head<3>() - wrench.force).norm(), 1e-12 * Kx.norm());
  EXPECT_LT((Kx.tail<3>() - wrench.torque).norm(), 1e-12 * Kx.norm());
}

}  // namespace
}  // namespace tegotae
