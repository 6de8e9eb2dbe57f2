// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/lab/random_contact.hpp>
#include <tegotae/lab/stability.hpp>

#include <span>
#include <string>

namespace tegotae {

/// What a measurement of stability came to. Every setup is the same but for method and metric length.
struct StabilityReport {
  StabilitySetup setup;
  std::string hand;  ///< its name
  std::vector<StabilityRow> limits;
  std::vector<EnergyRow> energies;
  bool interrupted = false;  ///< rows that were asked for are missing
};

/// As JSON: the simulated device and hand, the criterion, a row a method and contact; keys carry their units. What is
/// infinite is null.
std::string stability_json(const StabilityReport& report);

}  // namespace tegotae
