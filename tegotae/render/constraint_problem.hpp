// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/math/types.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace tegotae {

/// The N unknowns: 6 a block, a small displacement [dr (m); dtheta (rad)] about the block's centre of mass.
template <int N>
using Unknowns = Eigen::Matrix<double, N, 1, Eigen::DontAlign>;
template <int N>
using UnknownsMatrix = Eigen::Matrix<double, N, N, Eigen::DontAlign>;
template <int N>
using FrictionJacobian = Eigen::Matrix<double, 3, N, Eigen::DontAlign>;

/// Rows are stored and worked on in groups of this many, component by component, so that loops vectorise.
inline constexpr int kRowLanes = 8;
using RowLanes = Eigen::Array<double, kRowLanes, 1, Eigen::DontAlign>;

/// Eight contact rows; unused lanes hold J = 0, b = -1: never violated.
template <int N>
struct alignas(64) RowGroup {
  Eigen::Array<double, kRowLanes, N, Eigen::DontAlign> J;
  RowLanes b;
};

/// Compliance c and stiffness 1/c (0 where c = 0) of eight rows.
struct alignas(64) RowCompliance {
  RowLanes c;
  RowLanes stiffness;
};

/// Three rows s = b - J x whose force lies in the ellipsoid sum (lambda_j / radius_j)^2 <= 1: two tangential components
/// (m, N) and a torsional one (rad, N m), or an ordinary spring (infinite radii).
template <int N>
struct FrictionBlock {
  FrictionJacobian<N> J;
  Vector3 b = Vector3::Zero();           ///< m, m, rad
  Vector3 compliance = Vector3::Ones();  ///< >= 0; m/N, m/N, rad/(N m)
  Vector3 radius = Vector3::Zero();      ///< >= 0, infinity allowed; N, N, N m. 0: no force along this component
};

/// The problem of the haptic tick: where may the tool be, and with what forces is it held there?
///
///     minimise over x   1/2 (x - x_free)^T K (x - x_free) + sum_i phi_i(b_i - J_i x) + sum_f Phi_f(b_f - J_f x)
///
/// K: symmetric positive definite, N x N; for one tool diag(k, k, k, k l^2, k l^2, k l^2) (design: the metric decides
/// what is felt). K (x_free - x) is the wrench of the constraints' reaction on the coupling; x - x_free = K^-1 J^T
/// lambda.
///
///  * Contact row (J_i, b_i, c_i):  phi_i(s) = max(0, s)^2 / (2 c_i), so lambda_i = max(0, b_i - J_i x) / c_i >= 0.
///    c_i = 0 is the hard limit J_i x >= b_i, lambda_i >= 0, lambda_i (J_i x - b_i) = 0. In general
///    0 <= lambda_i  complementary to  J_i x + c_i lambda_i - b_i >= 0.
///  * Friction block (J_f, b_f, C_f, r_f):  Phi_f(s) = max over lambda in E_f of  lambda^T s - 1/2 lambda^T C_f lambda,
///    E_f the ellipsoid of radii r_f: quadratic while the force stays inside, of linear growth outside (the Moreau
///    envelope of E_f's support function). lambda_f is that maximum: s / c projected onto E_f in the metric C_f.
///
/// The objective is strictly convex, so x is unique, and so are the multipliers where the compliance is positive.
///
/// Construction allocates for the given capacities; everything else neither allocates nor throws. Refilled every tick:
/// `set_objective`, then rows. Rows beyond a capacity are dropped and counted.
template <int N>
class ConstraintProblem {
 public:
  explicit ConstraintProblem(int row_capacity = 8192, int friction_capacity = 64);

  /// Removes all rows and sets K and x_free. Costs N^3. A K that is not finite, symmetric (to 1e-9) and positive
  /// definite, or an x_free that is not finite, makes the problem invalid.
  void set_objective(const UnknownsMatrix<N>& K, const Unknowns<N>& x_free) noexcept;

  /// Appends J x >= b with compliance c >= 0 (m/N where J x is in m). False where dropped (capacity). Values that are
  /// not finite, or c < 0, make the problem invalid.
  bool add_contact(const Unknowns<N>& J, double b, double c) noexcept;

