// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/contact/placed_shape.hpp>

#include <vector>

namespace tegotae {

/// Axes in which two facing surfaces are laid over each other: x and y across, h along the direction of projection.
struct OverlayFrame {
  Vector3 origin_W = Vector3::Zero();  ///< m
  Vector3 x_W = Vector3::UnitX();      ///< unit
  Vector3 y_W = Vector3::UnitY();      ///< unit
  Vector3 n_W = Vector3::UnitZ();      ///< unit, from the object to the tool

  OverlayFrame(const Vector3& origin, const Vector3& n) noexcept;
};

/// Which side of the gap a surface is on. Its height is measured towards the other: along n for the object, against n
/// for the tool. So both are concave functions over their outlines, and the gap at a place is minus the sum of heights.
enum class GapSide { kTool, kObject };

/// The part of one shape's surface that the other one can meet: what can be seen along n of the `depth` (m) nearest to
/// the other shape. Vertices, edges and faces of that part, in the axes of an OverlayFrame.
///
/// Polytopes are walked from the support vertex outward over their edges, so only what lies in that depth is touched.
/// Curved shapes: of a sphere or an ellipsoid there is only the point nearest to the other; of a capsule the line of
/// points nearest to it; of a cylinder likewise that line, and the cap that faces the other as the regular polygon
/// inscribed in its circle, with a corner where the cap is nearest, which leaves out up to kCapError of its radius.
/// Construction allocates for polytopes of so many vertices; `fill` does not. What does not fit is left out and
/// counted.
class FacingSurface {
 public:
  struct Vertex {
    double x = 0.0, y = 0.0, h = 0.0;  ///< m
    int feature = 0;                   ///< index in the shape
    bool faces = false;                ///< on a part that can be seen (else the far end of an edge or hidden)
    double radius = 0.0;               ///< of the ball that is swept along the line it ends, m; 0: sharp
  };
  struct Edge {
    double x = 0.0, y = 0.0, h = 0.0;     ///< of one end, m
    double dx = 0.0, dy = 0.0, dh = 0.0;  ///< from there to the other, m
    double length2 = 0.0;                 ///< square of its length seen along the direction of projection, m^2
    int feature = 0;
    double radius = 0.0;  ///< of the ball that is swept along it, m; 0: sharp
  };
  /// h <= h0 + gx x + gy y over the whole outline, equal on the face.
  struct Face {
    double h0 = 0.0, gx = 0.0, gy = 0.0;
  };
  /// A side of the outline: nx x + ny y <= c inside; (nx, ny) unit.
  struct Rim {
    double nx = 0.0, ny = 0.0, c = 0.0;
  };

  static constexpr int kCapCorners = 32;
  static constexpr double kCapError = 0.0048;  ///< 1 - cos(pi / 32)

  explicit FacingSurface(int max_vertices);

  /// Where all of a polytope's part lies over the inside of a single face of `other` (filled before; null: not known),
  /// only vertices are filled: nothing else can matter, and on fine hulls there is six times as much of it.
  /// `p_W_nearest` is the shape's point of the closest pair; `hint` where hill climbing starts (any vertex).
  void fill(const PlacedShape& placed, const OverlayFrame& frame, GapSide side, const Vector3& p_W_nearest,
            double depth, int hint, const FacingSurface* other = nullptr) noexcept;

  /// Height of the surface at (x, y); false outside its outline, or where the surface is only points and lines. Below
  /// the depth it was filled with it may be too high.
  bool height_at(double x, double y, double& h) const noexcept;

  const std::vector<Vertex>& vertices() const noexcept { return vertices_; }
  const std::vector<Edge>& edges() const noexcept { return edges_; }
  const std::vector<Face>& faces() const noexcept { return faces_; }
  bool has_ridge() const noexcept { return has_ridge_; }  ///< an edge with a radius
  const std::vector<Rim>& rims() const noexcept { return rims_; }
  int dropped() const noexcept { return dropped_; }

 private:
  struct Axes;

  void fill_polytope(const Polytope& polytope, const Axes& axes, double depth, int hint,
                     const FacingSurface* other) noexcept;
  bool is_one_face_over(const std::vector<Vertex>& places) const noexcept;
  void fill_capsule(const Shape& shape, const Axes& axes, double depth) noexcept;
  void fill_cylinder(const Shape& shape, const Axes& axes, double depth) noexcept;
  void fill_cap(const Shape& shape, const Axes& axes, double lowest) noexcept;
  void walk(const Polytope& polytope, const Axes& axes, double lowest, int start) noexcept;
  void visit_edge(const Polytope& polytope, const Axes& axes, double lowest, int edge) noexcept;
  void add_face(const Vector3& normal, double offset, double rise, const Axes& axes) noexcept;
  void add_edge(const Vertex& a, const Vertex& b, int feature) noexcept;
  void add_ridge(double radius, int feature) noexcept;
  void add_rim(const Vertex& a, const Vertex& b, double x_inside, double y_inside) noexcept;
  int local_vertex(const Polytope& polytope, const Axes& axes, double lowest, int vertex) noexcept;

  std::vector<Vertex> vertices_;
  std::vector<Edge> edges_;
  std::vector<Face> faces_;
  std::vector<Rim> rims_;
  std::vector<int> pending_;  ///< local vertices still to be walked from
  int dropped_ = 0;
  bool has_ridge_ = false;

  // Marks of the walk: valid where the stamp is this fill's.
  struct Mark {
    unsigned stamp = 0;
    int local = 0;
  };
  unsigned stamp_ = 0;
  std::vector<Mark> vertex_marks_, edge_marks_, face_marks_;
};

}  // namespace tegotae
