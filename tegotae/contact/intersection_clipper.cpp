// SPDX-License-Identifier: Apache-2.0
#include <tegotae/contact/intersection_clipper.hpp>

#include <algorithm>

namespace tegotae {
namespace {

// Looking at so few planes is faster than walking.
constexpr size_t kFewPlanes = 24;

}  // namespace

IntersectionClipper::IntersectionClipper(const PlacedShape& tool, const PlacedShape& object,
                                         const IntersectionFrame& frame, ClipWorkspace& workspace) noexcept
    : frame_(frame), memory_(workspace) {
  tool_.polytope = tool.shape->polytope.get();
  object_.polytope = object.shape->polytope.get();
}

const ClipVertexSet& IntersectionClipper::run() noexcept {
  memory_.vertices_.clear();
  collect();
  return memory_.vertices_;
}

void IntersectionClipper::collect() noexcept {
  if (!list_object_planes()) return;
  if (!place_tool()) return;
  add_tool_vertices();
  if (object_.polytope == nullptr) return add_tool_edges();
  memory_.dilation_.apply(*object_.polytope, frame_.dilation_O);
  list_tool_planes();
  const bool object_reaches_tool = place_object();
  if (object_reaches_tool) add_object_vertices();
  add_tool_edges();
  if (object_reaches_tool) add_object_edges();
  if (!memory_.dilation_.intact()) add_broken_faces();
}

// Lists the planes that cut the tool's ball, unless walking is better. False if the ball lies outside one of them.
bool IntersectionClipper::list_object_planes() noexcept {
  std::vector<ClipPlane>& planes = memory_.object_planes_;
  if (object_.polytope == nullptr) {
    planes[0] = {Vector3::UnitZ(), frame_.shift(Vector3::UnitZ()), 0};
    object_.planes = {planes.data(), 1};
    return true;
  }
  const std::vector<Polytope::Face>& faces = object_.polytope->faces;
  if (faces.size() > kFewPlanes && frame_.dilation_O == Vector3::Zero()) return true;
  const double radius = tool_.polytope->radius;
  size_t count = 0;
  for (size_t f = 0; f < faces.size(); ++f) {
    const double offset = faces[f].offset + frame_.shift(faces[f].normal);
    const double distance = faces[f].normal.dot(frame_.p_OT) - offset;
    if (distance - radius > tolerances::kOnPlane) return false;
    if (distance + radius >= -tolerances::kOnPlane) planes[count++] = {faces[f].normal, offset, static_cast<int>(f)};
  }
  // At least one, so that every query has an answer.
  if (count == 0) planes[count++] = {faces[0].normal, faces[0].offset + frame_.shift(faces[0].normal), 0};
  object_.planes = {planes.data(), count};
  return true;
}

void IntersectionClipper::list_tool_planes() noexcept {
  const std::vector<Polytope::Face>& faces = tool_.polytope->faces;
  if (faces.size() > kFewPlanes) return;
  std::vector<ClipPlane>& planes = memory_.tool_planes_;
  for (size_t f = 0; f < faces.size(); ++f) planes[f] = {faces[f].normal, faces[f].offset, static_cast<int>(f)};
  tool_.planes = {planes.data(), faces.size()};
}

template <class Function>
void IntersectionClipper::with_locator(const Body& body, const Function& function) noexcept {
  if (body.planes.empty()) {
    function(FaceWalk(*body.polytope));
  } else {
    function(PlaneScan(body.planes));
  }
}

// False if all vertices lie beyond one plane of the object.
bool IntersectionClipper::place_tool() noexcept {
  const std::vector<Vector3>& vertices = tool_.polytope->vertices;
  for (size_t i = 0; i < vertices.size(); ++i) memory_.tool_.points()[i] = frame_.object_from_tool(vertices[i]);
  return classify(object_, *tool_.polytope, memory_.tool_);
}

bool IntersectionClipper::place_object() noexcept {
  for (size_t i = 0; i < object_.polytope->vertices.size(); ++i) {
    memory_.object_.points()[i] = frame_.tool_from_object(memory_.dilation_.point(i));
  }
  return classify(tool_, *object_.polytope, memory_.object_);
}

bool IntersectionClipper::classify(const Body& body, const Polytope& polytope, ClipSide& side) noexcept {
  if (!body.planes.empty() && body.planes.size() <= ClipSide::kMaskBits) {
    return side.classify(body.planes, polytope.vertices.size());
  }
  with_locator(body, [&](const auto& locator) { side.classify(locator, polytope); });
  return true;
}

void IntersectionClipper::add_tool_vertices() noexcept {
  for (size_t i = 0; i < tool_.polytope->vertices.size(); ++i) {
    if (!memory_.tool_.is_inside(i)) continue;
    memory_.vertices_.add_new(memory_.tool_.point(i), {IntersectionVertexKind::kToolVertex, static_cast<int>(i)});
  }
}

void IntersectionClipper::add_object_vertices() noexcept {
  for (size_t i = 0; i < object_.polytope->vertices.size(); ++i) {
    if (!memory_.object_.is_inside(i) || !memory_.dilation_.has_vertex(i)) continue;
    memory_.vertices_.add(memory_.dilation_.point(i), {IntersectionVertexKind::kObjectVertex, static_cast<int>(i)});
  }
}

void IntersectionClipper::add_tool_edges() noexcept {
  const ClipSide& side = memory_.tool_;
  const auto add = [&](int edge, size_t from, size_t to, const ClipEntry& entry) {
    memory_.vertices_.add(side.point(from) + entry.t * (side.point(to) - side.point(from)),
                          {IntersectionVertexKind::kToolEdgeObjectFace, edge, entry.face});
  };
  with_locator(object_, [&](const auto& locator) { side.clip_edges(locator, *tool_.polytope, add); });
}

void IntersectionClipper::add_object_edges() noexcept {
  const ClipDilation& dilated = memory_.dilation_;
  const auto add = [&](int edge, size_t from, size_t to, const ClipEntry& entry) {
    if (!dilated.has_vertex(from) || !dilated.has_vertex(to)) return;
    const int* const faces = object_.polytope->edges[static_cast<size_t>(edge)].face;
    memory_.vertices_.add(dilated.point(from) + entry.t * (dilated.point(to) - dilated.point(from)),
                          {IntersectionVertexKind::kObjectEdgeToolFace, std::min(faces[0], faces[1]),
                           std::max(faces[0], faces[1]), entry.face});
  };
  with_locator(tool_, [&](const auto& locator) { memory_.object_.clip_edges(locator, *object_.polytope, add); });
}

// Where dilation may change which faces meet, each dilated face's part inside the tool is cut out as a polygon.
void IntersectionClipper::add_broken_faces() noexcept {
  for (const ClipPlane& plane : object_.planes) {
    if (!memory_.dilation_.is_broken(plane.face)) continue;
    cut_face_polygon(plane);
    add_corners(plane.face);
  }
}

void IntersectionClipper::cut_face_polygon(const ClipPlane& plane) noexcept {
  const std::vector<Polytope::Face>& faces = object_.polytope->faces;
  ClipPolygon& polygon = memory_.polygon_;
  // The square covers the tool's ball. The faces that were neighbours cut off most, the tool most of the rest.
  const double height = plane.normal.dot(frame_.p_OT) - plane.offset;
  polygon.start(frame_.p_OT - height * plane.normal, plane.normal, 1.01 * tool_.polytope->radius);
  for (const int f : object_.polytope->neighbors_of(faces[static_cast<size_t>(plane.face)])) {
    const Polytope::Face& face = faces[static_cast<size_t>(f)];
    polygon.cut(face.normal, face.offset + frame_.shift(face.normal), f);
  }
  cut_by_tool();
  for (const ClipPlane& other : object_.planes) {
    if (polygon.size() == 0) return;
    if (other.face != plane.face) polygon.cut(other.normal, other.offset, other.face);
  }
}

// Labels of sides: the object's faces 0, 1, ..., the tool's -2, -3, ...
void IntersectionClipper::cut_by_tool() noexcept {
  ClipPolygon& polygon = memory_.polygon_;
  const FaceWalk walk(*tool_.polytope);
  int hint = 0;
  // Every cut takes off the corner that asked for it; no face is asked for twice.
  int remaining = static_cast<int>(tool_.polytope->faces.size());
  for (int i = 0; i < polygon.size() && remaining > 0;) {
    const Located worst = walk.locate(frame_.tool_from_object(polygon[i].p), hint);
    hint = worst.plane;
    if (worst.slack <= tolerances::kOnPlane) {
      ++i;
      continue;
    }
    const Polytope::Face& face = tool_.polytope->faces[static_cast<size_t>(worst.plane)];
    const Vector3 n_O = frame_.R_OT * face.normal;
    polygon.cut(n_O, face.offset + n_O.dot(frame_.p_OT), -2 - worst.plane);
    --remaining;
    i = 0;
  }
}

void IntersectionClipper::add_corners(int face) noexcept {
  const ClipPolygon& polygon = memory_.polygon_;
  for (int i = 0; i < polygon.size(); ++i) {
    const int before = std::min(polygon.side_before(i), polygon[i].side);
    const int after = std::max(polygon.side_before(i), polygon[i].side);
    // Where two of the tool's faces meet, its edge has been cut already.
    if (after < 0 || before == ClipPolygon::kNoLabel) continue;
    if (before < 0) {
      memory_.vertices_.add(polygon[i].p, {IntersectionVertexKind::kObjectEdgeToolFace, std::min(face, after),
                                           std::max(face, after), -2 - before});
    } else {
      int corner[3] = {face, before, after};
      std::sort(corner, corner + 3);
      memory_.vertices_.add(polygon[i].p, {IntersectionVertexKind::kObjectCorner, corner[0], corner[1], corner[2]});
    }
  }
}

}  // namespace tegotae
