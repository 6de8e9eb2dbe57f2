// SPDX-License-Identifier: Apache-2.0
#include <tegotae/contact/intersection.hpp>
#include <tegotae/contact/intersection_clipper.hpp>

#include <algorithm>

namespace tegotae {

int intersection_by_clipping(const PlacedShape& tool, const PlacedShape& object, const Vector3& dilation_W,
                             ClipWorkspace& workspace, std::span<IntersectionVertex> vertices) noexcept {
  if (tool.shape == nullptr || object.shape == nullptr || !tool.shape->is_bounded()) return 0;
  const IntersectionFrame frame(tool, object, dilation_W);
  if (!frame.is_finite()) return 0;
  if (!workspace.holds(*tool.shape) || !workspace.holds(*object.shape)) return kClipWorkspaceTooSmall;

  const ClipVertexSet& found = IntersectionClipper(tool, object, frame, workspace).run();
  const int written = std::min(found.size(), static_cast<int>(vertices.size()));
  for (int i = 0; i < written; ++i) {
    vertices[static_cast<size_t>(i)] = {frame.world(found[i].p), found[i].feature};
  }
  return found.size();
}

}  // namespace tegotae
