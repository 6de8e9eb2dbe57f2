// SPDX-License-Identifier: Apache-2.0
#include <tegotae/math/rotation.hpp>
#include <tegotae/runtime/haptic_tick.hpp>
#include <tegotae/runtime/latest_value.hpp>
#include <tegotae/runtime/mailbox.hpp>
#include <tegotae/runtime/physics_loop.hpp>
#include <tegotae/runtime/spsc_ring.hpp>
#include <tegotae/runtime/statistics.hpp>

#include <tests/allocation_counter.hpp>
#include <tests/free_body_world.hpp>
#include <tests/lock_counter.hpp>

#include <gtest/gtest.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <memory>
#include <mutex>

// What the haptic thread may not do in a tick: allocate, lock, enter the kernel. Everything that its thread does
// between reading and commanding the interface, with models that come and go.
namespace tegotae {
namespace {

class BusyTick {
 public:
  explicit BusyTick(const char* method)
      : world_(scene()), physics_(world_, {0.05, 0.01}, needs_of(make_method(method, {}, world_.geometry()))) {
    const Tool& tool = world_.geometry().tool;
    haptics_ =
        std::make_unique<HapticTick>(make_method(method, {}, world_.geometry()), tool, limits(), 1e-3, workspace());
    updates_->give({std::make_unique<RenderingMethod>(make_method(method, {}, world_.geometry())), limits()});
    for (int i = 0; i < 3; ++i) physics_.build(0.0, {pose(0.1 * i), {}}, models_[i]);
  }

  void run(int ticks) noexcept {
    for (int i = 0; i < ticks; ++i) {
      InterfaceState state;
      state.time = 1e-3 * i;
      state.X_WT = pose(state.time);
      state.buttons = i % 200 > 190 ? 1U : 2U;
      if (i % 20 == 0) {
        slot_->begin_write() = models_[i / 20 % 3];
        slot_->publish();
      }
      if (auto* const update = updates_->take()) {
        haptics_->adopt(update->content);
        updates_->give_back(update);
      }
      TickRecord record;
      (*haptics_)(state, slot_->update() ? &slot_->get() : nullptr, {}, record);
      haptics_->view(views_->begin_write());
      views_->publish();
      haptics_->fill(messages_->begin_write(), physics_.body_count());
      messages_->publish();
      statistics_.add(1e-6, record.model_age);
      ring_.push(record);
      strongest_ = std::max(strongest_, Vector3(record.wrench.force).norm());
      displayed_ = std::max(displayed_, Vector3(record.displayed.force).norm());
    }
  }

  double strongest() const { return strongest_; }
  double displayed() const { return displayed_; }
  const SafetyState& safety() const { return haptics_->safety(); }

 private:
  // Every stage has something to do: clutch, dead-man button, scales, energy bound.
  static SafetyLimits limits() {
    SafetyLimits limits = with_short_ramp({});
    limits.dead_man_button = 1;
    return limits;
  }
  static WorkspaceSettings workspace() {
    WorkspaceSettings workspace;
    workspace.rotation_scale = 1.5;
    workspace.force_scale = 0.5;
    workspace.clutch_button = 0;
    return workspace;
  }

  static SceneGeometry scene() {
    SceneGeometry scene = test::cube_over_floor();
    Body block = scene.bodies[0];
    block.pieces = {make_box(Vector3(0.05, 0.05, 0.05)), make_sphere(0.04)};
    block.X_WB.p = Vector3(0.14, 0.1, 0.0);
    block.moving_index = 0;
    scene.bodies.push_back(block);
    return scene;
  }

  static Pose pose(double t) {
    return {{0.001 * std::sin(30.0 * t), 0.0995, 0.0}, rotation_from_vector({0.02 * std::sin(20.0 * t), 0.0, 0.0})};
  }

  test::FreeBodyWorld world_;
  PhysicsLoop physics_;
  std::unique_ptr<HapticTick> haptics_;
  std::array<IntermediateRepresentation, 3> models_;
  std::unique_ptr<LatestValue<IntermediateRepresentation>> slot_ =
      std::make_unique<LatestValue<IntermediateRepresentation>>();
  std::unique_ptr<Mailbox<HapticUpdate>> updates_ = std::make_unique<Mailbox<HapticUpdate>>();
  std::unique_ptr<LatestValue<ContactView>> views_ = std::make_unique<LatestValue<ContactView>>();
  std::unique_ptr<LatestValue<ImpulseSums>> messages_ = std::make_unique<LatestValue<ImpulseSums>>();
  SpscRing<TickRecord> ring_{64};
  TickStatistics statistics_;
  double strongest_ = 0.0, displayed_ = 0.0;
};

class HapticTickContract : public ::testing::TestWithParam<std::string_view> {};

TEST_P(HapticTickContract, NeitherAllocatesNorLocks) {
  const auto tick = std::make_unique<BusyTick>(GetParam().data());
  const test::AllocationCounter allocations;
  const test::LockCounter locks;
  tick->run(1000);
  EXPECT_EQ(allocations.count(), 0u);
  EXPECT_EQ(locks.count(), 0u);
  EXPECT_GT(tick->strongest(), 0.1) << "it was in contact";
  EXPECT_GT(tick->displayed(), 0.05);
  EXPECT_GT(tick->safety().count(SafetyEvent::kClutched), 0u);
  EXPECT_GT(tick->safety().count(SafetyEvent::kDeadMan), 0u);
  EXPECT_GT(tick->safety().count(SafetyEvent::kEnergyBounded), 0u);
}

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)

TEST(LockCounter, CountsTheLocksOfThisThread) {
  std::mutex mutex;
  const test::LockCounter locks;
  { const std::lock_guard<std::mutex> lock(mutex); }
  EXPECT_EQ(locks.count(), 1u);
}

// A child that may only read, write and exit: any other system call kills it.
template <class Work>
int status_under_seccomp(Work work) {
  const pid_t child = fork();
  if (child == 0) {
    if (prctl(PR_SET_SECCOMP, SECCOMP_MODE_STRICT) != 0) _exit(77);
    work();
    syscall(SYS_exit, 0);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return status;
}

TEST_P(HapticTickContract, EntersNoKernel) {
  const auto tick = std::make_unique<BusyTick>(GetParam().data());
  const int status = status_under_seccomp([&tick] { tick->run(1000); });
  EXPECT_TRUE(WIFEXITED(status)) << "killed by signal " << WTERMSIG(status);
  EXPECT_EQ(WEXITSTATUS(status), 0);
}

TEST(SystemCalls, AreSeenByTheSameTest) {
  const int status = status_under_seccomp([] { getppid(); });
  EXPECT_TRUE(WIFSIGNALED(status));
}

#endif

std::string name_of_case(const ::testing::TestParamInfo<std::string_view>& info) {
  std::string name(info.param);
  for (char& c : name) c = std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
  return name;
}

std::vector<std::string_view> all_methods() {
  std::vector<std::string_view> names;
  for (const MethodName& method : method_names()) names.push_back(method.name);
  return names;
}

INSTANTIATE_TEST_SUITE_P(Methods, HapticTickContract, ::testing::ValuesIn(all_methods()), name_of_case);

}  // namespace
}  // namespace tegotae