  /// Appends a friction block. False where dropped (capacity).
  bool add_friction(const FrictionBlock<N>& block) noexcept;

  /// Appends a spring of compliance c > 0 that pulls J x to `target` from both sides. Its force is the first component
  /// of the friction block that it occupies. False where dropped.
  bool add_spring(const Unknowns<N>& J, double target, double c) noexcept;

  bool is_valid() const noexcept { return valid_; }
  int contact_count() const noexcept { return contact_count_; }
  int friction_count() const noexcept { return static_cast<int>(friction_.size()); }
  int contact_capacity() const noexcept { return contact_capacity_; }
  int friction_capacity() const noexcept { return static_cast<int>(friction_.capacity()); }
  int dropped_count() const noexcept { return dropped_count_; }  ///< rows and blocks since set_objective

  const UnknownsMatrix<N>& K() const noexcept { return K_; }
  const UnknownsMatrix<N>& K_inverse() const noexcept { return K_inverse_; }
  const Unknowns<N>& x_free() const noexcept { return x_free_; }

  Unknowns<N> J(int row) const noexcept { return groups_[row / kRowLanes].J.row(row % kRowLanes).matrix().transpose(); }
  double b(int row) const noexcept { return groups_[row / kRowLanes].b[row % kRowLanes]; }
  double c(int row) const noexcept { return compliances_[row / kRowLanes].c[row % kRowLanes]; }
  const FrictionBlock<N>& friction(int block) const noexcept { return friction_[block]; }

  /// The rows in groups of eight, the last one padded.
  int group_count() const noexcept { return (contact_count_ + kRowLanes - 1) / kRowLanes; }
  const RowGroup<N>* groups() const noexcept { return groups_.data(); }
  const RowCompliance* compliances() const noexcept { return compliances_.data(); }

  /// Upper bound of sqrt(J_i K^-1 J_i^T) over the contact rows: |J_i d| <= row_norm() |d|_K for every d.
  double row_norm() const noexcept { return std::sqrt(row_norm_squared_); }
  /// Least compliance of a row relative to the coupling's own: c / row_norm()^2 over the contact rows and
  /// c_j / (J_j K^-1 J_j^T) over the friction components that can carry force; infinity without any.
  double least_relative_compliance() const noexcept {
    const double contact = row_norm_squared_ > 0.0 ? least_compliance_ / row_norm_squared_ : HUGE_VAL;
    return std::min(contact, least_friction_compliance_);
  }

 private:
  int contact_capacity_;
  int contact_count_ = 0;
  int dropped_count_ = 0;
  bool valid_ = false;
  double row_norm_squared_ = 0.0;
  double least_compliance_ = std::numeric_limits<double>::infinity();
  double least_friction_compliance_ = std::numeric_limits<double>::infinity();
  UnknownsMatrix<N> K_ = UnknownsMatrix<N>::Identity();
  UnknownsMatrix<N> K_inverse_ = UnknownsMatrix<N>::Identity();
  Unknowns<N> norm_weights_ = Unknowns<N>::Ones();
  Unknowns<N> x_free_ = Unknowns<N>::Zero();
  std::vector<RowGroup<N>> groups_;
  std::vector<RowCompliance> compliances_;
  std::vector<FrictionBlock<N>> friction_;
};

// Inline, as thousands of rows are appended every tick.
template <int N>
inline bool ConstraintProblem<N>::add_contact(const Unknowns<N>& J, double b, double c) noexcept {
  if (contact_count_ == contact_capacity_) {
    ++dropped_count_;
    return false;
  }
  const int lane = contact_count_ % kRowLanes;
  RowGroup<N>& group = groups_[contact_count_ / kRowLanes];
  RowCompliance& compliance = compliances_[contact_count_ / kRowLanes];
  if (lane == 0) {
    group.J.setZero();
    group.b.setConstant(-1.0);
    compliance.c.setOnes();
    compliance.stiffness.setZero();
  }
  group.J.row(lane) = J.transpose().array();
  group.b[lane] = b;
  compliance.c[lane] = c;
  compliance.stiffness[lane] = c > 0.0 ? 1.0 / c : 0.0;
  ++contact_count_;
  const double norm_squared = norm_weights_.dot(J.cwiseAbs2());
  // Anything not finite makes this difference NaN, and so unequal to zero.
  const double probe = norm_squared + std::abs(b) + c;
  valid_ = valid_ && probe - probe == 0.0 && c >= 0.0;
  row_norm_squared_ = std::max(row_norm_squared_, norm_squared);
  least_compliance_ = std::min(least_compliance_, c);
  return true;
}

