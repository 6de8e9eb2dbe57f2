// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/world/mujoco_world.hpp>

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace tegotae::test {

/// A folder of scene files of one test, removed with it.
class SceneFiles : public ::testing::Test {
 protected:
  SceneFiles() {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::path(::testing::TempDir()) /
              (std::string("tegotae_world_") + test->test_suite_name() + "_" + test->name());
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  ~SceneFiles() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
    return folder_ / name;
  }

  /// `body` between <mujoco> and </mujoco>, loaded with the body "tool" in the hand.
  std::unique_ptr<MujocoWorld> load(const std::string& body, const MujocoWorldOptions& options = {}) const {
    return load_mujoco_world(write("scene.xml", "<mujoco>\n" + body + "\n</mujoco>\n"), "tool", options);
  }

  /// The message with which loading this is refused; empty if it is not.
  std::string refusal(const std::string& body, const std::string& tool = "tool") const {
    return refusal_of(write("scene.xml", "<mujoco>\n" + body + "\n</mujoco>\n"), tool);
  }
  static std::string refusal_of(const std::filesystem::path& file, const std::string& tool = "tool") {
    try {
      load_mujoco_world(file, tool);
    } catch (const SceneError& error) {
      return error.what();
    }
    return {};
  }

  const std::filesystem::path& folder() const { return folder_; }

 private:
  std::filesystem::path folder_;
};

inline const std::string kTool = R"(<body name="tool" mocap="true" pos="0 0 5"><geom size="0.05"/></body>)";
inline const std::string kFloor = R"(<geom name="floor" type="plane" size="5 5 0.1"/>)";

inline std::vector<BodyState> states_of(const MujocoWorld& world) {
  std::vector<BodyState> states(static_cast<size_t>(world.geometry().moving_count));
  world.read_bodies(states);
  return states;
}

inline std::vector<BodyImpulse> no_impulses(const MujocoWorld& world) {
  return std::vector<BodyImpulse>(static_cast<size_t>(world.geometry().moving_count));
}

}  // namespace tegotae::test
