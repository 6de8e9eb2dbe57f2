// SPDX-License-Identifier: Apache-2.0
#include <tegotae/contact/dual_hull.hpp>
#include <tegotae/contact/interior_point.hpp>
#include <tegotae/contact/intersection.hpp>
#include <tegotae/contact/intersection_frame.hpp>

#include <Eigen/QR>

#include <algorithm>

namespace tegotae {
namespace {

// The half-space n.p <= d, in the object's axes about the origin of the dual transform.
struct HalfSpace {
  Vector3 n;
  double d;
};

bool is_valid(const PlacedShape& tool, const PlacedShape& object, const Vector3& dilation_W) {
  return tool.shape != nullptr && object.shape != nullptr && tool.shape->is_bounded() &&
         IntersectionFrame(tool, object, dilation_W).is_finite();
}

std::vector<HalfSpace> half_spaces(const PlacedShape& tool, const PlacedShape& object, const IntersectionFrame& frame,
                                   const Vector3& origin_O) {
  std::vector<HalfSpace> result;
  if (object.shape->polytope == nullptr) {
    result.push_back({Vector3::UnitZ(), frame.shift(Vector3::UnitZ()) - origin_O.z()});
  } else {
    for (const auto& face : object.shape->polytope->faces) {
      result.push_back({face.normal, face.offset + frame.shift(face.normal) - face.normal.dot(origin_O)});
    }
  }
  const Vector3 origin_T = frame.tool_from_object(origin_O);
  for (const auto& face : tool.shape->polytope->faces) {
    result.push_back({frame.R_OT * face.normal, face.offset - face.normal.dot(origin_T)});
  }
  return result;
}

// The point where all of the facet's planes meet, in the sense of least squares.
Vector3 meeting_point(const std::vector<HalfSpace>& planes, const std::vector<int>& facet) {
  Eigen::Matrix<double, Eigen::Dynamic, 3> normals(static_cast<Eigen::Index>(facet.size()), 3);
  Eigen::VectorXd offsets(normals.rows());
  for (Eigen::Index k = 0; k < normals.rows(); ++k) {
    const HalfSpace& plane = planes[static_cast<size_t>(facet[static_cast<size_t>(k)])];
    normals.row(k) = plane.n.transpose();
    offsets(k) = plane.d;
  }
  return normals.colPivHouseholderQr().solve(offsets);
}

// Points of which any two are further apart than kSameVertex.
std::vector<Vector3> without_duplicates(const std::vector<Vector3>& points) {
  std::vector<size_t> order(points.size());
  for (size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::sort(order.begin(), order.end(), [&](size_t a, size_t b) { return points[a].x() < points[b].x(); });
  std::vector<Vector3> unique;
  for (const size_t i : order) {
    bool known = false;
    for (auto it = unique.rbegin(); it != unique.rend() && it->x() >= points[i].x() - tolerances::kSameVertex; ++it) {
      known = known || (*it - points[i]).norm() <= tolerances::kSameVertex;
    }
    if (!known) unique.push_back(points[i]);
  }
  return unique;
}

}  // namespace

bool intersection_by_duality(const PlacedShape& tool, const PlacedShape& object, const Vector3& dilation_W,
                             const Vector3& origin_W, std::vector<IntersectionVertex>& vertices) {
  if (!is_valid(tool, object, dilation_W) || !origin_W.allFinite()) return false;
  const IntersectionFrame frame(tool, object, dilation_W);
  const Vector3 origin_O = frame.object_from_world(origin_W);
  const std::vector<HalfSpace> planes = half_spaces(tool, object, frame, origin_O);
  std::vector<Vector3> dual_points;
  for (const HalfSpace& plane : planes) {
    if (!(plane.d > tolerances::kOnPlane)) return false;
    dual_points.emplace_back(plane.n / plane.d);
  }
  const auto facets = hull_facets(dual_points);
  if (!facets) return false;
  std::vector<Vector3> points;
  for (const auto& facet : *facets) points.push_back(meeting_point(planes, facet));
  for (const Vector3& p : without_duplicates(points)) vertices.push_back({frame.world(p + origin_O), 0});
  return true;
}

bool intersection_by_duality(const PlacedShape& tool, const PlacedShape& object, const Vector3& dilation_W,
                             std::vector<IntersectionVertex>& vertices) {
  const InteriorPoint interior = interior_point(tool, object, dilation_W);
  return interior.exists && intersection_by_duality(tool, object, dilation_W, interior.p_W, vertices);
}

}  // namespace tegotae
