// SPDX-License-Identifier: Apache-2.0
#include <tegotae/model/near_pieces.hpp>

namespace tegotae {
namespace {

constexpr int kNoRoom = -2;

// Index of the body among the model's near bodies, added if it is new; -1 for a static one.
int near_body_of(const Body& body, std::span<const BodyState> states, IntermediateRepresentation& model) noexcept {
  if (body.moving_index < 0) return -1;
  for (int i = 0; i < model.body_count; ++i) {
    if (model.bodies[static_cast<size_t>(i)].moving_index == body.moving_index) return i;
  }
  if (model.body_count == kMaxNearBodies) return kNoRoom;
  const BodyState& state = states[static_cast<size_t>(body.moving_index)];
  model.bodies[static_cast<size_t>(model.body_count)] = {body.moving_index,      state.X_WB, state.V_WB,
                                                         state.X_WB * body.p_BC, body.mass,  body.gyration_length};
  return model.body_count++;
}

}  // namespace

void name_near_pieces(const SceneGeometry& geometry, std::span<const NearPair> pairs, std::span<const BodyState> states,
                      IntermediateRepresentation& model) noexcept {
  model.pair_count = model.body_count = model.dropped_pairs = 0;
  for (const NearPair& pair : pairs) {
    const Body& body = geometry.bodies[static_cast<size_t>(pair.body)];
    const int near_body = model.pair_count < kMaxNearPieces ? near_body_of(body, states, model) : kNoRoom;
    if (near_body == kNoRoom) {
      ++model.dropped_pairs;
      continue;
    }
    const Pose X_WB = near_body < 0 ? body.X_WB : model.bodies[static_cast<size_t>(near_body)].X_WB.pose();
    model.pairs[static_cast<size_t>(model.pair_count++)] = {
        pair.tool_piece, pair.body, pair.body_piece, near_body, pair.distance, X_WB.q.conjugate() * pair.n_W};
  }
}

}  // namespace tegotae
