// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/math/pose.hpp>
#include <tegotae/render/constraint_problem.hpp>
#include <tegotae/render/contact_patch.hpp>

namespace tegotae {

/// How a pair of surfaces rubs.
struct FrictionLaw {
  double static_coefficient = 0.0;   ///< Coulomb, while it sticks
  double kinetic_coefficient = 0.0;  ///< while it slips
  double viscous = 0.0;              ///< N s/m, of the sliding speed, while in contact
  double compliance = 1e-9;          ///< m/N, tangential, of the bristle

  bool rubs() const noexcept { return static_coefficient > 0.0 || viscous > 0.0; }
};

/// What the last solve with friction says of a contact.
struct ContactLoad {
  double normal_force = 0.0;           ///< N
  Vector3 centre_W = Vector3::Zero();  ///< centre of pressure, m
  double mean_distance = 0.0;          ///< of the patch from its centre under uniform pressure, m
};

/// Friction of one pair of pieces: a bristle at the centre of pressure that holds the tool to the object, tangentially
/// and against twist about the normal, and gives way at the limit. Its force lies in the ellipsoid of mu N, mu N and
/// mu N rho, rho the patch's mean distance. Normal force, centre and rho are those of the last solve with friction and
/// fixed within a solve (halfway to the newest, so that an edge whose load friction changes settles); stretch grows by
/// what the surfaces really moved past each other at the centre, measured from poses, not by the linearised step.
/// The stretch is kept in the object's frame: it moves with the object. Copyable; no heap.
class Bristle {
 public:
  bool is_loaded() const noexcept { return normal_force_ > 0.0; }
  double normal_force() const noexcept { return normal_force_; }
  bool is_slipping() const noexcept { return slipping_; }
  /// Of the tool against the object, m, world axes.
  Vector3 stretch(const Pose& X_WB) const noexcept { return X_WB.q * stretch_B_; }
  Vector3 centre(const Pose& X_WT) const noexcept { return X_WT * centre_T_; }

  /// The bristle as rows about `p_WCm` for the tool at `X_WT`, contact normal `n_W`.
  FrictionBlock<6> block(const FrictionLaw& law, const Pose& X_WT, const Pose& X_WB, const Vector3& p_WCm,
                         const Vector3& n_W) const noexcept;

  /// Viscous drag as rows: towards where the centre of pressure was at the start of the tick, `dt` (s) long, `moved_W`
  /// ago.
  FrictionBlock<6> drag(const FrictionLaw& law, const Pose& X_WT, const Vector3& p_WCm, const Vector3& n_W,
                        const Vector3& moved_W, double dt) const noexcept;

  /// The tool moved from `from` to `to`; what exceeds the limit slips. Call before `load`.
  void follow_tool(const FrictionLaw& law, const Pose& from, const Pose& to, const Pose& X_WB,
                   const Vector3& n_W) noexcept;

  /// The object moved from `from` to `to` under the tool at `X_WT`.
  void follow_object(const Pose& from, const Pose& to, const Pose& X_WT, const Vector3& n_W) noexcept;

  /// Takes the load of a solve, the tool at `X_WT`. Without any the bristle lets go.
  void load(const ContactLoad& load, const Pose& X_WT) noexcept;

 private:
  Vector3 radius(const FrictionLaw& law) const noexcept;
  Vector3 compliance(const FrictionLaw& law) const noexcept;

  double normal_force_ = 0.0;
  double mean_distance_ = 0.0;
  Vector3 centre_T_ = Vector3::Zero();
  Vector3 stretch_B_ = Vector3::Zero();  ///< of the tool against the object, m
  double twist_ = 0.0;                   ///< about the normal, rad
  bool slipping_ = false;
};

}  // namespace tegotae
