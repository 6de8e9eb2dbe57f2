// SPDX-License-Identifier: Apache-2.0
#include <tegotae/contact/interior_point.hpp>

#include <tegotae/contact/intersection_frame.hpp>
#include <tegotae/contact/tolerances.hpp>

#include <Eigen/LU>

#include <array>
#include <cmath>

namespace tegotae {
namespace {

using Vector4 = Eigen::Matrix<double, 4, 1, Eigen::DontAlign>;
using Matrix4 = Eigen::Matrix<double, 4, 4, Eigen::DontAlign>;

struct Plane {
  Vector3 normal = Vector3::Zero();  ///< unit, object's frame relative to the tool's origin
  double offset = 0.0;               ///< m
  double excess = -1e300;            ///< n.p + r - d at the present solution, m
};

// The linear program. Coordinates: the object's axes, origin at the tool shape's.
class GreatestBall {
 public:
  GreatestBall(const PlacedShape& tool, const PlacedShape& object, const Vector3& dilation_W) noexcept
      : frame_(tool, object, dilation_W), tool_(*tool.shape->polytope), object_(object.shape->polytope.get()) {
    // A tetrahedron so far around the tool that none of its planes can bind at the solution.
    const double distance = 10.0 * tool_.radius;
    const double s = 1.0 / std::sqrt(3.0);
    basis_ = {Plane{{s, s, s}, distance}, Plane{{s, -s, -s}, distance}, Plane{{-s, s, -s}, distance},
              Plane{{-s, -s, s}, distance}};
  }

  /// p and r; r < 0 if the two bodies are apart.
  Vector4 solve() noexcept {
    // Each round swaps one plane of the basis; ten to thirty suffice for hulls of a thousand faces.
    constexpr int kMaxRounds = 500;
    Vector4 solution = Vector4::Zero();
    for (int round = 0; round < kMaxRounds; ++round) {
      Matrix4 columns;
      Vector4 offsets;
      for (int k = 0; k < 4; ++k) {
        columns.col(k) << basis_[static_cast<size_t>(k)].normal, 1.0;
        offsets(k) = basis_[static_cast<size_t>(k)].offset;
      }
      const Eigen::PartialPivLU<Matrix4> lu(columns);
      solution = lu.transpose().solve(offsets);
      const Plane entering = most_violated(solution);
      if (entering.excess <= 0.1 * tolerances::kOnPlane) break;
      if (!exchange(entering, lu)) break;
    }
    return solution;
  }

  Vector3 world(const Vector3& p) const noexcept { return frame_.world(p + frame_.p_OT); }

 private:
  static void keep_worse(Plane& worst, const Vector3& normal, double offset, double excess) noexcept {
    if (excess > worst.excess) worst = {normal, offset, excess};
  }

  Plane most_violated(const Vector4& solution) const noexcept {
    const Vector3 p = solution.head<3>(), p_T = frame_.R_OT.transpose() * p, p_O = p + frame_.p_OT;
    const double r = solution(3);
    Plane worst;
    if (object_ == nullptr) {
      const double offset = frame_.shift(Vector3::UnitZ());
      keep_worse(worst, Vector3::UnitZ(), offset - frame_.p_OT.z(), p_O.z() + r - offset);
    } else {
      for (const auto& face : object_->faces) {
        const double offset = face.offset + frame_.shift(face.normal);
        keep_worse(worst, face.normal, offset - face.normal.dot(frame_.p_OT), face.normal.dot(p_O) + r - offset);
      }
    }
    Plane worst_tool;
    for (const auto& face : tool_.faces) {
      keep_worse(worst_tool, face.normal, face.offset, face.normal.dot(p_T) + r - face.offset);
    }
    if (worst_tool.excess <= worst.excess) return worst;
    worst_tool.normal = frame_.R_OT * worst_tool.normal;
    return worst_tool;
  }

  // Ratio test: the weights of the basis' planes, sum w n = 0, sum w = 1, stay >= 0. False if the program has no bound.
  bool exchange(const Plane& entering, const Eigen::PartialPivLU<Matrix4>& lu) noexcept {
    const Vector4 weights = lu.solve(Vector4(0.0, 0.0, 0.0, 1.0));
    const Vector4 column(entering.normal.x(), entering.normal.y(), entering.normal.z(), 1.0);
    const Vector4 rates = lu.solve(column);
    int leaving = -1;
    double least = 1e300;
    for (int k = 0; k < 4; ++k) {
      if (rates(k) > 1e-12 && weights(k) / rates(k) < least) least = weights(k) / rates(k), leaving = k;
    }
    if (leaving < 0) return false;
    basis_[static_cast<size_t>(leaving)] = entering;
    return true;
  }

  IntersectionFrame frame_;
  const Polytope& tool_;
  const Polytope* object_;
  std::array<Plane, 4> basis_;
};

}  // namespace

InteriorPoint interior_point(const PlacedShape& tool, const PlacedShape& object, const Vector3& dilation_W) noexcept {
  if (tool.shape == nullptr || object.shape == nullptr || !tool.shape->is_bounded()) return {};
  if (!IntersectionFrame(tool, object, dilation_W).is_finite()) return {};
  GreatestBall ball(tool, object, dilation_W);
  const Vector4 solution = ball.solve();
  if (!(solution(3) > tolerances::kOnPlane)) return {};
  return {true, ball.world(solution.head<3>()), solution(3)};
}

}  // namespace tegotae
