// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/quadratic_program.hpp>

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <limits>

namespace tegotae {
namespace {

constexpr int kIterations = 100;
constexpr double kPrimalResidual = 1e-11;   // of a row
constexpr double kDualResidual = 1e-9;      // relative to the greatest of g and 1: rounding leaves a tenth
constexpr double kComplementarity = 1e-13;  // mean of slack times multiplier, relative to the same
constexpr double kRounding = 1e-13;         // of the greatest multiplier, in the dual residual
constexpr double kSlackRounding = 1e-16;    // the same, in the complementarity
constexpr double kExhausted = 1e-17;        // the same: nothing is left to gain, but digits to lose
constexpr double kGoodEnough = 1e3;         // of these tolerances, where rounding stops progress
constexpr double kFirstShift = 1e-6;        // of Newton's matrix
constexpr double kShiftGrowth = 10.0;
constexpr int kShifts = 20;
constexpr double kLeastStep = 1e-12;
constexpr int kCorrectedSteps = 25;  // far more than programs need that do not cycle
constexpr double kPlainCentring = 0.3;
constexpr double kToTheWall = 0.995;  // share of the way to the nearest bound

class InteriorPoint {
 public:
  explicit InteriorPoint(const QuadraticProgram& program) : program_(program), size_(program.g.size()) {
    for (const InequalityGroup& group : program.groups) count_ += group.b.size();
    y_ = Eigen::VectorXd::Zero(size_);
    b_.resize(count_);
    Eigen::Index first = 0;
    for (const InequalityGroup& group : program.groups) {
      b_.segment(first, group.b.size()) = group.b;
      first += group.b.size();
    }
    const double scale = std::max(1.0, program.g.size() > 0 ? program.g.lpNorm<Eigen::Infinity>() : 0.0);
    goal_ = scale;
    slack_ = (-b_).cwiseMax(1.0);
    multiplier_ = (scale * slack_.cwiseInverse()).cwiseMin(scale).cwiseMax(1e-2);
  }

  QuadraticSolution run() {
    QuadraticSolution solution;
    double least = std::numeric_limits<double>::infinity();
    Eigen::VectorXd multiplier = multiplier_;
    for (; solution.iterations < kIterations; ++solution.iterations) {
      update_residuals();
      if (const double now = error(); now < least || solution.y.size() == 0) {
        least = now;
        solution.y = y_;
        multiplier = multiplier_;
      }
      if (least <= 1.0 || (gap_ <= kExhausted * goal_ && count_ > 0)) break;
      if (!factorise() || advance() < kLeastStep) break;
    }
    solution.converged = least <= kGoodEnough;
    Eigen::Index first = 0;
    for (const InequalityGroup& group : program_.groups) {
      solution.multipliers.emplace_back(multiplier.segment(first, group.b.size()));
      first += group.b.size();
    }
    return solution;
  }

 private:
  Eigen::VectorXd times(const Eigen::VectorXd& y) const {
    Eigen::VectorXd product(count_);
    Eigen::Index first = 0;
    for (const InequalityGroup& group : program_.groups) {
      const Eigen::VectorXd part = y(group.columns);
      product.segment(first, group.b.size()).noalias() = group.A * part;
      first += group.b.size();
    }
    return product;
  }

  Eigen::VectorXd transposed_times(const Eigen::VectorXd& z) const {
    Eigen::VectorXd product = Eigen::VectorXd::Zero(size_);
    Eigen::Index first = 0;
    for (const InequalityGroup& group : program_.groups) {
      const Eigen::VectorXd part = group.A.transpose() * z.segment(first, group.b.size());
      product(group.columns) += part;
      first += group.b.size();
    }
    return product;
  }

  void update_residuals() {
    primal_ = times(y_) - b_ - slack_;
    dual_ = program_.H * y_ + program_.g - transposed_times(multiplier_);
    gap_ = count_ > 0 ? slack_.dot(multiplier_) / static_cast<double>(count_) : 0.0;
  }

