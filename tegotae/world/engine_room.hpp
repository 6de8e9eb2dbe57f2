// SPDX-License-Identifier: Apache-2.0
#pragma once

struct mjModel_;
struct mjData_;

namespace tegotae {

/// Room that MuJoCo sets aside for contacts and their solution. 2.2.2 bounds each by a number; from 2.3 on all share
/// one arena, and the three numbers are of no use.
struct EngineRoom {
  int contacts = 0;     ///< 0: not bounded by number
  int rows = 0;         ///< of constraints
  int stack = 0;        ///< numbers that the solvers may hold
  long long arena = 0;  ///< bytes

  bool operator==(const EngineRoom&) const = default;
};

EngineRoom room_of(const mjModel_& model);

/// Takes effect on states made from then on.
void set_room(mjModel_& model, const EngineRoom& room);

/// What a scene starts with: its own wishes, or world_limits' where those are more.
EngineRoom first_room(const mjModel_& model, int max_contacts);

/// Twice the room of what was found full in the step that led to `data`; all that is bounded stays below its limit.
/// `stack_full`: MuJoCo ended the step for want of stack.
EngineRoom enlarged_room(const mjModel_& model, const mjData_& data, bool stack_full, int max_contacts);

}  // namespace tegotae
