// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/separation_step.hpp>

#include <tegotae/lab/quadratic_program.hpp>
#include <tegotae/lab/separating_plane.hpp>
#include <tegotae/math/rotation.hpp>

#include <algorithm>
#include <cmath>

namespace tegotae {
namespace {

constexpr double kUnit = 1e-4;            // m: unknowns and rows are in this unit
constexpr double kTurn = 0.5;             // rad that one step may turn a plane
constexpr double kPlaneProximity = 1e-6;  // pulls planes to where they are, where nothing else holds them
constexpr double kOffsetProximity = 1e-8;
constexpr size_t kFewVertices = 40;  // all of them are rows
constexpr double kBand = 1e-3;       // m from the plane: vertices that are rows at first
constexpr double kMissed = 1e-13;    // m that a vertex which is not a row may violate the step's plane
constexpr int kRounds = 30;

// Unknowns in units: tool 0..5, then t1, t2, d, s of each pair.
class Builder {
 public:
  Builder(const SeparationStepInput& input, std::span<PlanePair> pairs) : in_(input), pairs_(pairs) {
    for (const PlanePair& pair : pairs) {
      Side side;
      side.tangents = tangents_of(pair.n);
      side.offset = greatest_along(*pair.below, pair.n) - pair.n.dot(in_.centre_W);
      side.above.resize(pair.above->vertices.size());
      side.below.resize(pair.below->vertices.size());
      sides_.push_back(side);
      choose_near(sides_.size() - 1);
    }
  }

  QuadraticSolution run(bool with_curvature) {
    for (int round = 0;; ++round) {
      const QuadraticProgram program = make_program(with_curvature);
      QuadraticSolution solution = solve(program);
      if (!solution.converged || round >= kRounds || !add_missed(solution.y)) return solution;
    }
  }

  SeparationStep finish(const QuadraticSolution& solution) {
    SeparationStep step;
    step.converged = solution.converged;
    step.move.head<3>() = solution.y.head<3>() * kUnit;
    step.move.tail<3>() = solution.y.segment<3>(3) * kUnit / in_.tool_radius;
    const Vector6 left = step.move - in_.to_hand;
    step.value =
        0.5 * (left.head<3>().squaredNorm() + in_.metric_length * in_.metric_length * left.tail<3>().squaredNorm());
    for (size_t j = 0; j < pairs_.size(); ++j) {
      take_pair(j, solution);
      step.value += 0.5 * kViolationWeight * pairs_[j].slack * pairs_[j].slack;
    }
    return step;
  }

 private:
  struct Side {
    Eigen::Matrix<double, 3, 2> tangents;
    double offset = 0.0;             // m, about the centre of mass
    std::vector<char> above, below;  // which vertices are rows
  };

  static int column(size_t pair) { return 6 + 4 * static_cast<int>(pair); }
  double clearance(const PlanePair& pair) const { return in_.skin + pair.above->radius + pair.below->radius; }

  void choose_near(size_t j) {
    const PlanePair& pair = pairs_[j];
    Side& side = sides_[j];
    for (size_t i = 0; i < side.above.size(); ++i)
      side.above[i] = side.above.size() <= kFewVertices ||
                      pair.n.dot(pair.above->vertices[i] - in_.centre_W) - side.offset - clearance(pair) < kBand;
    for (size_t i = 0; i < side.below.size(); ++i)
      side.below[i] =
          side.below.size() <= kFewVertices || side.offset - pair.n.dot(pair.below->vertices[i] - in_.centre_W) < kBand;
  }

  // Coefficients on the tool's six, t1, t2, d, s of the row n . p - d - clearance + s >= 0.
  Eigen::Matrix<double, 1, 10> above_row(size_t j, const Vector3& arm) const {
    Eigen::Matrix<double, 1, 10> row;
    const Vector3& n = pairs_[j].n;
    row << n.transpose(), arm.cross(n).transpose() / in_.tool_radius, turn_coefficients(j, arm), -1.0, 1.0;
    return row;
  }

