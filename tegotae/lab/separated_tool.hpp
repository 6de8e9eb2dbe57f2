// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/lab/separation_step.hpp>
#include <tegotae/math/wrench.hpp>
#include <tegotae/model/scene_geometry.hpp>

#include <span>
#include <vector>

namespace tegotae {

/// The tool where nothing forbids it to be, nearest to the hand: the pose of least
///     1/2 |X_WP - X_WH|_K^2 + 1/2 W sum over pairs of s_j^2,    K = k diag(1, 1, 1, l^2, l^2, l^2) about the centre of
///     mass,
/// where pair j of a tool piece and a body piece is at least the skin minus s_j apart. Followed as a local minimum
/// while the hand moves by small steps. Sequential quadratic programs in a trust region, each with the separating
/// planes among its unknowns. All in the world's frame; allocates.
class SeparatedTool {
 public:
  struct Parameters {
    double stiffness = 1000.0;   ///< k, N/m
    double metric_length = 1.0;  ///< l, m
    double skin = 2e-6;          ///< m
  };

  /// Keeps a reference to `scene`. Throws std::invalid_argument where a tool piece is a half-space.
  SeparatedTool(const SceneGeometry& scene, const Parameters& parameters);

  /// Puts the hand at `X_WH` and the tool with it, then pushes it out of what it is shallowly in. False where it is
  /// deeper inside something than `kShallow`: nothing can be said of the side on which it belongs.
  bool start(const Pose& X_WH);

  /// The hand moves to `X_WH`, by a small step. False where the solution did not converge.
  bool follow(const Pose& X_WH);

  const Pose& pose() const noexcept { return X_WP_; }
  /// On the interface, about the tool's centre of mass.
  Wrench wrench() const;
  /// Something pushes the tool.
  bool touches() const noexcept;
  /// The greatest distance that the displacement [m; rad] moves a point of the tool, m, bounded from above.
  double way(const Vector6& displacement) const noexcept;
  /// Pairs near enough to matter, at the present pose, with the planes between them.
  const std::vector<PlanePair>& pairs() const noexcept { return near_; }
  const Vector3& centre() const noexcept { return scene_.tool.mass.centre_of_mass; }

  /// Programs solved so far, and those of them whose step was refused.
  int programs() const noexcept { return programs_; }
  int refused() const noexcept { return refused_; }

  static constexpr double kShallow = 1e-3;  ///< m

 private:
  struct Tracked {
    size_t above = 0, below = 0;
    bool has_plane = false, is_near = false;
    Vector3 n = Vector3::UnitZ();
    double load = 0.0, slack = 0.0;
    Vector3 load_moment = Vector3::Zero();
  };

  void move_to(const Pose& X_WP);
  void update_near();
  bool is_close(Tracked& pair);
  bool jump_to_hand(const Pose& X_WH);
  void place_trial(const Pose& X_WP);
  double trial_gap(const PlanePair& pair) const;
  double value_at(const Pose& X_WP, const Pose& X_WH, std::span<const PlanePair> pairs);
  bool planes_hold(std::span<const PlanePair> pairs) const;
  SeparationStep next_step(const Pose& X_WH, double trust, std::vector<PlanePair>& pairs);
  void remember(std::span<const PlanePair> pairs);

  const SceneGeometry& scene_;
  Parameters parameters_;
  double radius_ = 0.0;  ///< m, of the tool about its centre of mass
  std::vector<ConvexCore> tool_local_, tool_, trial_, bodies_;
  std::vector<Tracked> tracked_;
  std::vector<PlanePair> near_;
  std::vector<size_t> near_index_;
  Pose X_WP_, X_WH_;
  int programs_ = 0, refused_ = 0;
};

}  // namespace tegotae
