// SPDX-License-Identifier: Apache-2.0
#include <tegotae/math/rotation.hpp>
#include <tegotae/render/tool_inertia.hpp>

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

namespace tegotae {
namespace {

TEST(ToolInertia, HasAMeanOfOneAndKeepsItsProportions) {
  MassProperties tool = mass_properties(make_box(Vector3(0.1, 0.02, 0.03)), 700.0);
  const Matrix3 shape = unit_mean_inertia(tool);
  EXPECT_NEAR(shape.trace(), 3.0, 1e-14);
  EXPECT_NEAR(shape(0, 0) / shape(2, 2), tool.inertia(0, 0) / tool.inertia(2, 2), 1e-14);
}

TEST(ToolInertia, WhatIsNotAnInertiaIsRefused) {
  MassProperties tool;
  EXPECT_THROW(unit_mean_inertia(tool), std::invalid_argument) << "zero";
  tool.inertia = Vector3(1.0, 1.0, -0.5).asDiagonal();
  EXPECT_THROW(unit_mean_inertia(tool), std::invalid_argument) << "indefinite";
  tool.inertia.setIdentity();
  tool.inertia(0, 1) = 0.1;
  EXPECT_THROW(unit_mean_inertia(tool), std::invalid_argument) << "not symmetric";
  tool.inertia(0, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(unit_mean_inertia(tool), std::invalid_argument) << "not finite";
}

TEST(ToolInertia, TheMatrixIsTurnedWithTheTool) {
  const Matrix3 shape = Vector3(0.5, 1.0, 1.5).asDiagonal();
  const Matrix3 R = rotation_from_vector({0.3, -0.7, 0.2}).toRotationMatrix();
  const Matrix6 M = rigid_body_matrix(2.0, 4.0, shape, R);
  EXPECT_EQ(M, M.transpose().eval());
  const Vector3 omega_T(0.1, 0.2, -0.3), v_W(1.0, 2.0, 3.0);
  Vector6 velocity;
  velocity << v_W, R * omega_T;
  const double twice_energy = velocity.dot(M * velocity);
  EXPECT_NEAR(twice_energy, 2.0 * v_W.squaredNorm() + 4.0 * omega_T.dot(shape * omega_T), 1e-13);
}

}  // namespace
}  // namespace tegotae
