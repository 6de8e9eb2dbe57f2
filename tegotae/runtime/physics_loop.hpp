// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/model/near_object_search.hpp>
#include <tegotae/model/representation_builder.hpp>
#include <tegotae/runtime/impulse_sums.hpp>
#include <tegotae/runtime/world.hpp>

#include <span>
#include <vector>

namespace tegotae {

/// The slow rate: moves the world, finds the objects near the tool and makes the intermediate representation. One
/// `step` a physics period, from one thread. Keeps a reference to the world.
class PhysicsLoop {
 public:
  struct Settings {
    double period = 0.05;   ///< s
    double margin = 0.002;  ///< m beyond what the speeds ask for (see Reach)
  };

  /// `needs` is what the rendering method asks for (`needs_of`); what it does not ask for is not worked out.
  /// Throws std::invalid_argument if a setting is out of range, the world moves more bodies than kMaxMovingBodies, or
  /// its moving bodies do not have the indices 0 to moving_count - 1, each once.
  PhysicsLoop(World& world, const Settings& settings, const ModelNeeds& needs);

  /// The model of the world as it is at `time` (s), the tool as in `tool`, into `model`. Does not move the world.
  void build(double time, const ToolState& tool, IntermediateRepresentation& model);

  /// One period: `build` at `time`, then gives the bodies what the haptic loop displayed to them since the last step,
  /// and integrates. `haptics` is the newest message of the haptic loop.
  void step(double time, const ImpulseSums& haptics, IntermediateRepresentation& model);

  /// Other settings and needs from the next step on. Throws as the constructor does, and then nothing changes.
  void change(const Settings& settings, const ModelNeeds& needs);

  /// The moving bodies as the last `build` or `step` read them.
  std::span<const BodyState> bodies() const noexcept { return bodies_; }

  const Settings& settings() const noexcept { return settings_; }
  int body_count() const noexcept { return static_cast<int>(bodies_.size()); }  ///< moving bodies

 private:
  Reach reach(const ToolState& tool) const;
  void refer_impulses_to_bodies();
  double stretch(const ToolState& tool) const;

  World& world_;
  Settings settings_;
  ModelNeeds needs_;
  double tool_radius_ = 0.0;  ///< m: greatest distance of a tool point from the tool frame's origin
  NearObjectSearch search_;
  RepresentationBuilder builder_;
  ImpulseDifferences differences_;
  std::vector<BodyState> bodies_;
  std::vector<BodyImpulse> impulses_;
  std::uint64_t sequence_ = 0;
};

}  // namespace tegotae
