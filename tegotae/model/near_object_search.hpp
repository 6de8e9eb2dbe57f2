// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/contact/closest_points.hpp>
#include <tegotae/contact/sweep_and_prune.hpp>
#include <tegotae/model/scene_geometry.hpp>

#include <map>
#include <span>
#include <utility>
#include <vector>

namespace tegotae {

/// How near is near: what may touch before the next model has come. A pair is near below
/// margin + horizon * (speed of the tool + speed of the body).
struct Reach {
  double margin = 0.0;      ///< m
  double horizon = 0.0;     ///< s that a model must serve: it appears one physics period late, and serves for one
  double tool_speed = 0.0;  ///< greatest of any point of the tool, m/s

  double at(double body_speed) const noexcept { return margin + horizon * (tool_speed + body_speed); }
};

/// A piece of the tool and a piece of a body within reach of each other.
struct NearPair {
  int tool_piece = 0;
  int body = 0;
  int body_piece = 0;
  double distance = 0.0;           ///< m; negative: penetration depth
  Vector3 p_WA = Vector3::Zero();  ///< closest point on the tool, or its deepest, m
  Vector3 p_WB = Vector3::Zero();  ///< closest point on the object, or where the deepest comes out, m
  Vector3 n_W = Vector3::UnitZ();  ///< unit, out of the object
  double reach = 0.0;              ///< m: the pair is near below this distance
};

/// Finds the near objects (paper, section 4.2.1): sweep and prune of the enlarged tool box against the boxes of all
/// pieces, then closest points of each candidate. Where pieces penetrate, the plane is that of the least parting
/// translation, followed from the previous step's normal, so that it stays coherent from step to step.
/// For the physics rate: may allocate. Keeps a reference to the geometry.
class NearObjectSearch {
 public:
  explicit NearObjectSearch(const SceneGeometry& geometry);

  /// Pairs within `reach` with the tool at `X_WT`, nearest first (deepest penetration first of all), valid
  /// until the next call. `bodies[i]` is the state of moving_index i.
  std::span<const NearPair> find(const Pose& X_WT, std::span<const BodyState> bodies, const Reach& reach);

 private:
  struct Piece {
    int body;
    int body_piece;
  };
  struct Memory {
    ClosestPointsCache cache;
    Vector3 n_W = Vector3::Zero();  ///< normal of the last step, zero before the first
    long last_seen = 0;
  };

  void move_boxes(std::span<const BodyState> bodies, const Reach& reach);
  double speed_of(const Body& body, const Shape& piece, std::span<const BodyState> bodies) const;
  const Pose& pose_of(const Body& body, std::span<const BodyState> bodies) const;
  static bool measure(const PlacedShape& tool, const PlacedShape& object, Memory& memory, NearPair& pair);
  void forget_distant_pairs();

  const SceneGeometry& geometry_;
  SweepAndPrune sweep_and_prune_;
  std::vector<Piece> pieces_;                       ///< by handle of sweep_and_prune_
  std::vector<int> moving_handles_;                 ///< handles of the pieces of moving bodies
  std::map<std::pair<int, int>, Memory> memories_;  ///< by (tool piece, handle)
  std::vector<NearPair> pairs_;
  long step_ = 0;
};

}  // namespace tegotae
