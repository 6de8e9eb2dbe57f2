// SPDX-License-Identifier: Apache-2.0
#include <tegotae/device/axis_map.hpp>
#include <tegotae/math/rotation.hpp>

#include <gtest/gtest.h>

#include <set>
#include <stdexcept>
#include <string>

namespace tegotae {
namespace {

TEST(AxisMap, KeepsTheAxesUnlessTold) {
  EXPECT_EQ(AxisMap().R_WD(), Matrix3::Identity());
  EXPECT_EQ(AxisMap("xyz").R_WD(), Matrix3::Identity());
}

// x towards the person, y to the right, z up becomes x to the right, y away from the person, z up.
TEST(AxisMap, RenamesVectorsThereAndBack) {
  const AxisMap axes("y-xz");
  const Vector3 v_D(1.0, 2.0, 3.0);
  EXPECT_EQ(axes.to_world(v_D), Vector3(2.0, -1.0, 3.0));
  EXPECT_EQ(axes.to_device(axes.to_world(v_D)), v_D);
}

TEST(AxisMap, AnUnrotatedGripStaysSoAndATurnIsAboutTheRenamedAxis) {
  const AxisMap axes("y-xz");
  const Pose X = axes.to_world({1.0, 2.0, 3.0}, Matrix3::Identity());
  EXPECT_LT(rotation_vector(X.q).norm(), 1e-15);
  EXPECT_EQ(X.p, Vector3(2.0, -1.0, 3.0));
  const Vector3 turn_D(0.1, 0.2, 0.3);
  const Pose turned = axes.to_world(Vector3::Zero(), rotation_from_vector(turn_D).toRotationMatrix());
  EXPECT_LT((rotation_vector(turned.q) - axes.to_world(turn_D)).norm(), 1e-15);
}

TEST(AxisMap, ThereAreTwentyFourRightHandedTurnsAndNothingElseIsTaken) {
  std::set<std::string> taken;
  const std::string axes[] = {"x", "-x", "y", "-y", "z", "-z"};
  for (const auto& first : axes) {
    for (const auto& second : axes) {
      for (const auto& third : axes) {
        std::string names = first;
        names.append(second).append(third);
        try {
          const AxisMap map(names);
          EXPECT_EQ(map.R_WD().determinant(), 1.0);
          taken.insert(names);
        } catch (const std::invalid_argument&) {
        }
      }
    }
  }
  EXPECT_EQ(taken.size(), 24u);
  for (const char* text : {"", "x", "xy", "xyz ", "xyzx", "--xyz", "xy-", "XYZ", "yxz"}) {
    EXPECT_THROW(AxisMap{text}, std::invalid_argument) << text;
  }
}

}  // namespace
}  // namespace tegotae
