// SPDX-License-Identifier: Apache-2.0
#include <tegotae/shape/mass_properties.hpp>

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace tegotae {
namespace {

constexpr double kPi = std::numbers::pi;

// Inertia about the centre of mass from the second moments of the mass along the principal axes.
MassProperties from_moments(double mass, const Vector3& second_moments) {
  const double total = second_moments.sum();
  const Vector3 diagonal = Vector3::Constant(total) - second_moments;
  return {mass, Vector3::Zero(), diagonal.asDiagonal().toDenseMatrix()};
}

MassProperties box_mass(const Vector3& half, double density) {
  const double mass = density * 8.0 * half.prod();
  return from_moments(mass, mass / 3.0 * half.cwiseAbs2());
}

MassProperties ellipsoid_mass(const Vector3& axes, double density) {
  const double mass = density * 4.0 / 3.0 * kPi * axes.prod();
  return from_moments(mass, mass / 5.0 * axes.cwiseAbs2());
}

MassProperties cylinder_mass(double r, double h, double density) {
  const double mass = density * 2.0 * kPi * r * r * h;
  return from_moments(mass, mass * Vector3(r * r / 4.0, r * r / 4.0, h * h / 3.0));
}

// A cylinder and two half balls whose centres of mass lie 3/8 r beyond the ends of the axis.
MassProperties capsule_mass(double r, double h, double density) {
  const MassProperties cylinder = cylinder_mass(r, h, density);
  const double balls = density * 4.0 / 3.0 * kPi * r * r * r;
  const double along = balls * (r * r / 5.0 + h * h + 0.75 * h * r);
  const double across = balls * r * r / 5.0;
  const MassProperties ends = from_moments(balls, {across, across, along});
  return {cylinder.mass + balls, Vector3::Zero(), cylinder.inertia + ends.inertia};
}

// Sum over tetrahedra from the first vertex to the faces' triangles; the second moment of a tetrahedron with a corner
// at the origin and edge vectors e_i is V/20 (sum e_i e_i^T + s s^T), s their sum.
MassProperties polytope_mass(const Polytope& polytope, double density) {
  double volume = 0.0;
  Vector3 first = Vector3::Zero();
  Matrix3 second = Matrix3::Zero();
  const Vector3 apex = polytope.vertices[0];
  for (const auto& face : polytope.faces) {
    const auto loop = polytope.vertices_of(face);
    const Vector3 a = polytope.vertices[static_cast<size_t>(loop[0])] - apex;
    for (size_t k = 1; k + 1 < loop.size(); ++k) {
      const Vector3 b = polytope.vertices[static_cast<size_t>(loop[k])] - apex;
      const Vector3 c = polytope.vertices[static_cast<size_t>(loop[k + 1])] - apex;
      const double v = a.dot(b.cross(c)) / 6.0;
      const Vector3 s = a + b + c;
      volume += v;
      first += v / 4.0 * s;
      second += v / 20.0 * (a * a.transpose() + b * b.transpose() + c * c.transpose() + s * s.transpose());
    }
  }
  const Vector3 centre = first / volume;
  const Matrix3 central = density * (second - volume * centre * centre.transpose());
  return {density * volume, apex + centre, central.trace() * Matrix3::Identity() - central};
}

MassProperties in_shape_frame(const Shape& shape, double density) {
  const Vector3& size = shape.size;
  switch (shape.kind) {
    case ShapeKind::kBox:
      return box_mass(size, density);
    case ShapeKind::kSphere:
      return ellipsoid_mass(Vector3::Constant(size.x()), density);
    case ShapeKind::kCapsule:
      return capsule_mass(size.x(), size.y(), density);
    case ShapeKind::kCylinder:
      return cylinder_mass(size.x(), size.y(), density);
    case ShapeKind::kEllipsoid:
      return ellipsoid_mass(size, density);
    case ShapeKind::kHull:
      return polytope_mass(*shape.polytope, density);
    case ShapeKind::kPlane:
      break;
  }
  throw std::invalid_argument("a plane has no mass properties");
}

}  // namespace

double MassProperties::gyration_length() const noexcept { return std::sqrt(inertia.trace() / (3.0 * mass)); }

MassProperties mass_properties(const Shape& shape, double density) {
  MassProperties result = in_shape_frame(shape, density);
  const Matrix3 R = shape.X_BS.rotation();
  result.centre_of_mass = shape.X_BS * result.centre_of_mass;
  result.inertia = R * result.inertia * R.transpose();
  return result;
}

MassProperties combined(std::span<const MassProperties> parts) {
  MassProperties whole;
  for (const auto& part : parts) {
    whole.mass += part.mass;
    whole.centre_of_mass += part.mass * part.centre_of_mass;
  }
  whole.centre_of_mass /= whole.mass;
  for (const auto& part : parts) {
    const Vector3 arm = part.centre_of_mass - whole.centre_of_mass;
    const Matrix3 steiner = arm.squaredNorm() * Matrix3::Identity() - arm * arm.transpose();
    whole.inertia += part.inertia + part.mass * steiner;
  }
  return whole;
}

}  // namespace tegotae
