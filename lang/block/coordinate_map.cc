#include "lang/block/coordinate_map.h"

#include <algorithm>

namespace stanok::lang {

CoordinateMap::CoordinateMap() {
  gain_.fill(1.0);
}

void CoordinateMap::compute(AxisIndex axis) {
  const AxisMap& map = axes_[axis];
  const double sign = map.mirrored ? -1.0 : 1.0;
  const double mirror_shift = map.mirrored ? 2.0 * map.line : 0.0;
  gain_[axis] = sign * map.factor;
  shift_[axis] = map.factor * mirror_shift + (1.0 - map.factor) * map.centre;
  active_ = std::any_of(axes_.begin(), axes_.end(),
                        [](const AxisMap& one) { return one.mirrored || one.factor != 1.0; });
}

void CoordinateMap::scale(AxisIndex axis, double centre, double factor) {
  AxisMap& map = axes_[axis];
  map.centre = map.mirrored ? 2.0 * map.line - centre : centre;
  map.factor = factor;
  compute(axis);
}

void CoordinateMap::mirror(AxisIndex axis, double line) {
  axes_[axis].mirrored = true;
  axes_[axis].line = line;
  compute(axis);
}

CoordinateMap::Numbers CoordinateMap::numbers() const {
  Numbers all{};
  auto next = all.begin();
  for (const AxisMap& map : axes_) {
    for (const double number : {map.mirrored ? 1.0 : 0.0, map.line, map.centre, map.factor})
      *next++ = number;
  }
  return all;
}

bool CoordinateMap::take(const Numbers& numbers) {
  for (std::size_t axis = 0; axis < axes_.size(); ++axis) {
    const double* const four = numbers.data() + 4 * axis;
    if (four[3] == 0.0) return false;
    axes_[axis] = {four[0] != 0.0, four[1], four[2], four[3]};
    compute(axis);
  }
  return true;
}

void CoordinateMap::cancel_scaling() {
  for (std::size_t axis = 0; axis < axes_.size(); ++axis) scale(axis, 0.0, 1.0);
}

void CoordinateMap::cancel_mirror(AxisIndex axis) {
  axes_[axis].mirrored = false;
  compute(axis);
}

bool CoordinateMap::any_mirror() const {
  return std::any_of(axes_.begin(), axes_.end(), [](const AxisMap& one) { return one.mirrored; });
}

}  // namespace stanok::lang
