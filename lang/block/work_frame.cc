#include "lang/block/work_frame.h"

namespace stanok::lang {
namespace {

Vector3<double> geometry_of(const GeometryAxes& axes, const AxisValues& values) {
  std::array<double, 3> point{};
  for (std::size_t k = 0; k < 3; ++k) {
    if (axes[k].exists()) point[k] = values[axes[k]];
  }
  return vector3(point);
}

void set_geometry(const GeometryAxes& axes, const Vector3<double>& point, AxisValues& values) {
  const std::array<double, 3> vector = components(point);
  for (std::size_t k = 0; k < 3; ++k) {
    if (axes[k].exists()) values[axes[k]] = vector[k];
  }
}

}  // namespace

AxisValues turned(const Rotation& rotation, const GeometryAxes& axes, AxisValues values) {
  if (!rotation.is_identity()) {
    set_geometry(axes, rotation.turned(geometry_of(axes, values)), values);
  }
  return values;
}

AxisValues turned_back(const Rotation& rotation, const GeometryAxes& axes, AxisValues values) {
  if (!rotation.is_identity()) {
    set_geometry(axes, rotation.turned_back(geometry_of(axes, values)), values);
  }
  return values;
}

AxisValues WorkFrame::base_from_work(const AxisValues& point_W) const {
  AxisValues point_B = turned(rotation, geometry, point_W);
  for (std::size_t i = 0; i < point_B.size(); ++i) point_B[i] += offset[i];
  return point_B;
}

AxisValues WorkFrame::work_from_base(const AxisValues& point_B) const {
  AxisValues shifted = point_B;
  for (std::size_t i = 0; i < shifted.size(); ++i) shifted[i] -= offset[i];
  return turned_back(rotation, geometry, shifted);
}

}  // namespace stanok::lang
