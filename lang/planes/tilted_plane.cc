#include "lang/planes/tilted_plane.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "base/angle.h"

namespace stanok::lang {
namespace {

using Vector = Vector3<double>;

constexpr double deg_per_rad = 180.0 / std::numbers::pi;
constexpr double no_direction = 1e-9;  // of unit vectors: what they span is nothing

constexpr std::array<std::array<double, 3>, 3> unit{
    {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}};

double length_of_vector(const Vector& v) {
  return std::hypot(v.x(), v.y(), v.z());
}

// A direction; nothing when the vector has none.
std::optional<Vector> unit_of(const Vector& v) {
  const double length = length_of_vector(v);
  if (!(length > 0.0)) return std::nullopt;
  return Vector(v / length);
}

std::optional<EulerAngles> spanned(const Vector& x, const Vector& towards_y) {
  const auto first = unit_of(x);
  const auto second = unit_of(towards_y);
  if (!first || !second) return std::nullopt;
  const Vector z = first->cross(*second);
  if (length_of_vector(z) < no_direction) return std::nullopt;
  return euler_angles(*first, *unit_of(z));
}

}  // namespace

Rotation rotation_of(const EulerAngles& angles_deg) {
  const Vector x = vector3(unit[0]);
  const Vector z = vector3(unit[2]);
  return Rotation::about(z, angles_deg[0]) * Rotation::about(x, angles_deg[1]) *
         Rotation::about(z, angles_deg[2]);
}

// Z stands at (sin J sin I, -sin J cos I, cos J); the node (cos I, sin I, 0) is X before the last
// turn.
EulerAngles euler_angles(const Vector3<double>& x, const Vector3<double>& z) {
  const double across = std::hypot(z.x(), z.y());
  const double first = across > 0.0 ? std::atan2(z.x(), -z.y()) : 0.0;
  const double second = std::atan2(across, z.z());
  const Vector node{std::cos(first), std::sin(first), 0.0};
  const double third = std::atan2(dot(z, Vector(node.cross(x))), dot(node, x));
  return {deg_per_rad * first, deg_per_rad * second, deg_per_rad * third};
}

EulerAngles euler_angles(const Rotation& rotation) {
  return euler_angles(rotation.turned(vector3(unit[0])), rotation.turned(vector3(unit[2])));
}

std::optional<EulerAngles> roll_pitch_yaw(const std::array<double, 3>& angles_deg, int order) {
  const std::array<int, 3> axes{order / 100, order / 10 % 10, order % 10};
  unsigned seen = 0;
  Rotation rotation;
  for (const int axis : axes) {
    if (axis < 1 || axis > 3) return std::nullopt;
    seen |= 1U << axis;
    const auto k = static_cast<std::size_t>(axis - 1);
    rotation = Rotation::about(vector3(unit[k]), angles_deg[k]) * rotation;
  }
  if (seen != 0b1110U) return std::nullopt;
  return euler_angles(rotation);
}

std::optional<EulerAngles> through_points(const std::array<Vector3<double>, 3>& points) {
  return spanned(points[1] - points[0], points[2] - points[0]);
}

std::optional<EulerAngles> along_vectors(const Vector3<double>& x, const Vector3<double>& z) {
  const auto along = unit_of(x);
  const auto normal = unit_of(z);
  if (!along || !normal) return std::nullopt;
  const double cosine = dot(*along, *normal);
  if (std::abs(cosine) > sine_of_degrees(square_tolerance_deg)) return std::nullopt;
  return euler_angles(*unit_of(*along - *normal * cosine), *normal);
}

std::optional<EulerAngles> projected(const std::array<double, 3>& angles_deg) {
  const Vector x{cosine_of_degrees(angles_deg[0]), 0.0, -sine_of_degrees(angles_deg[0])};
  const Vector y{0.0, cosine_of_degrees(angles_deg[1]), sine_of_degrees(angles_deg[1])};
  const auto plane = spanned(x, y);
  if (!plane) return std::nullopt;
  return turned_in_itself(*plane, angles_deg[2]);
}

EulerAngles turned_in_itself(EulerAngles angles_deg, double by_deg) {
  angles_deg[2] += by_deg;
  return angles_deg;
}

void TiltedPlane::set(const std::array<double, 3>& at, const EulerAngles& angles) {
  *this = {};
  is_on = true;
  origin = at;
  angles_deg = angles;
  rotation = rotation_of(angles);
}

}  // namespace stanok::lang
