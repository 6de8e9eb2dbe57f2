// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

namespace tegotae {

/// What went wrong in the physics since it was loaded. All zero in a healthy world.
struct WorldDiagnostics {
  std::uint64_t substeps = 0;                 ///< integrated
  std::uint64_t dropped_contacts = 0;         ///< times that a pair of geoms found no room in the contact list
  std::uint64_t dropped_constraint_rows = 0;  ///< times that a constraint found no room
  std::uint64_t singular_inertias = 0;        ///< near singular inertia matrices
  std::uint64_t diverged = 0;                 ///< substeps with NaN, infinite or huge states: the bodies were stopped
  std::uint64_t engine_errors = 0;            ///< substeps that MuJoCo gave up: the bodies were stopped
  std::uint64_t ignored_impulses = 0;         ///< impulses that were not finite
  std::uint64_t enlargements = 0;             ///< times that more room was made for contacts
  int contact_capacity = 0;                   ///< contacts that there is room for now; 0: not bounded by number
  std::string last_message;                   ///< of MuJoCo's

  bool is_healthy() const noexcept {
    return dropped_contacts + dropped_constraint_rows + singular_inertias + diverged + engine_errors +
               ignored_impulses ==
           0;
  }
};

}  // namespace tegotae
