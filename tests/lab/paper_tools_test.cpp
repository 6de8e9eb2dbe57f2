// SPDX-License-Identifier: Apache-2.0
// What the proxy method shows in the experiments of the paper, with the tool's own gyration length.
#include <tegotae/lab/paper_tools.hpp>
#include <tests/lab/performance.hpp>

#include <gtest/gtest.h>

#include <string>

namespace tegotae {
namespace {

struct PaperCase {
  const char* experiment;
  size_t variant;     // with the gyration length
  double peak_force;  // N
};

class PaperExperiments : public testing::TestWithParam<PaperCase> {};

TEST_P(PaperExperiments, WithTheProxyKeepToTheReference) {
  const Performance done = perform(find_experiment(GetParam().experiment), GetParam().variant);
  EXPECT_NEAR(done.settings.metric_length, done.scene.tool.mass.gyration_length(), 1e-12);
  expect_kept_to_reference(done, 0.0);
  EXPECT_NEAR(done.metrics.force.peak, GetParam().peak_force, 0.03 * GetParam().peak_force);
  EXPECT_GT(done.metrics.torque.peak, 0.05);
}

// The flat tool, 115 vertices on the floor: 9000 N/m by 1 mm, and no torque.
TEST(Tool230FlatPressed, HasTheForceOfItsDepthAndNoTorque) {
  const Performance done = perform(find_experiment("tool-230-flat"), 1);
  const TickRecord& record = at_time(done, 2.0);
  EXPECT_NEAR(record.wrench.force.z, 9000.0 * 1.002e-3, 1e-3);
  EXPECT_LT(Vector3(record.wrench.torque).norm(), 1e-9);
}

INSTANTIATE_TEST_SUITE_P(All, PaperExperiments,
                         testing::Values(PaperCase{"paper-cube", 1, 3.30}, PaperCase{"tool-18", 1, 9.02},
                                         PaperCase{"tool-230-round", 1, 9.02}, PaperCase{"tool-230-flat", 1, 9.02},
                                         PaperCase{"tilt-sweep", 0, 4.23}),
                         [](const auto& tested) {
                           std::string name = tested.param.experiment;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

}  // namespace
}  // namespace tegotae
