// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/contact/box_tree.hpp>
#include <tegotae/contact/closest_points.hpp>
#include <tegotae/contact/sweep_and_prune.hpp>
#include <tegotae/model/scene_geometry.hpp>

#include <array>
#include <map>
#include <optional>
#include <span>
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
/// pieces, then closest points of each candidate. A moving body of many pieces has one box there, and a hierarchy of
/// its pieces' boxes in its own frame: a step costs it one update, however many pieces it has. Where pieces penetrate,
/// the plane is that of the least parting translation, followed from the previous step's normal, so that it stays
/// coherent from step to step. For the physics rate: may allocate. Keeps a reference to the geometry.
class NearObjectSearch {
 public:
  explicit NearObjectSearch(const SceneGeometry& geometry);

  /// Pairs within `reach` with the tool at `X_WT`, nearest first (deepest penetration first of all), valid
  /// until the next call. `bodies[i]` is the state of moving_index i.
  std::span<const NearPair> find(const Pose& X_WT, std::span<const BodyState> bodies, const Reach& reach);

 private:
  /// What a box of the sweep and prune holds: a piece, or a whole body with the tree of its pieces.
  struct Boxed {
    int body = 0;
    int body_piece = 0;
    std::optional<BoxTree> tree;
    double radius = 0.0;  ///< of the body's pieces about its centre of mass, m
  };
  struct Piece {
    int body;
    int body_piece;
  };
  struct Memory {
    ClosestPointsCache cache;
    Vector3 n_W = Vector3::Zero();  ///< normal of the last step, zero before the first
    long last_seen = 0;
  };

  void add_whole(size_t body);
  void add_piece(size_t body, size_t piece);
  void move_boxes(std::span<const BodyState> bodies, const Reach& reach);
  double speed_of(const Body& body, double radius, std::span<const BodyState> bodies) const;
  void find_pieces(const Shape& tool_shape, const Pose& X_WT, std::span<const BodyState> bodies, const Reach& reach);
  void add_pair(int tool_piece, const PlacedShape& tool, const Piece& piece, std::span<const BodyState> bodies,
                const Reach& reach);
  const Pose& pose_of(const Body& body, std::span<const BodyState> bodies) const;
  static bool measure(const PlacedShape& tool, const PlacedShape& object, Memory& memory, NearPair& pair);
  void forget_distant_pairs();

  const SceneGeometry& geometry_;
  SweepAndPrune sweep_and_prune_;
  std::vector<Boxed> boxed_;                       ///< by handle of sweep_and_prune_
  std::vector<int> moving_handles_;                ///< handles of what moves
  std::vector<Piece> pieces_;                      ///< near one piece of the tool, in the order of bodies and pieces
  std::map<std::array<int, 3>, Memory> memories_;  ///< by piece of the tool, body and piece of the body
  std::vector<NearPair> pairs_;
  long step_ = 0;
};

}  // namespace tegotae
