// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/friction_references.hpp>

#include <tegotae/lab/motion.hpp>
#include <tegotae/math/rotation.hpp>
#include <tegotae/render/tolerances.hpp>

#include <algorithm>
#include <cmath>

namespace tegotae {
namespace {

// m: the distance from the world that the method is asked to keep, and so is the right answer.
double skin_of(const SessionSettings& settings) {
  return std::min(tolerance::kSkin, tolerance::kSkinForce / settings.stiffness);
}

double angle_about_z(const Quaternion& q) { return 2.0 * std::atan2(q.z(), q.w()); }

// What stays behind the hand by no more than a reach.
class Play {
 public:
  /// The hand is at `hand`: where what is held stays.
  Vector3 follow(const Vector3& hand, double reach) {
    const Vector3 stretch = hand - held_;
    const double length = stretch.norm();
    if (!started_ || reach <= 0.0)
      held_ = hand;
    else if (length > reach)
      held_ = hand - reach / length * stretch;
    started_ = true;
    return held_;
  }

 private:
  Vector3 held_ = Vector3::Zero();
  bool started_ = false;
};

struct Balance {
  double normal_force = 0.0;        // N
  Vector3 force = Vector3::Zero();  // N
  Vector3 theta = Vector3::Zero();  // rad, by which the contact turns the tool
};

// Force and torque at a contact point, at the pose that they turn the tool to.
Balance balance(const Pose& X_WCm, const Vector3& p_Cm, const Vector3& rub, const SessionSettings& settings,
                const Vector3& theta_guess) {
  constexpr int kIterations = 400;
  constexpr double kRelaxation = 0.5, kSettled = 1e-13;  // rad
  const double k = settings.stiffness, l2 = settings.metric_length * settings.metric_length;
  Balance result;
  result.theta = theta_guess;
  for (int i = 0; i < kIterations; ++i) {
    const Vector3 r = rotation_from_vector(result.theta) * (X_WCm.q * p_Cm);
    result.normal_force = std::max(0.0, k * (skin_of(settings) - X_WCm.p.z() - r.z()));
    result.force = result.normal_force * (Vector3::UnitZ() + rub);
    const Vector3 change = r.cross(result.force) / (k * l2) - result.theta;
    result.theta += kRelaxation * change;
    if (change.norm() < kSettled) break;
  }
  return result;
}

// The direction in which the hand drags, and how far it has gone since it last turned around.
class Drag {
 public:
  void follow(const Vector3& p_W, bool touches) {
    Vector3 way = p_W - before_;
    way.z() = 0.0;
    before_ = p_W;
    const double length = way.norm();
    if (!touches) path_ = 0.0;
    if (!touches || length < 1e-12) return;
    if (direction_.dot(way) <= 0.0) path_ = 0.0;
    direction_ = way / length;
    path_ += length;
  }

  const Vector3& direction() const { return direction_; }
  double path() const { return path_; }

 private:
  Vector3 before_ = Vector3::Zero(), direction_ = Vector3::Zero();
  double path_ = 0.0;
};

}  // namespace

Reference flat_face_reference(double friction, double mean_distance) {
  return [=](const ReferenceTask& task, const Progress&) {
    const double k = task.settings.stiffness, l2 = task.settings.metric_length * task.settings.metric_length;
    Play place, turn;
    std::vector<ReferenceSample> samples;
    for (const Pose& X_WT : task.X_WT) {
      const double lowest = X_WT.p.z() + lowest_height(task.scene.tool, X_WT.q, Vector3::UnitZ());
      const double N = std::max(0.0, k * (skin_of(task.settings) - lowest));
      const Vector3 hand(X_WT.p.x(), X_WT.p.y(), 0.0), angle(0.0, 0.0, angle_about_z(X_WT.q));
      ReferenceSample sample;
      sample.touches = N > 0.0;
      sample.wrench.force = k * (place.follow(hand, friction * N / k) - hand) + N * Vector3::UnitZ();
      sample.wrench.torque = k * l2 * (turn.follow(angle, friction * N * mean_distance / (k * l2)) - angle);
      samples.push_back(sample);
    }
    return samples;
  };
}

Reference dragged_point_reference(const Vector3& p_T, double friction) {
  return [=](const ReferenceTask& task, const Progress&) {
    // As many lengths of the elastic stretch as it takes until what was before is forgotten.
    constexpr double kForgotten = 8.0;
    const double k = task.settings.stiffness, l2 = task.settings.metric_length * task.settings.metric_length;
    const Vector3 p_TCm = task.scene.tool.mass.centre_of_mass, p_Cm = p_T - p_TCm;
    const double compliance = (1.0 + p_Cm.squaredNorm() / l2) / k;  // m/N, at the point
    Drag drag;
    Balance found;
    std::vector<ReferenceSample> samples;
    for (const Pose& X_WT : task.X_WT) {
      const Pose X_WCm{X_WT * p_TCm, X_WT.q};
      ReferenceSample sample;
      sample.touches = (X_WT * p_T).z() < skin_of(task.settings);
      drag.follow(X_WT.p, sample.touches);
      found = balance(X_WCm, p_Cm, -friction * drag.direction(), task.settings, found.theta);
      sample.defined = !sample.touches || drag.path() > kForgotten * friction * found.normal_force * compliance;
      sample.wrench.force = found.force;
      sample.wrench.torque = k * l2 * found.theta;
      samples.push_back(sample);
    }
    return samples;
  };
}

}  // namespace tegotae
