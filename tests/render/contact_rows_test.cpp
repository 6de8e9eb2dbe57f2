// SPDX-License-Identifier: Apache-2.0
#include <tegotae/render/contact_rows.hpp>
#include <tegotae/render/tolerances.hpp>

#include <tests/render/contact_models.hpp>

#include <gtest/gtest.h>

#include <vector>

namespace tegotae {
namespace {

using test::kHalfEdge;

TEST(ContactRows, EveryPointIsVisitedAgainstItsOwnPlane) {
  const auto model = test::cube_in_a_corner();
  std::vector<PointOnPlane> visited;
  const Pose X_WT{{-0.01, kHalfEdge - 0.002, 0.0}, Quaternion::Identity()};
  visit_contact_points(*model, X_WT, [&](const PointOnPlane& contact) { visited.push_back(contact); });
  ASSERT_EQ(visited.size(), 16u);
  for (const PointOnPlane& contact : visited) {
    const bool floor = contact.plane == 0;
    EXPECT_EQ(contact.n_W, floor ? Vector3(0.0, 1.0, 0.0) : Vector3(1.0, 0.0, 0.0));
    EXPECT_NEAR(contact.depth, floor ? -contact.p_WC.y() : -(contact.p_WC.x() + kHalfEdge), 1e-15);
  }
  EXPECT_EQ(visited[8].point, 8);
  EXPECT_NEAR(deepest_penetration(*model, X_WT), 0.01, 1e-15);
  EXPECT_EQ(deepest_penetration(*model, {{1.0, 1.0, 0.0}, Quaternion::Identity()}), 0.0);
}

TEST(ContactRows, ARowIsTheWayOfItsPointAlongTheNormal) {
  PointOnPlane contact;
  contact.n_W = Vector3(1.0, 2.0, -0.5).normalized();
  contact.p_WC = Vector3(0.3, -0.1, 0.2);
  const Vector3 centre(0.1, 0.1, 0.1), dr(1e-3, 2e-3, 3e-3), dtheta(4e-3, -5e-3, 6e-3);
  Vector6 d;
  d << dr, dtheta;
  const double way = contact.n_W.dot(dr + dtheta.cross(contact.p_WC - centre));
  const Vector6 J = normal_row(contact, centre);
  EXPECT_NEAR(J.dot(d), way, 1e-17);
  const Coupling coupling{500.0, 0.0, 0.2};
  const double own = J.dot(coupling.stiffness_matrix().diagonal().cwiseInverse().cwiseProduct(J));
  EXPECT_NEAR(row_compliance(coupling, J), tolerance::kRowCompliance * own, 1e-12 * own);
}

TEST(ContactRows, RowsBeyondTheProblemsCapacityAreDropped) {
  ConstraintProblem<6> problem(4, 0);
  problem.set_objective(Matrix6::Identity(), Vector6::Zero());
  ContactRows rows;
  const auto model = test::cube_on_floor();
  visit_contact_points(*model, Pose{}, [&](const PointOnPlane& contact) {
    rows.add(contact, normal_row(contact, Vector3::Zero()), contact.depth, 1e-3, problem);
  });
  EXPECT_EQ(rows.count(), 4);
  EXPECT_EQ(problem.dropped_count(), 4);
  rows.clear();
  EXPECT_EQ(rows.count(), 0);
}

TEST(ContactRows, BeginningClearsWhatTheLastTickLeft) {
  const auto model = test::cube_on_floor();
  RenderOutput output;
  output.wrench.force = Vector3::Ones();
  output.bodies.add(model->planes[0], Vector3::Zero(), Vector3::Ones());
  output.constraint_count = output.active_count = output.solver_iterations = 3;
  output.deepest = 1.0;
  output.status = RenderStatus::kInfeasible;
  const Pose X_WT{{1.0, 2.0, 3.0}, Quaternion::Identity()};
  EXPECT_TRUE(begin_render({*model, X_WT, 1e-3}, output));
  EXPECT_EQ(output.status, RenderStatus::kOk);
  EXPECT_EQ(output.wrench.force.norm(), 0.0);
  EXPECT_EQ(output.constraint_count + output.active_count + output.solver_iterations, 0);
  EXPECT_EQ(output.deepest, 0.0);
  EXPECT_EQ(output.X_WP.p, X_WT.p);
  EXPECT_TRUE(output.bodies.moving().empty());
}

}  // namespace
}  // namespace tegotae