enum class ConstraintStatus : std::uint8_t {
  kConverged,       ///< KKT residual within tolerance
  kIterationLimit,  ///< stopped at the bound on iterations; x is the best found, still finite
  kInfeasible,      ///< hard rows contradict each other; x is the compromise of least sum of squared violations
  kInvalidInput,  ///< values not finite, compliance or radius negative, K not positive definite; x = x_free, no forces
};

/// Answer of the solver. Construction allocates for the capacities of a problem.
template <int N>
struct ConstraintSolution {
  explicit ConstraintSolution(const ConstraintProblem<N>& problem)
      : multipliers(problem.contact_capacity(), 0.0), friction_forces(problem.friction_capacity(), Vector3::Zero()) {
    active_rows.reserve(problem.contact_capacity());
  }

  ConstraintStatus status = ConstraintStatus::kConverged;
  Unknowns<N> x = Unknowns<N>::Zero();
  Unknowns<N> displacement = Unknowns<N>::Zero();  ///< x - x_free, to full relative precision
  Unknowns<N> force = Unknowns<N>::Zero();         ///< K (x - x_free) = J^T lambda: [N; N m] a block
  std::vector<double> multipliers;       ///< lambda of each contact row (0 where inactive and beyond the last)
  std::vector<Vector3> friction_forces;  ///< lambda of each friction block; valid up to friction_count()
  std::vector<int> active_rows;          ///< rows with lambda > 0, ascending
  int newton_iterations = 0;
  int line_search_steps = 0;
  int proximal_stages = 0;  ///< 0 where no row is (nearly) hard
};

/// Memory of the solver between ticks. Construction allocates for the capacities of a problem; holds nothing that the
/// answer depends on beyond rounding: only guesses of which rows will be active.
template <int N>
struct ConstraintWorkspace {
  explicit ConstraintWorkspace(const ConstraintProblem<N>& problem);

  /// Forgets the last solve: the next one starts cold.
  void reset() noexcept;

  struct FrictionState {
    Vector3 s;           ///< b - J x, with the proximal shift
    Vector3 change;      ///< decrease of s over a full step
    Vector3 compliance;  ///< of this proximal stage
    Vector3 force;       ///< lambda
    Vector3 previous;    ///< lambda of the last proximal stage
    Matrix3 stiffness;   ///< d lambda / d s
    bool sticks;         ///< the bound is not reached; a guess for the next solve
  };

  std::vector<RowLanes> violation;         ///< per group: b - J x (with the proximal shift), kept up to date
  std::vector<RowLanes> change;            ///< per group: decrease of the violation over a full step
  std::vector<RowLanes> previous;          ///< per group: multipliers of the last proximal stage
  std::vector<RowCompliance> regularised;  ///< per group: compliance of this proximal stage
  std::vector<std::uint8_t> violated;      ///< per group: bit set of the rows with positive violation
  std::vector<std::uint8_t> active;        ///< per group: bit set of the rows in Newton's matrix
  std::vector<int> near_groups;            ///< groups that may hold active rows
  std::vector<FrictionState> friction;
  std::vector<int> guess_groups;           ///< groups with active rows at the end of the last solve
  std::vector<std::uint8_t> guess_active;  ///< their bit sets
  int guess_friction_count = 0;
};

extern template class ConstraintProblem<6>;
extern template class ConstraintProblem<12>;
extern template struct ConstraintWorkspace<6>;
extern template struct ConstraintWorkspace<12>;

}  // namespace tegotae
