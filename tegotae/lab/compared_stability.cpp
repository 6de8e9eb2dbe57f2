// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/compared_stability.hpp>

#include <tegotae/device/simulated_presets.hpp>

namespace tegotae {
namespace {

SettingsRequest common_request() {
  SettingsRequest request;
  request.metric_length = 0.0;
  request.physics_rate = 20.0;
  request.haptic_rate = 1000.0;
  return request;
}

}  // namespace

ComparedStability::ComparedStability(const std::vector<std::string>& methods) : slots_(methods.size()) {
  setup_.device = simulated_device(kDevice);
  setup_.hand = simulated_hand(kHand);
  setup_.settings = decide_settings(common_request(), cube_over_floor().tool);
  setup_.device.delay = 1.0 / setup_.settings.haptic_rate;
  for (size_t i = 0; i < methods.size(); ++i) {
    slots_[i].method = methods[i];
    slots_[i].limits.resize(touched_features().size());
    slots_[i].failures.resize(touched_features().size() + 1);
  }
}

// Throws where the method is not there.
StabilitySetup ComparedStability::setup_for(const std::string& method) const {
  SettingsRequest request = common_request();
  request.method = method;
  StabilitySetup setup = setup_;
  setup.settings = decide_settings(request, cube_over_floor().tool);
  return setup;
}

void ComparedStability::add_works(std::vector<Work>& works) {
  for (Slots& slots : slots_) {
    for (size_t i = 0; i < slots.limits.size(); ++i) {
      works.push_back({1.0,
                       [this, &slots, i](const Progress& progress) {
                         slots.limits[i] = measure_stability(setup_for(slots.method), touched_features()[i], progress);
                       },
                       [&slots, i](const std::string& why) { slots.failures[i] = why; }});
    }
    works.push_back({1.0,
                     [this, &slots](const Progress& progress) {
                       slots.energy = measure_energy(setup_for(slots.method), kEnergyDuration, kEnergySeed, progress);
                     },
                     [&slots](const std::string& why) { slots.failures.back() = why; }});
  }
}

std::vector<StabilityOfMethod> ComparedStability::rows() const {
  std::vector<StabilityOfMethod> rows;
  for (const Slots& slots : slots_) {
    StabilityOfMethod row;
    row.method = slots.method;
    for (const auto& limit : slots.limits) {
      if (limit) row.limits.push_back(*limit);
    }
    row.energy = slots.energy;
    for (const std::string& failure : slots.failures) {
      if (row.failure.empty()) row.failure = failure;
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace tegotae
