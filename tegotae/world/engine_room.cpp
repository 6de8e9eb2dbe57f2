// SPDX-License-Identifier: Apache-2.0
#include <tegotae/world/engine_room.hpp>

#include <tegotae/world/limits.hpp>

#include <mujoco/mujoco.h>

#include <algorithm>
#include <limits>

namespace tegotae {

#if mjVERSION_HEADER >= 230

EngineRoom room_of(const mjModel_& model) { return {0, 0, 0, static_cast<long long>(model.narena)}; }

void set_room(mjModel_& model, const EngineRoom& room) {
  model.narena = static_cast<decltype(model.narena)>(room.arena);
}

EngineRoom first_room(const mjModel_& model, int /*max_contacts*/) { return room_of(model); }

EngineRoom enlarged_room(const mjModel_& model, const mjData_& /*data*/, bool /*stack_full*/, int /*max_contacts*/) {
  EngineRoom room = room_of(model);
  room.arena = std::max(room.arena, std::min(2 * room.arena, world_limits::kMaxArena));
  return room;
}

#else

namespace {

constexpr int kMostNumbers = std::numeric_limits<int>::max() / 4;

// The solvers hold a few matrices of rows by degrees of freedom and of degrees of freedom by themselves. Only what is
// used becomes real memory.
int stack_for(const mjModel& model, int rows) {
  const double r = rows, v = model.nv;
  return static_cast<int>(std::min(4.0 * (r * v + v * v) + 100.0 * (r + v), 1.0 * kMostNumbers));
}

int doubled(int value, int most) { return std::max(value, std::min(2 * value, most)); }

}  // namespace

EngineRoom room_of(const mjModel_& model) { return {model.nconmax, model.njmax, model.nstack, 0}; }

void set_room(mjModel_& model, const EngineRoom& room) {
  model.nconmax = room.contacts;
  model.njmax = room.rows;
  model.nstack = room.stack;
}

EngineRoom first_room(const mjModel_& model, int max_contacts) {
  EngineRoom room = room_of(model);
  room.contacts = std::max(room.contacts, std::min(max_contacts, world_limits::kFirstContacts));
  room.rows = std::max(room.rows, world_limits::kFirstRows);
  room.stack = std::max(room.stack, stack_for(model, room.rows));
  return room;
}

EngineRoom enlarged_room(const mjModel_& model, const mjData_& data, bool stack_full, int max_contacts) {
  EngineRoom room = room_of(model);
  if (data.warning[mjWARN_CONTACTFULL].number > 0) room.contacts = doubled(room.contacts, max_contacts);
  if (data.warning[mjWARN_CNSTRFULL].number > 0) room.rows = doubled(room.rows, world_limits::kMaxRows);
  room.stack = std::max(room.stack, stack_for(model, room.rows));
  if (stack_full) room.stack = doubled(room.stack, kMostNumbers);
  return room;
}

#endif

}  // namespace tegotae