  // A half-space's plane does not turn and does not move.
  Eigen::Matrix<double, 1, 2> turn_coefficients(size_t j, const Vector3& arm) const {
    if (pairs_[j].below->is_half_space) return Eigen::Matrix<double, 1, 2>::Zero();
    return (sides_[j].tangents.transpose() * arm).transpose() / in_.tool_radius;
  }

  double above_bound(size_t j, const Vector3& arm) const {
    return -(pairs_[j].n.dot(arm) - sides_[j].offset - clearance(pairs_[j])) / kUnit;
  }
  double below_bound(size_t j, const Vector3& arm) const { return -(sides_[j].offset - pairs_[j].n.dot(arm)) / kUnit; }

  InequalityGroup above_rows(size_t j) const {
    const PlanePair& pair = pairs_[j];
    const auto count = std::count(sides_[j].above.begin(), sides_[j].above.end(), char{1});
    const int c = column(j);
    InequalityGroup rows{
        Eigen::MatrixXd(count, 10), Eigen::VectorXd(count), {0, 1, 2, 3, 4, 5, c, c + 1, c + 2, c + 3}};
    Eigen::Index r = 0;
    for (size_t i = 0; i < sides_[j].above.size(); ++i) {
      if (!sides_[j].above[i]) continue;
      const Vector3 arm = pair.above->vertices[i] - in_.centre_W;
      rows.A.row(r) = above_row(j, arm);
      rows.b[r++] = above_bound(j, arm);
    }
    return rows;
  }

  InequalityGroup below_rows(size_t j) const {
    const PlanePair& pair = pairs_[j];
    const auto count = std::count(sides_[j].below.begin(), sides_[j].below.end(), char{1});
    const int c = column(j);
    InequalityGroup rows{Eigen::MatrixXd::Zero(count + 4, 3), Eigen::VectorXd(count + 4), {c, c + 1, c + 2}};
    Eigen::Index r = 0;
    for (size_t i = 0; i < sides_[j].below.size(); ++i) {
      if (!sides_[j].below[i]) continue;
      const Vector3 arm = pair.below->vertices[i] - in_.centre_W;
      rows.A.row(r) << -turn_coefficients(j, arm), 1.0;
      rows.b[r++] = below_bound(j, arm);
    }
    const double most = kTurn * in_.tool_radius / kUnit;
    for (Eigen::Index side = 0; side < 4; ++side) {
      rows.A(r + side, side / 2) = (side % 2 == 0 ? 1.0 : -1.0) / most;
      rows.b[r + side] = -1.0;
    }
    return rows;
  }

  InequalityGroup trust_rows() const {
    InequalityGroup rows{
        Eigen::MatrixXd(12, 6), Eigen::VectorXd::Constant(12, -0.5 * in_.trust / kUnit), {0, 1, 2, 3, 4, 5}};
    rows.A << Eigen::MatrixXd::Identity(6, 6), -Eigen::MatrixXd::Identity(6, 6);
    return rows;
  }

  QuadraticProgram make_program(bool with_curvature) const {
    QuadraticProgram program;
    const auto size = static_cast<Eigen::Index>(6 + 4 * pairs_.size());
    program.H = Eigen::MatrixXd::Zero(size, size);
    const double turning = std::pow(in_.metric_length / in_.tool_radius, 2);
    program.H.diagonal().head<6>() << 1.0, 1.0, 1.0, turning, turning, turning;
    program.g = Eigen::VectorXd::Zero(size);
    program.g.head<3>() = -in_.to_hand.head<3>() / kUnit;
    program.g.segment<3>(3) = -turning * in_.to_hand.tail<3>() * in_.tool_radius / kUnit;
    program.groups.push_back(trust_rows());
    for (size_t j = 0; j < pairs_.size(); ++j) {
      const int c = column(j);
      program.H.diagonal().segment<4>(c) << kPlaneProximity, kPlaneProximity, kOffsetProximity, kViolationWeight;
      if (with_curvature) add_curvature(j, program.H);
      program.groups.push_back(above_rows(j));
      program.groups.push_back(below_rows(j));
    }
    return program;
  }

