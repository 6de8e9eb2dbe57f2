// SPDX-License-Identifier: Apache-2.0
#include <tegotae/render/receding_bodies.hpp>

#include <algorithm>

namespace tegotae {
namespace {

// m/s at which tool and body part along the push: the power on the body less that which the tool gives, by the force. A
// push that is mostly torque counts as a force at the longest arm that the body has.
double receding_speed(const BodyWrench& push, const NearBody& body, const Twist& V_WT, const Vector3& p_WCm) noexcept {
  const Wrench on_body = push.on_body;
  const Wrench about_tool = on_body.shifted(push.p_WC - p_WCm);
  const Twist V_WB = body.V_WB;
  const double received = on_body.force.dot(V_WB.linear) + on_body.torque.dot(V_WB.angular);
  const double given = about_tool.force.dot(V_WT.linear) + about_tool.torque.dot(V_WT.angular);
  const double arm = BodyWrenches::kLongestArm * body.gyration_length;
  const double by_torque = arm > 0.0 ? on_body.torque.norm() / arm : 0.0;
  const double force = std::max(on_body.force.norm(), by_torque);
  return force > 0.0 ? (received - given) / force : 0.0;
}

}  // namespace

void yield_to_receding(std::span<const NearBody> near, const Twist& V_WT, const Vector3& p_WCm,
                       RenderOutput& output) noexcept {
  for (BodyWrench& push : output.bodies.moving()) {
    const auto is_pushed = [&push](const NearBody& body) { return body.moving_index == push.moving_index; };
    const auto body = std::find_if(near.begin(), near.end(), is_pushed);
    if (body == near.end()) continue;
    const double speed = receding_speed(push, *body, V_WT, p_WCm);
    const double kept = std::clamp(1.0 - speed / kRecedingSpeed, 0.0, 1.0);
    if (!(kept < 1.0)) continue;
    const Wrench left_out = push.on_body * (1.0 - kept);
    output.wrench = output.wrench + left_out.shifted(push.p_WC - p_WCm);
    push.on_body = push.on_body * kept;
  }
}

}  // namespace tegotae
