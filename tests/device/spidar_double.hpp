// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/device/spidar_driver.hpp>

#include <tests/doubles/double_state_file.hpp>

#include <algorithm>
#include <string>

namespace tegotae::test {

/// The library around a simulated SPIDAR, loaded by its path as a board's owner gives it; `more` options begin with a
/// comma. Without `hold` the grip need not be held before its counts are set to zero.
inline std::string on_spidar_double(const std::string& more = "", const std::string& folder = "spidar") {
  const bool holds = more.find("hold=") != std::string::npos;
  return std::string(holds ? "x3r" : "x3r,hold=0") + ",transport=" + TEGOTAE_DOUBLES + '/' + folder + "/libmyboard.so" +
         more;
}

/// An X3R in a hand, its grip in the middle of the frame, whose motors alone set limits.
class SpidarDoubleFile : public DoubleStateFile {
 public:
  SpidarDoubleFile() : DoubleStateFile("x3r") {
    DoubleState& state = **this;
    state.max_force = 100.0;
    state.max_torque = 10.0;
    state.mass = 0.1;
    state.inertia = 1e-4;
    place({});
  }

  double tension(std::size_t string) const { return (**this).tensions[string].load(); }
  double greatest_tension() const {
    double greatest = 0.0;
    for (const auto& each : (**this).tensions) greatest = std::max(greatest, each.load());
    return greatest;
  }
};

}  // namespace tegotae::test
