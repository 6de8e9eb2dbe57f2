// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/random_contact.hpp>

#include <tegotae/lab/closed_loop.hpp>
#include <tegotae/lab/motion.hpp>
#include <tegotae/math/rotation.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

namespace tegotae {
namespace {

/// Sines of random phase, of frequencies that share no period.
class Wander {
 public:
  Wander(std::mt19937& random, double amplitude, double slowest, double fastest) {
    for (std::size_t i = 0; i < kSines; ++i) {
      const double part = static_cast<double>(i) / (kSines - 1);
      sines_[i] = {amplitude / kSines, slowest * std::pow(fastest / slowest, part) * (1.0 + 0.1 * uniform(random)),
                   2.0 * std::numbers::pi * uniform(random)};
    }
  }
  double at(double time) const {
    double sum = 0.0;
    for (const Sine& sine : sines_) {
      sum += sine.amplitude * std::sin(2.0 * std::numbers::pi * sine.frequency * time + sine.phase);
    }
    return sum;
  }

 private:
  struct Sine {
    double amplitude, frequency, phase;
  };
  static constexpr std::size_t kSines = 4;
  // Not std::uniform_real_distribution, whose numbers differ between standard libraries.
  static double uniform(std::mt19937& random) { return static_cast<double>(random()) / 4294967296.0; }

  std::array<Sine, kSines> sines_{};
};

}  // namespace

Trajectory random_contact(const Tool& tool, double duration, std::uint32_t seed) {
  std::mt19937 random(seed);
  const Wander depth(random, 6e-3, 0.3, 4.0);  // m; Hz
  const Wander x(random, 0.04, 0.1, 1.0), y(random, 0.04, 0.1, 1.0);
  const Wander turn_x(random, 0.8, 0.05, 0.7), turn_y(random, 0.8, 0.05, 0.7), turn_z(random, 0.8, 0.05, 0.7);
  return sampled(0.0, duration, [&](double time) {
    const Quaternion q_WT = rotation_from_vector({turn_x.at(time), turn_y.at(time), turn_z.at(time)}) * tool.X_WT.q;
    const double height = -lowest_height(tool, q_WT, Vector3::UnitZ()) - depth.at(time);
    return Pose{{x.at(time), y.at(time), height}, q_WT};
  });
}

EnergyRow measure_energy(const StabilitySetup& setup, double duration, std::uint32_t seed, const Progress& progress) {
  const SceneGeometry scene = cube_over_floor();
  const SessionSettings& settings = setup.settings;
  SimulatedHandInterface interface(random_contact(scene.tool, duration, seed), setup.device, setup.hand);
  PassivityObserver observer({settings.stiffness, settings.damping, settings.metric_length},
                             scene.tool.mass.centre_of_mass);
  EnergyRow row;
  run_closed_loop(scene, settings, interface, duration, [&](const TickRecord& record) {
    observer.add(record);
    row.greatest_force = std::max(row.greatest_force, record.displayed.force.vector().norm());
    progress(record.time / duration);
    return true;
  });
  row.method = settings.method;
  row.metric_length = settings.metric_length;
  row.stiffness = settings.stiffness;
  row.duration = duration;
  row.contacts = observer.contacts();
  row.time_in_contact = static_cast<double>(observer.ticks_in_contact()) / settings.haptic_rate;
  row.given = observer.given();
  row.allowed = observer.allowed();
  row.excess = observer.excess();
  row.worst_contact = observer.worst_contact();
  return row;
}

}  // namespace tegotae
