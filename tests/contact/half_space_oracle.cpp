// SPDX-License-Identifier: Apache-2.0
#include <tests/contact/half_space_oracle.hpp>

extern "C" {
#include <libqhull_r/qhull_ra.h>
}

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>

namespace tegotae::test {
namespace {

void append(std::vector<OracleHalfSpace>& half_spaces, const PlacedShape& placed, const Vector3& dilation_W) {
  const auto add = [&](const Vector3& n_S, double offset) {
    const Vector3 n_W = placed.R_WS * n_S;
    half_spaces.push_back({n_W, offset + std::max(0.0, n_W.dot(dilation_W)) + n_W.dot(placed.p_WS)});
  };
  if (!placed.shape->is_bounded()) {
    add(Vector3::UnitZ(), 0.0);
  } else {
    for (const auto& face : placed.shape->polytope->faces) add(face.normal, face.offset);
  }
}

double one_way_distance(const std::vector<Vector3>& from, const std::vector<Vector3>& to) {
  double greatest = 0.0;
  for (const Vector3& p : from) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Vector3& q : to) nearest = std::min(nearest, (p - q).norm());
    greatest = std::max(greatest, nearest);
  }
  return greatest;
}

}  // namespace

std::vector<OracleHalfSpace> half_spaces_of(const PlacedShape& tool, const PlacedShape& object,
                                            const Vector3& dilation_W) {
  std::vector<OracleHalfSpace> result;
  append(result, tool, Vector3::Zero());
  append(result, object, dilation_W);
  return result;
}

std::optional<std::vector<Vector3>> vertices_by_qhull(const std::vector<OracleHalfSpace>& half_spaces,
                                                      const Vector3& inside) {
  std::vector<double> rows;
  for (const auto& h : half_spaces) {
    rows.insert(rows.end(), {h.normal.x(), h.normal.y(), h.normal.z(), h.normal.dot(inside) - h.offset});
  }
  std::string options = "qhull H0,0,0 Pp";
  qhT state;
  qhT* const qh = &state;
  qh_zero(qh, nullptr);
  std::FILE* const nowhere = std::fopen("/dev/null", "w");
  const int error =
      qh_new_qhull(qh, 4, static_cast<int>(half_spaces.size()), rows.data(), False, options.data(), nullptr, nowhere);
  std::vector<Vector3> points;
  if (error == 0) {
    facetT* facet = nullptr;
    FORALLfacets {
      points.emplace_back(-facet->normal[0] / facet->offset, -facet->normal[1] / facet->offset,
                          -facet->normal[2] / facet->offset);
      points.back() += inside;
    }
  }
  qh_freeqhull(qh, !qh_ALL);
  int short_memory = 0, total = 0;
  qh_memfreeshort(qh, &short_memory, &total);
  std::fclose(nowhere);
  if (error != 0) return std::nullopt;
  return points;
}

std::vector<Vector3> vertices_by_triples(const std::vector<OracleHalfSpace>& half_spaces, double tolerance) {
  std::vector<Vector3> points;
  const size_t n = half_spaces.size();
  for (size_t i = 0; i < n; ++i) {
    for (size_t j = i + 1; j < n; ++j) {
      const Vector3 ij = half_spaces[i].normal.cross(half_spaces[j].normal);
      if (ij.norm() < 1e-9) continue;
      for (size_t k = j + 1; k < n; ++k) {
        const double volume = ij.dot(half_spaces[k].normal);
        if (std::abs(volume) < 1e-9) continue;
        const Vector3 p =
            (half_spaces[i].offset * half_spaces[j].normal.cross(half_spaces[k].normal) +
             half_spaces[j].offset * half_spaces[k].normal.cross(half_spaces[i].normal) + half_spaces[k].offset * ij) /
            volume;
        if (least_slack(half_spaces, p) >= -tolerance) points.push_back(p);
      }
    }
  }
  return points;
}

double least_slack(const std::vector<OracleHalfSpace>& half_spaces, const Vector3& p) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& h : half_spaces) least = std::min(least, h.offset - h.normal.dot(p));
  return least;
}

std::vector<Vector3> merged(const std::vector<Vector3>& points, double distance) {
  std::vector<Vector3> result;
  for (const Vector3& p : points) {
    const bool known =
        std::any_of(result.begin(), result.end(), [&](const Vector3& q) { return (p - q).norm() <= distance; });
    if (!known) result.push_back(p);
  }
  return result;
}

double set_distance(const std::vector<Vector3>& a, const std::vector<Vector3>& b) {
  if (a.size() != b.size()) return std::numeric_limits<double>::infinity();
  return std::max(one_way_distance(a, b), one_way_distance(b, a));
}

double least_spacing(const std::vector<Vector3>& points) {
  double least = std::numeric_limits<double>::infinity();
  for (size_t i = 0; i < points.size(); ++i) {
    for (size_t j = 0; j < i; ++j) least = std::min(least, (points[i] - points[j]).norm());
  }
  return least;
}

}  // namespace tegotae::test
