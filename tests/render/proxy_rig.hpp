// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/math/rotation.hpp>
#include <tegotae/render/proxy_method.hpp>

#include <memory>
#include <vector>

namespace tegotae::test {

/// A proxy method on a scene made by hand, driven without physics: all pairs of pieces are always named as near.
class ProxyRig {
 public:
  static constexpr double kStiffness = 9000.0;  // N/m
  static constexpr double kPeriod = 1e-3;       // s

  ProxyMethod::Parameters parameters;
  SceneGeometry scene;
  RenderOutput output;

  explicit ProxyRig(std::vector<Shape> tool_pieces) {
    scene.tool.pieces = std::move(tool_pieces);
    std::vector<MassProperties> parts;
    for (const Shape& piece : scene.tool.pieces) parts.push_back(mass_properties(piece, 1000.0));
    scene.tool.mass = combined(parts);
    parameters.coupling = {kStiffness, 0.0, scene.tool.mass.gyration_length()};
    parameters.friction = 0.0;
  }

  /// Returns the body's index.
  int add_body(const Shape& shape, const Pose& X_WB = {}, bool moves = false) {
    return add_body(std::vector<Shape>{shape}, X_WB, moves);
  }

  int add_body(std::vector<Shape> pieces, const Pose& X_WB = {}, bool moves = false) {
    Body body;
    body.pieces = std::move(pieces);
    body.X_WB = X_WB;
    if (moves) body.moving_index = scene.moving_count++;
    scene.bodies.push_back(body);
    return static_cast<int>(scene.bodies.size()) - 1;
  }

  double metric_length() const { return parameters.coupling.metric_length; }

  /// Call after all bodies and parameters are set.
  void start() {
    method = std::make_unique<ProxyMethod>(parameters, scene);
    model->sequence = 1;
    model->period = 0.05;
    for (int t = 0; t < static_cast<int>(scene.tool.pieces.size()); ++t) {
      for (int b = 0; b < static_cast<int>(scene.bodies.size()); ++b) name_pieces(t, b);
    }
  }

  /// One tick with the interface at `X_WT`. Returns the wrench on the interface.
  const Wrench& tick(const Pose& X_WT) {
    if (!method) start();
    method->render({*model, X_WT, kPeriod}, output);
    return output.wrench;
  }

  const Wrench& hold(const Pose& X_WT, int ticks) {
    for (int i = 0; i < ticks; ++i) tick(X_WT);
    return output.wrench;
  }

  /// Moves a body that was added as moving.
  void move_body(int body, const Pose& X_WB) {
    if (!method) start();
    const int moving_index = scene.bodies[static_cast<size_t>(body)].moving_index;
    for (int i = 0; i < model->body_count; ++i) {
      NearBody& near = model->bodies[static_cast<size_t>(i)];
      if (near.moving_index == moving_index) near.X_WB = X_WB, near.p_WC = X_WB.p;
    }
  }

  /// Least certified distance between the proxy and the bodies where they were added; negative: depth, by queries that
  /// start cold.
  double clearance() const;

  std::unique_ptr<IntermediateRepresentation> model = std::make_unique<IntermediateRepresentation>();
  std::unique_ptr<ProxyMethod> method;

 private:
  void name_pieces(int tool_piece, int b) {
    const Body& body = scene.bodies[static_cast<size_t>(b)];
    int near_body = -1;
    if (body.moving_index >= 0) {
      near_body = body.moving_index;
      model->bodies[static_cast<size_t>(near_body)] = {near_body, body.X_WB, Twist{}, body.X_WB.p};
      model->body_count = std::max(model->body_count, near_body + 1);
    }
    for (int p = 0; p < static_cast<int>(body.pieces.size()); ++p) {
      model->pairs[static_cast<size_t>(model->pair_count++)] = {tool_piece, b, p, near_body, 0.0};
    }
  }
};

inline double ProxyRig::clearance() const {
  double least = 1e300;
  for (const Shape& tool_piece : scene.tool.pieces) {
    const PlacedShape tool(tool_piece, output.X_WP);
    for (const Body& body : scene.bodies) {
      for (const Shape& piece : body.pieces) {
        ClosestPointsCache cache;
        const ClosestPoints closest = closest_points(tool, PlacedShape(piece, body.X_WB), cache);
        least = std::min(least, closest.separation == Separation::kSeparated ? closest.distance : -1.0);
      }
    }
  }
  return least;
}

inline Pose at(double x, double y, double z) { return {{x, y, z}, Quaternion::Identity()}; }
inline Pose at(const Vector3& p, const Vector3& rotation) { return {p, rotation_from_vector(rotation)}; }

/// Largest change of force (N) and torque (N m) from tick to tick.
struct LargestChange {
  double force = 0.0, torque = 0.0;

  void add(const Wrench& wrench) {
    if (started_) {
      force = std::max(force, (wrench.force - last_.force).norm());
      torque = std::max(torque, (wrench.torque - last_.torque).norm());
    }
    started_ = true;
    last_ = wrench;
  }

 private:
  bool started_ = false;
  Wrench last_;
};

}  // namespace tegotae::test
