// SPDX-License-Identifier: Apache-2.0
#include <tegotae/world/simulation.hpp>

#include <tegotae/world/engine_room.hpp>

#include <fmt/format.h>
#include <mujoco/mujoco.h>

#include <algorithm>
#include <chrono>
#include <stdexcept>

namespace tegotae {
namespace {

// Calls visit(values, count) for all that a step starts from.
template <class Visit>
void for_each_input(const mjModel& m, mjData& d, Visit visit) {
  visit(&d.time, 1);
  visit(d.qpos, static_cast<int>(m.nq));
  visit(d.qvel, static_cast<int>(m.nv));
  visit(d.act, static_cast<int>(m.na));
  visit(d.qacc_warmstart, static_cast<int>(m.nv));
  visit(d.ctrl, static_cast<int>(m.nu));
  visit(d.qfrc_applied, static_cast<int>(m.nv));
  visit(d.xfrc_applied, 6 * static_cast<int>(m.nbody));
  visit(d.mocap_pos, 3 * static_cast<int>(m.nmocap));
  visit(d.mocap_quat, 4 * static_cast<int>(m.nmocap));
  visit(d.userdata, static_cast<int>(m.nuserdata));
}

int count_of(const mjData& d, int warning) { return d.warning[warning].number; }

int divergences(const mjData& d) {
  return count_of(d, mjWARN_BADQPOS) + count_of(d, mjWARN_BADQVEL) + count_of(d, mjWARN_BADQACC);
}

void clear_warnings(mjData& d) {
  for (mjWarningStat& warning : d.warning) warning = {};
}

}  // namespace

void Simulation::DataDeleter::operator()(mjData_* data) const noexcept { mj_deleteData(data); }

Simulation::Simulation(ModelPointer model, int max_contacts) : model_(std::move(model)), max_contacts_(max_contacts) {
  set_room(*model_, first_room(*model_, max_contacts_));
  diagnostics_.contact_capacity = room_of(*model_).contacts;
  EngineMessages messages;
  data_ = make_data(messages);
  if (data_ == nullptr) {
    throw std::runtime_error(fmt::format("MuJoCo {} cannot make the state of the scene: {}", mj_versionString(),
                                         messages.error.empty() ? "out of memory" : messages.error));
  }
  update_poses();
}

Simulation::DataPointer Simulation::make_data(EngineMessages& messages) const {
  mjData* made = nullptr;
  const mjModel* m = model_.get();
  const bool finished = run_guarded(messages, [&made, m] { made = mj_makeData(m); });
  return DataPointer(finished ? made : nullptr);
}

void Simulation::save_inputs() {
  inputs_.clear();
  for_each_input(*model_, *data_,
                 [this](const double* values, int count) { inputs_.insert(inputs_.end(), values, values + count); });
}

void Simulation::restore_inputs() {
  auto next = inputs_.cbegin();
  for_each_input(*model_, *data_, [&next](double* values, int count) {
    std::copy(next, next + count, values);
    next += count;
  });
}

bool Simulation::try_step(EngineMessages& messages) {
  const mjModel* m = model_.get();
  mjData* d = data_.get();
  clear_warnings(*d);
  return run_guarded(messages, [m, d] { mj_step(m, d); });
}

// Makes the state anew if the step lacked room and there is more to be had; false if there is no use in doing it again.
// A step that MuJoCo gave up needs a new state in any case.
bool Simulation::make_room(bool finished, const EngineMessages& messages) {
  const bool stack_full = messages.error.find("tack overflow") != std::string::npos;
  const bool lists_full = count_of(*data_, mjWARN_CONTACTFULL) > 0 || count_of(*data_, mjWARN_CNSTRFULL) > 0;
  const bool lacks_room = (stack_full || lists_full) && !no_more_room_;
  const EngineRoom before = room_of(*model_);
  const EngineRoom wanted = lacks_room ? enlarged_room(*model_, *data_, stack_full, max_contacts_) : before;
  const bool larger = !(wanted == before);
  if (!larger && finished) return false;
  set_room(*model_, wanted);
  EngineMessages making;
  DataPointer made = make_data(making);
  if (made == nullptr) {
    set_room(*model_, before);
    no_more_room_ = true;
    return false;
  }
  data_ = std::move(made);
  diagnostics_.enlargements += larger ? 1 : 0;
  diagnostics_.contact_capacity = wanted.contacts;
  return larger;
}

void Simulation::step() {
  EngineMessages messages;
  save_inputs();
  bool finished = try_step(messages);
  while (make_room(finished, messages)) {
    restore_inputs();
    messages = {};
    finished = try_step(messages);
  }
  finish_step(finished, messages);
}

void Simulation::finish_step(bool finished, const EngineMessages& messages) {
  ++diagnostics_.substeps;
  diagnostics_.dropped_contacts += static_cast<std::uint64_t>(count_of(*data_, mjWARN_CONTACTFULL));
  diagnostics_.dropped_constraint_rows += static_cast<std::uint64_t>(count_of(*data_, mjWARN_CNSTRFULL));
  diagnostics_.singular_inertias += static_cast<std::uint64_t>(count_of(*data_, mjWARN_INERTIA));
  const bool diverged = divergences(*data_) > 0;
  diagnostics_.diverged += diverged ? 1 : 0;
  diagnostics_.engine_errors += finished ? 0 : 1;
  if (!messages.warnings.empty()) diagnostics_.last_message = messages.warnings.back();
  if (!messages.error.empty()) diagnostics_.last_message = messages.error;
  if (diverged || !finished) stop_bodies();
}

// The state that the step started from, at rest, a step later. The reset clears what an error left half done.
void Simulation::stop_bodies() {
  mj_resetData(model_.get(), data_.get());
  restore_inputs();
  data_->time += model_->opt.timestep;
  std::fill_n(data_->qvel, model_->nv, 0.0);
  std::fill_n(data_->qacc_warmstart, model_->nv, 0.0);
}

void Simulation::update_poses() {
  mj_kinematics(model_.get(), data_.get());
  mj_comPos(model_.get(), data_.get());
  mj_comVel(model_.get(), data_.get());
}

double Simulation::measure_step_time(double timestep, int count) const {
  const std::unique_ptr<mjModel, ModelDeleter> model(mj_copyModel(nullptr, model_.get()));
  model->opt.timestep = timestep;
  const DataPointer copy(mj_copyData(nullptr, model.get(), data_.get()));
  const mjModel* m = model.get();
  mjData* d = copy.get();
  std::vector<double> times;
  EngineMessages messages;
  for (int i = 0; i < count; ++i) {
    const auto start = std::chrono::steady_clock::now();
    if (!run_guarded(messages, [m, d] { mj_step(m, d); })) break;
    times.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  if (times.empty()) return 0.0;
  std::nth_element(times.begin(), times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2), times.end());
  return times[times.size() / 2];
}

}  // namespace tegotae
