// SPDX-License-Identifier: Apache-2.0
#include <tegotae/world/geom_shape.hpp>

#include <tegotae/world/limits.hpp>
#include <tegotae/world/model_names.hpp>
#include <tegotae/world/model_poses.hpp>
#include <tegotae/world/scene_error.hpp>

#include <fmt/format.h>
#include <mujoco/mujoco.h>

#include <algorithm>
#include <stdexcept>

namespace tegotae {
namespace {

struct Mesh {
  std::vector<Vector3> vertices;  // m, as MuJoCo holds them: about the mesh's centre of mass, along its principal axes
  const int* triangles = nullptr;
  int triangle_count = 0;
};

Mesh mesh_of(const mjModel& m, int id) {
  Mesh mesh;
  const float* v = m.mesh_vert + 3 * static_cast<std::ptrdiff_t>(m.mesh_vertadr[id]);
  for (int i = 0; i < m.mesh_vertnum[id]; ++i, v += 3) {
    mesh.vertices.emplace_back(static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2]));
  }
  mesh.triangles = m.mesh_face + 3 * static_cast<std::ptrdiff_t>(m.mesh_faceadr[id]);
  mesh.triangle_count = m.mesh_facenum[id];
  return mesh;
}

// Depth (m) of the point below the hull's surface; negative outside.
double depth_below_surface(const Polytope& hull, const Vector3& p) {
  double depth = 1e300;
  for (const auto& face : hull.faces) depth = std::min(depth, face.offset - face.normal.dot(p));
  return depth;
}

// Depth of the first dent found, or 0. A triangle whose centre lies on the hull's surface lies in a face of it, so that
// a closed mesh of such triangles is the hull.
double dent_of(const Mesh& mesh, const Polytope& hull) {
  const double unfelt = std::max(world_limits::kUnfeltDent, 2.0 * kSinglePrecisionCoplanarity * hull.radius);
  for (int t = 0; t < mesh.triangle_count; ++t) {
    const int* v = mesh.triangles + 3 * static_cast<std::ptrdiff_t>(t);
    const Vector3 centre = (mesh.vertices[static_cast<size_t>(v[0])] + mesh.vertices[static_cast<size_t>(v[1])] +
                            mesh.vertices[static_cast<size_t>(v[2])]) /
                           3.0;
    const double depth = depth_below_surface(hull, centre);
    if (depth > unfelt) return depth;
  }
  return 0.0;
}

Shape hull_of_geom(const mjModel& m, int geom, const std::string& file, std::vector<std::string>& warnings) {
  const Mesh mesh = mesh_of(m, m.geom_dataid[geom]);
  Shape shape = make_hull(mesh.vertices, pose_from(m.geom_pos, m.geom_quat, geom), kSinglePrecisionCoplanarity);
  const double dent = dent_of(mesh, *shape.polytope);
  if (dent > 0.0) {
    warnings.push_back(
        fmt::format("{}: the mesh of {} is not convex (a face lies {:.3g} m inside its hull) and is used "
                    "as its hull; to keep its shape, split its file with: tegotae split MESH",
                    file, geom_label(m, geom), dent));
  }
  return shape;
}

Shape bare_shape(const mjModel& m, int geom, const std::string& file, std::vector<std::string>& warnings) {
  const Vector3 size = vector_from(m.geom_size, geom);
  const Pose X_BS = pose_from(m.geom_pos, m.geom_quat, geom);
  switch (m.geom_type[geom]) {
    case mjGEOM_PLANE:
      return make_plane(X_BS);
    case mjGEOM_SPHERE:
      return make_sphere(size.x(), X_BS);
    case mjGEOM_CAPSULE:
      return make_capsule(size.x(), size.y(), X_BS);
    case mjGEOM_ELLIPSOID:
      return make_ellipsoid(size, X_BS);
    case mjGEOM_CYLINDER:
      return make_cylinder(size.x(), size.y(), X_BS);
    case mjGEOM_BOX:
      return make_box(size, X_BS);
    case mjGEOM_MESH:
      return hull_of_geom(m, geom, file, warnings);
    case mjGEOM_HFIELD:
      throw std::invalid_argument(
          "height fields cannot be touched by the tool: make it of boxes or convex meshes, or "
          "give it contype=\"0\" conaffinity=\"0\"");
    default:
      throw std::invalid_argument("this kind of geom cannot be touched by the tool: make it of convex shapes");
  }
}

// A material says the colour of its geoms, unless a geom says another of its own: MuJoCo draws it so too, and tells a
// geom without a colour by the value that it gives those.
Colour colour_of_geom(const mjModel& m, int geom) {
  const float* own = m.geom_rgba + 4 * static_cast<std::ptrdiff_t>(geom);
  const bool says_own = std::any_of(own, own + 3, [](float part) { return part != 0.5F; }) || own[3] != 1.0F;
  const int material = m.geom_matid[geom];
  const float* rgba = material >= 0 && !says_own ? m.mat_rgba + 4 * static_cast<std::ptrdiff_t>(material) : own;
  return {rgba[0], rgba[1], rgba[2], rgba[3]};
}

}  // namespace

Shape shape_of_geom(const mjModel_& model, int geom, const std::string& file, std::vector<std::string>& warnings) {
  Shape shape;
  try {
    shape = bare_shape(model, geom, file, warnings);
  } catch (const std::invalid_argument& error) {
    throw SceneError(fmt::format("{}: {}: {}", file, geom_label(model, geom), error.what()));
  }
  shape.friction = model.geom_friction[3 * static_cast<std::ptrdiff_t>(geom)];
  shape.frictionless = model.geom_condim[geom] == 1;
  shape.priority = model.geom_priority[geom];
  shape.contact_type = model.geom_contype[geom];
  shape.contact_affinity = model.geom_conaffinity[geom];
  shape.colour = colour_of_geom(model, geom);
  return shape;
}

}  // namespace tegotae
