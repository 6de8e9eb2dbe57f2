// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/contact/closest_points.hpp>
#include <tegotae/model/intermediate_representation.hpp>
#include <tegotae/model/scene_geometry.hpp>

#include <array>
#include <vector>

namespace tegotae {

/// A pair of pieces that physics named, and what is remembered of it while it is far.
struct TrackedPair {
  std::int32_t tool_piece = 0;
  std::int32_t body = 0;
  std::int32_t body_piece = 0;
  std::int32_t near_body = -1;    ///< of the moving bodies near, -1: static
  std::int32_t contact = -1;      ///< its place among the contacts, -1: far
  Vector3 n_B = Vector3::Zero();  ///< last normal, unit, out of the object, body's frame; zero: unknown
  ClosestPointsCache cache;

  bool is_same_pair(const TrackedPair& other) const noexcept {
    return tool_piece == other.tool_piece && body == other.body && body_piece == other.body_piece;
  }
};

/// A moving body as the haptic rate follows it.
struct TrackedBody {
  std::int32_t moving_index = -1;
  Pose X_WB;                       ///< now
  Vector3 p_WC = Vector3::Zero();  ///< centre of mass, m
  Vector3 p_BC = Vector3::Zero();  ///< the same on the body, m
  double radius = 0.0;             ///< of its pieces about the centre of mass, m
  double linear = 0.0;             ///< m that it moved since the last tick
  double angular = 0.0;            ///< rad
  double travelled = 0.0;          ///< m that any of its points moved since the model came, at most
};

/// All pairs of pieces that physics named, each far one with its *room*: a lower bound of its distance. Rooms are kept
/// against odometers of the tool and of each body, so that a motion costs one addition for all pairs together: a tick
/// looks at the far pairs one by one only where motions may have brought one within reach. New pairs have the room that
/// their last plane proves. Construction allocates; the rest does not, nor throws. Keeps a reference to the geometry.
class NearPairs {
 public:
  static constexpr double kFar = 1e300;

  explicit NearPairs(const SceneGeometry& geometry);

  /// Takes the pairs of a new model, the tool at `X_WT`, and the bodies' poses of every model. True if the pairs were
  /// new: then `renamed` says what became of the former ones.
  bool take(const IntermediateRepresentation& model, const Pose& X_WT) noexcept;

  /// Place of a former pair, -1 where it is no longer near.
  int renamed(int former) const noexcept { return renamed_[static_cast<size_t>(former)]; }

  /// The tool moved; no point of it further than `way` (m).
  void travel(double way) noexcept {
    tool_travelled_ += way;
    travelled_ += way;
  }

  /// How far a point of a moving body moved in the last `take`, at most, m.
  double bodies_way() const noexcept { return bodies_way_; }

  /// The far pair with least room, -1 without any whose room is less than `room` (m).
  int nearest_below(double room) noexcept;

  /// Calls `enter(pair)` for each far pair whose room is at most `limit` (m); `enter` may `take_out` that pair.
  template <class Enter>
  void visit_within(double limit, const Enter& enter) noexcept {
    if (limit + travelled_ < next_look_) return;
    double least = kFar;
    for (int i = 0; i < count_; ++i) {
      if (room_of(i) <= limit) enter(i);
      const double room = room_of(i);
      least = room < least ? room : least;
    }
    next_look_ = least + travelled_;
  }

  /// The pair becomes the contact `contact`; returns its room, m.
  double take_out(int pair, int contact) noexcept;

  /// The pair is far again: its room (m) and last normal.
  void put_back(int pair, double room, const Vector3& n_W, const ClosestPointsCache& cache) noexcept;

  void reset() noexcept;

  TrackedPair& operator[](int pair) noexcept { return pairs_[static_cast<size_t>(pair)]; }
  int count() const noexcept { return count_; }
  const TrackedBody& moving(int near_body) const noexcept { return bodies_[static_cast<size_t>(near_body)]; }
  Pose pose_of(const TrackedPair& pair) const noexcept;

 private:
  using Bodies = std::array<TrackedBody, kMaxNearBodies>;

  double travelled_of(int near_body) const noexcept {
    return tool_travelled_ + (near_body < 0 ? 0.0 : bodies_[static_cast<size_t>(near_body)].travelled);
  }
  double room_of(int pair) const noexcept {
    return due_[static_cast<size_t>(pair)] - travelled_of(near_body_[static_cast<size_t>(pair)]);
  }
  void name(const IntermediateRepresentation& model, const Pose& X_WT) noexcept;
  void name_bodies(const IntermediateRepresentation& model) noexcept;
  void index_former() noexcept;
  int find_former(const TrackedPair& wanted) const noexcept;
  double room_by_plane(TrackedPair& pair, const Pose& X_WT) const noexcept;
  void move_bodies(const IntermediateRepresentation& model) noexcept;

  const SceneGeometry& geometry_;
  std::vector<double> radii_;  ///< of each body's pieces about its centre of mass, m

  std::vector<TrackedPair> pairs_, former_;
  std::vector<double> due_, former_due_;  ///< room plus the odometers when it was known; kFar: a contact
  std::vector<std::int32_t> near_body_;   ///< of each pair
  std::vector<int> renamed_;
  int count_ = 0;
  int former_count_ = 0;
  std::vector<int> table_;  ///< of former_, open addressing by pieces; -1: free
  Bodies bodies_, former_bodies_;
  int body_count_ = 0;
  int former_body_count_ = 0;
  double tool_travelled_ = 0.0;
  double bodies_way_ = 0.0;
  double travelled_ = 0.0;    ///< at least what tool and any one body travelled together
  double next_look_ = -kFar;  ///< no far pair has less room than this minus `travelled_`
  std::uint64_t sequence_ = 0;
};

/// Greatest distance (m) of a point of the piece from `p_B`, both on their body.
double radius_about(const Shape& piece, const Vector3& p_B) noexcept;

}  // namespace tegotae