  // The worst residual over its tolerance. Multipliers that oppose each other may be far greater than what they leave:
  // their rounding counts as nothing.
  double error() const {
    const double greatest = count_ > 0 ? multiplier_.maxCoeff() : 0.0;
    const double primal = count_ > 0 ? primal_.lpNorm<Eigen::Infinity>() / kPrimalResidual : 0.0;
    const double dual = dual_.lpNorm<Eigen::Infinity>() / (kDualResidual * goal_ + kRounding * greatest);
    return std::max({primal, dual, gap_ / (kComplementarity * goal_ + kSlackRounding * greatest)});
  }

  // Newton's matrix H + A^T diag(z / w) A, positive definite.
  bool factorise() {
    Eigen::MatrixXd matrix = program_.H;
    Eigen::Index first = 0;
    for (const InequalityGroup& group : program_.groups) {
      const Eigen::Index rows = group.b.size();
      const Eigen::VectorXd weight = multiplier_.segment(first, rows).cwiseQuotient(slack_.segment(first, rows));
      const Eigen::MatrixXd weighted = weight.asDiagonal() * group.A;
      const Eigen::MatrixXd part = group.A.transpose() * weighted;
      matrix(group.columns, group.columns) += part;
      first += rows;
    }
    shift_ = 0.0;
    for (int attempt = 0; attempt < kShifts; ++attempt) {
      factor_.compute(matrix + shift_ * Eigen::MatrixXd::Identity(size_, size_));
      if (factor_.info() == Eigen::Success) return true;
      shift_ = std::max(kFirstShift, shift_ * kShiftGrowth);
    }
    return false;
  }

  struct Direction {
    Eigen::VectorXd y, slack, multiplier;
  };

  // The direction that makes slack * multiplier + `complement` vanish, to first order.
  Direction direction(const Eigen::VectorXd& complement) const {
    const Eigen::VectorXd weight = multiplier_.cwiseQuotient(slack_);
    const Eigen::VectorXd lean = -complement.cwiseQuotient(slack_) - weight.cwiseProduct(primal_);
    Direction d;
    const Eigen::VectorXd right = transposed_times(lean) - dual_;
    d.y = factor_.solve(right);
    if (shift_ == 0.0)
      d.y += factor_.solve(right - program_.H * d.y - transposed_times(weight.cwiseProduct(times(d.y))));
    const Eigen::VectorXd rows = times(d.y);
    d.slack = rows + primal_;
    d.multiplier = lean - weight.cwiseProduct(rows);
    return d;
  }

  static double way(const Eigen::VectorXd& value, const Eigen::VectorXd& change) {
    double most = 1.0;
    for (Eigen::Index i = 0; i < value.size(); ++i)
      if (change[i] < 0.0) most = std::min(most, -value[i] / change[i]);
    return most;
  }

  double advance() {
    const Direction affine = direction(slack_.cwiseProduct(multiplier_));
    const double affine_way = std::min(way(slack_, affine.slack), way(multiplier_, affine.multiplier));
    const double affine_gap =
        count_ > 0 ? (slack_ + affine_way * affine.slack).dot(multiplier_ + affine_way * affine.multiplier) /
                         static_cast<double>(count_)
                   : 0.0;
    // Mehrotra's corrector may cycle: a plain step along the central path does not.
    const bool corrects = ++steps_ <= kCorrectedSteps;
    const double centring = corrects && gap_ > 0.0 ? std::pow(affine_gap / gap_, 3) : kPlainCentring;
    Eigen::VectorXd complement = slack_.cwiseProduct(multiplier_).array() - centring * gap_;
    if (corrects) complement += affine.slack.cwiseProduct(affine.multiplier);
    const Direction d = direction(complement);
    const double most = std::min(way(slack_, d.slack), way(multiplier_, d.multiplier));
    const double length = most >= 1.0 ? 1.0 : kToTheWall * most;
    y_ += length * d.y;
    slack_ += length * d.slack;
    multiplier_ += length * d.multiplier;
    return length;
  }

  const QuadraticProgram& program_;
  Eigen::Index size_, count_ = 0;
  Eigen::VectorXd y_, b_, slack_, multiplier_, primal_, dual_;
  int steps_ = 0;
  double gap_ = 0.0, goal_ = 1.0, shift_ = 0.0;
  Eigen::LLT<Eigen::MatrixXd> factor_;
};

}  // namespace

QuadraticSolution solve(const QuadraticProgram& program) { return InteriorPoint(program).run(); }

}  // namespace tegotae
