#include "lang/block/point_parameter.h"

#include "lang/block/predefined_parameter.h"

namespace stanok::lang {
namespace {

constexpr int probe_first = 5061;
constexpr int probe_found = 5070;
constexpr std::array<int, reference_point_count> reference_first{5161, 5181, 5191, 5201};

bool is_in_block(int number, int first) {
  return number >= first && number < first + static_cast<int>(parameter_axes.size());
}

// The channel's axis at `number` in a block of one parameter per axis, or -1.
int axis_at(int number, int first, const BlockSurroundings& around) {
  return around.channel_words.axis_called(
      parameter_axes.substr(static_cast<std::size_t>(number - first), 1));
}

double coordinate(int axis, const AxisValues& point, const BlockSurroundings& around) {
  if (axis < 0) return 0.0;
  const auto index = static_cast<std::size_t>(axis);
  return as_programmed(around, index, point[index]);
}

}  // namespace

std::optional<double> point_parameter(int number, const BlockSurroundings& around) {
  const ProbeResult& probe = around.probe;
  if (number == probe_found) return probe.found ? 1.0 : 0.0;
  if (is_in_block(number, probe_first)) {
    return coordinate(axis_at(number, probe_first, around), probe.position, around);
  }
  for (int which = 1; which <= reference_point_count; ++which) {
    const int first = reference_first[static_cast<std::size_t>(which - 1)];
    if (!is_in_block(number, first)) continue;
    return coordinate(axis_at(number, first, around), around.tables.reference_point(which), around);
  }
  return std::nullopt;
}

bool set_point_parameter(int number, double value, const BlockSurroundings& around) {
  for (int which = 1; which <= reference_point_count; ++which) {
    const int first = reference_first[static_cast<std::size_t>(which - 1)];
    if (!is_in_block(number, first)) continue;
    const int axis = axis_at(number, first, around);
    if (axis < 0) return true;
    AxisValues point = around.tables.reference_point(which);
    const auto index = static_cast<std::size_t>(axis);
    point[index] = from_programmed(around, index, value);
    around.tables.store_reference_point(which, point);
    return true;
  }
  return false;
}

}  // namespace stanok::lang
