// SPDX-License-Identifier: Apache-2.0
#include <tegotae/contact/dual_hull.hpp>

extern "C" {
#include <libqhull_r/qhull_ra.h>
}

#include <cstdio>

namespace tegotae {
namespace {

// Qhull's state, freed at the end of its scope.
class QhullState {
 public:
  QhullState() { qh_zero(&qh_, nullptr); }
  QhullState(const QhullState&) = delete;
  QhullState& operator=(const QhullState&) = delete;
  ~QhullState() {
    qh_freeqhull(&qh_, !qh_ALL);
    int short_memory = 0, total = 0;
    qh_memfreeshort(&qh_, &short_memory, &total);
  }
  qhT* get() { return &qh_; }

 private:
  qhT qh_{};
};

// Where Qhull's messages go.
class Nowhere {
 public:
  Nowhere() : file_(std::fopen("/dev/null", "w")) {}
  Nowhere(const Nowhere&) = delete;
  Nowhere& operator=(const Nowhere&) = delete;
  ~Nowhere() {
    if (file_ != nullptr) std::fclose(file_);
  }
  std::FILE* get() { return file_; }

 private:
  std::FILE* file_;
};

}  // namespace

std::optional<std::vector<std::vector<int>>> hull_facets(std::span<const Vector3> points) {
  // Given no points, Qhull would succeed without a facet.
  if (points.size() < 4) return std::nullopt;
  std::vector<double> coordinates;
  coordinates.reserve(3 * points.size());
  for (const Vector3& p : points) {
    if (!p.allFinite()) return std::nullopt;
    coordinates.insert(coordinates.end(), p.data(), p.data() + 3);
  }
  Nowhere nowhere;
  QhullState state;
  qhT* const qh = state.get();
  char options[] = "qhull Pp";
  if (nowhere.get() == nullptr || qh_new_qhull(qh, 3, static_cast<int>(points.size()), coordinates.data(), False,
                                               options, nullptr, nowhere.get()) != 0) {
    return std::nullopt;
  }
  std::vector<std::vector<int>> facets;
  facetT* facet = nullptr;
  FORALLfacets {
    std::vector<int>& members = facets.emplace_back();
    vertexT *vertex = nullptr, **vertexp = nullptr;
    FOREACHvertex_(facet->vertices) members.push_back(qh_pointid(qh, vertex->point));
  }
  return facets;
}

}  // namespace tegotae