  // Second derivatives of the Lagrangian: of n(t) . R(theta) r, with |n| = 1.
  void add_curvature(size_t j, Eigen::MatrixXd& H) const {
    const PlanePair& pair = pairs_[j];
    const double rho = in_.tool_radius;
    const Vector3 &n = pair.n, &m = pair.load_moment;
    H.block<3, 3>(3, 3) +=
        (n.dot(m) * Matrix3::Identity() - 0.5 * (n * m.transpose() + m * n.transpose())) / (rho * rho);
    if (pair.below->is_half_space) return;
    const int c = column(j);
    const Eigen::Matrix<double, 2, 3> T = sides_[j].tangents.transpose();
    const Eigen::Matrix<double, 2, 3> with_shift = -pair.load * T / rho, with_turn = T * skew(m) / (rho * rho);
    H.block<2, 3>(c, 0) += with_shift;
    H.block<3, 2>(0, c) += with_shift.transpose();
    H.block<2, 3>(c, 3) += with_turn;
    H.block<3, 2>(3, c) += with_turn.transpose();
    H.block<2, 2>(c, c) += pair.load * (clearance(pair) - pair.slack) / (rho * rho) * Eigen::Matrix2d::Identity();
  }

  bool add_missed(const Eigen::VectorXd& y) {
    bool missed = false;
    for (size_t j = 0; j < pairs_.size(); ++j) {
      const int c = column(j);
      Eigen::Matrix<double, 10, 1> x;
      x << y.head<6>(), y.segment<4>(c);
      const auto& above = pairs_[j].above->vertices;
      const auto& below = pairs_[j].below->vertices;
      for (size_t i = 0; i < above.size(); ++i) {
        const Vector3 arm = above[i] - in_.centre_W;
        if (sides_[j].above[i] || above_row(j, arm).dot(x) >= above_bound(j, arm) - kMissed / kUnit) continue;
        sides_[j].above[i] = missed = true;
      }
      for (size_t i = 0; i < below.size(); ++i) {
        const Vector3 arm = below[i] - in_.centre_W;
        const double value = -turn_coefficients(j, arm).dot(y.segment<2>(c)) + y[c + 2];
        if (sides_[j].below[i] || value >= below_bound(j, arm) - kMissed / kUnit) continue;
        sides_[j].below[i] = missed = true;
      }
    }
    return missed;
  }

  void take_pair(size_t j, const QuadraticSolution& solution) {
    PlanePair& pair = pairs_[j];
    const int c = column(j);
    const Eigen::VectorXd& multipliers = solution.multipliers[1 + 2 * j];
    pair.load = 0.0;
    pair.load_moment.setZero();
    Eigen::Index r = 0;
    for (size_t i = 0; i < sides_[j].above.size(); ++i) {
      if (!sides_[j].above[i]) continue;
      const double load = multipliers[r++] * kUnit;
      pair.load += load;
      pair.load_moment += load * (pair.above->vertices[i] - in_.centre_W);
    }
    pair.slack = std::max(0.0, solution.y[c + 3] * kUnit);
    if (!pair.below->is_half_space)
      pair.n = (pair.n + sides_[j].tangents * solution.y.segment<2>(c) * (kUnit / in_.tool_radius)).normalized();
  }

  const SeparationStepInput& in_;
  std::span<PlanePair> pairs_;
  std::vector<Side> sides_;
};

}  // namespace

SeparationStep separation_step(const SeparationStepInput& input, std::span<PlanePair> pairs) {
  Builder builder(input, pairs);
  QuadraticSolution solution = builder.run(true);
  if (!solution.converged) solution = builder.run(false);
  return builder.finish(solution);
}

}  // namespace tegotae
