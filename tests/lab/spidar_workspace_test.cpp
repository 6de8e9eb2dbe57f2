// SPDX-License-Identifier: Apache-2.0
#include <tegotae/device/spidar_presets.hpp>
#include <tegotae/lab/spidar_workspace.hpp>
#include <tegotae/math/rotation.hpp>
#include <tests/lab/samples_table.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

namespace tegotae {
namespace {

double force_at(const SpidarGeometry& geometry, const Vector3& p, const Vector3& turn) {
  return spidar_reach(geometry, {p, rotation_from_vector(turn)}).force;
}

TEST(SpidarWorkspace, EndsWhereTheStringsCeaseToPushToEverySide) {
  for (const char* name : {"x3r", "x4r"}) {
    const SpidarGeometry& geometry = spidar_preset(name).geometry;
    const SpidarWorkspace workspace = spidar_workspace(geometry);
    EXPECT_EQ(workspace.at_centre.force, force_at(geometry, Vector3::Zero(), Vector3::Zero()));
    for (int axis = 0; axis < 3; ++axis) {
      for (const double sign : {-1.0, 1.0}) {
        const Vector3 along = sign * Vector3::Unit(axis);
        const auto& limit = workspace.way[static_cast<size_t>(axis)];
        const double way = sign < 0.0 ? limit.backward : limit.forward;
        EXPECT_GT(way, 0.02) << name;
        EXPECT_GT(force_at(geometry, way * along, Vector3::Zero()), 0.0) << name << axis;
        EXPECT_EQ(force_at(geometry, (way + 2e-5) * along, Vector3::Zero()), 0.0) << name << axis;
        const auto& turned = workspace.angle[static_cast<size_t>(axis)];
        const double angle = sign < 0.0 ? turned.backward : turned.forward;
        EXPECT_GT(angle, 0.5) << name;
        EXPECT_GT(force_at(geometry, Vector3::Zero(), angle * along), 0.0) << name << axis;
        EXPECT_EQ(force_at(geometry, Vector3::Zero(), (angle + 4e-4) * along), 0.0) << name << axis;
      }
    }
  }
}

TEST(SpidarWorkspace, ItsMapsHoldWhatTheMotorsReach) {
  const TemporaryFolder folder;
  const SpidarGeometry& geometry = spidar_preset("x3l").geometry;
  draw_spidar_workspace(geometry, folder.path() / "x3l");
  const SamplesTable map = read_samples(folder.path() / "x3l" / "workspace-position.csv");
  EXPECT_EQ(map.names, (std::vector<std::string>{"plane", "x[m]", "y[m]", "z[m]", "force[N]", "torque[N m]"}));
  size_t rows = 0, held = 0;
  for (size_t row = 0; row < map.rows.size(); ++row) {
    if (map.rows[row].empty()) continue;
    if (++rows % 97 != 0) continue;
    const Vector3 p(map.at(row, "x[m]"), map.at(row, "y[m]"), map.at(row, "z[m]"));
    const double force = force_at(geometry, p, Vector3::Zero()), drawn = map.at(row, "force[N]");
    if (std::isnan(drawn)) {
      EXPECT_EQ(force, 0.0) << p.transpose();
    } else {
      EXPECT_NEAR(drawn, force, 0.02) << "places are rounded to micrometres: " << p.transpose();
      ++held;
    }
  }
  EXPECT_EQ(rows, 3U * 81U * 81U);
  EXPECT_GT(held, 20U);
  const SamplesTable turns = read_samples(folder.path() / "x3l" / "workspace-rotation.csv");
  EXPECT_THAT(turns.comments.front(), testing::HasSubstr("'x3l'"));
  for (const char* name : {"workspace-position", "workspace-rotation"}) {
    for (const char* ending : {".svg", ".png"}) {
      EXPECT_GT(std::filesystem::file_size(folder.path() / "x3l" / (name + std::string(ending))), 20000U) << name;
    }
  }
}

TEST(SpidarWorkspace, AGeometryWithoutForceClosureHasNone) {
  const SpidarGeometry& open = spidar_preset("x3f").geometry;
  const TemporaryFolder folder;
  EXPECT_THROW(spidar_workspace(open), std::invalid_argument);
  EXPECT_THROW(draw_spidar_workspace(open, folder.path() / "none"), std::invalid_argument);
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "none"));
}

}  // namespace
}  // namespace tegotae
