// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/world/engine_guard.hpp>
#include <tegotae/world/loaded_model.hpp>
#include <tegotae/world/world_diagnostics.hpp>

#include <memory>
#include <vector>

struct mjData_;

namespace tegotae {

/// MuJoCo's model and state, stepped so that nothing is lost in silence: a step that ran out of room for contacts is
/// done again with more, until `max_contacts`; a step that diverged, or that MuJoCo gave up, is undone and all bodies
/// are stopped where they were. Both are counted.
class Simulation {
 public:
  /// Takes a compiled model. Throws std::runtime_error if MuJoCo cannot make its state.
  Simulation(ModelPointer model, int max_contacts);

  mjModel_& model() noexcept { return *model_; }
  const mjModel_& model() const noexcept { return *model_; }
  mjData_& data() noexcept { return *data_; }
  const mjData_& data() const noexcept { return *data_; }

  /// One step of the model's time step.
  void step();

  /// Poses and velocities of the state as it is now; a step leaves them as they were at its start.
  void update_poses();

  /// Median wall time (s) of `count` steps of `timestep` (s) from the state as it is now, which is left alone.
  double measure_step_time(double timestep, int count) const;

  const WorldDiagnostics& diagnostics() const noexcept { return diagnostics_; }
  void count_ignored_impulse() noexcept { ++diagnostics_.ignored_impulses; }

 private:
  struct DataDeleter {
    void operator()(mjData_* data) const noexcept;
  };
  using DataPointer = std::unique_ptr<mjData_, DataDeleter>;

  DataPointer make_data(EngineMessages& messages) const;
  void save_inputs();
  void restore_inputs();
  bool try_step(EngineMessages& messages);
  bool make_room(bool finished, const EngineMessages& messages);
  void finish_step(bool finished, const EngineMessages& messages);
  void stop_bodies();

  ModelPointer model_;
  DataPointer data_;
  int max_contacts_ = 0;
  bool no_more_room_ = false;
  std::vector<double> inputs_;  // all that a step starts from
  WorldDiagnostics diagnostics_;
};

}  // namespace tegotae
