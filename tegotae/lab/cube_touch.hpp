// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/device/simulated_grip.hpp>
#include <tegotae/device/trajectory.hpp>
#include <tegotae/model/scene_geometry.hpp>

#include <span>
#include <string_view>

namespace tegotae {

/// Which part of the cube meets the floor; its centre is above that part's middle.
struct TouchedFeature {
  std::string_view name;  ///< "vertex", "edge", "face"
  Quaternion q_WT;        ///< of the cube when it touches
};
std::span<const TouchedFeature> touched_features();

/// Throws InputError, with the names, where there is none called `name`.
const TouchedFeature& touched_feature(std::string_view name);

/// The paper's cube, 0.2 m of edge, as the tool over a floor whose top is z = 0.
SceneGeometry cube_over_floor();

/// The touch that stability is judged by. From a small gap the hand means to move on down at 1 mm/s until its spring,
/// less what the interface's Coulomb friction takes, presses with half a millimetre of stretch, turning a little about
/// a horizontal axis and back again, at 1 mm/s at the cube's corners, so that rocking is excited too; then it holds
/// still, unturned, so that a face lies flat.
class CubeTouch {
 public:
  static constexpr double kSpeed = 1e-3;    ///< m/s
  static constexpr double kGap = 20e-6;     ///< m, at first
  static constexpr double kPress = 0.5e-3;  ///< m of the hand's spring that presses on the floor
  static constexpr double kTurning = 7e-3;  ///< rad/s: about 1 mm/s at a corner

  /// Throws InputError where the hand has no spring to press with.
  CubeTouch(const GripMechanics& mechanics, const HandImpedance& hand);

  double depth() const noexcept { return depth_; }                  ///< m under the floor that the hand means to go
  double end() const noexcept { return (kGap + depth_) / kSpeed; }  ///< s, from when on the hand holds still

  /// The hand's intended motion of `tool`, which begins turned by `feature`.
  Trajectory motion(const Tool& tool, const TouchedFeature& feature) const;

 private:
  double depth_;
};

}  // namespace tegotae
