// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/lab/comparison.hpp>
#include <tegotae/lab/works.hpp>

#include <optional>
#include <string>
#include <vector>

namespace tegotae {

/// The stability of methods while it is being measured, a work a method and feature, and one a method for the energy
/// in random contact. The defaults of `tegotae stability`: the laboratory device, the moderate hand, one sample of
/// delay; the cube's gyration length for every method.
class ComparedStability {
 public:
  static constexpr const char* kDevice = "laboratory";
  static constexpr const char* kHand = "moderate";

  explicit ComparedStability(const std::vector<std::string>& methods);

  void add_works(std::vector<Work>& works);

  /// Of all methods, but for the method.
  const StabilitySetup& setup() const noexcept { return setup_; }

  /// Once no work is under way: what was measured, a row a method.
  std::vector<StabilityOfMethod> rows() const;

 private:
  struct Slots {
    std::string method;
    std::vector<std::optional<StabilityRow>> limits;  // of touched_features()
    std::optional<EnergyRow> energy;
    std::vector<std::string> failures;  // of the features, then of the energy; empty: none
  };
  StabilitySetup setup_for(const std::string& method) const;

  StabilitySetup setup_;
  std::vector<Slots> slots_;
};

}  // namespace tegotae
