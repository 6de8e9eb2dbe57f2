// SPDX-License-Identifier: Apache-2.0
#include <tegotae/shape/hull_triangles.hpp>

extern "C" {
#include <libqhull_r/qhull_ra.h>
}

#include <cstdio>
#include <stdexcept>

namespace tegotae {
namespace {

// Owns Qhull's state, so that an exception frees it too.
class QhullRun {
 public:
  explicit QhullRun(std::vector<double>& coordinates) {
    qh_zero(&qh_, nullptr);
    // Qhull writes its complaints to a FILE; ours is the exit code.
    std::FILE* nowhere = std::fopen("/dev/null", "w");
    char options[] = "qhull Qt Pp";
    exit_code_ = qh_new_qhull(&qh_, 3, static_cast<int>(coordinates.size() / 3), coordinates.data(), False, options,
                              nullptr, nowhere);
    if (nowhere != nullptr) std::fclose(nowhere);
  }
  QhullRun(const QhullRun&) = delete;
  QhullRun& operator=(const QhullRun&) = delete;
  ~QhullRun() {
    qh_freeqhull(&qh_, qh_ALL);
    int short_memory = 0, total = 0;
    qh_memfreeshort(&qh_, &short_memory, &total);
  }

  bool succeeded() const { return exit_code_ == 0; }
  qhT* state() { return &qh_; }

 private:
  qhT qh_{};
  int exit_code_ = 0;
};

HullTriangle read_triangle(qhT* qh, facetT* facet) {
  HullTriangle triangle;
  setT* ordered = qh_facet3vertex(qh, facet);
  for (size_t k = 0; k < 3; ++k) {
    const auto* vertex = static_cast<vertexT*>(SETelem_(ordered, static_cast<int>(k)));
    // Qhull's order is clockwise seen from outside.
    triangle.vertex[2 - k] = qh_pointid(qh, vertex->point);
  }
  qh_settempfree(qh, &ordered);
  triangle.normal = Vector3(facet->normal[0], facet->normal[1], facet->normal[2]);
  return triangle;
}

}  // namespace

std::vector<HullTriangle> hull_triangles(std::span<const Vector3> points) {
  std::vector<double> coordinates;
  coordinates.reserve(3 * points.size());
  for (const Vector3& p : points) {
    if (!p.allFinite()) throw std::invalid_argument("a point of a convex hull is not finite");
    coordinates.insert(coordinates.end(), {p.x(), p.y(), p.z()});
  }
  if (points.size() < 4) throw std::invalid_argument("a convex hull needs at least four points");
  QhullRun run(coordinates);
  if (!run.succeeded()) throw std::invalid_argument("the points of a convex hull do not span a volume");
  std::vector<HullTriangle> triangles;
  for (facetT* facet = run.state()->facet_list; facet != nullptr && facet->next != nullptr; facet = facet->next) {
    triangles.push_back(read_triangle(run.state(), facet));
  }
  return triangles;
}

}  // namespace tegotae
