#include "lang/block/point_parameter.h"

#include "lang/block/predefined_parameter.h"

namespace stanok::lang {
namespace {

constexpr int probe_first = 5061;
constexpr int probe_found = 5070;

// Where the coordinates of a reference point begin.
struct ReferenceParameters {
  int point;
  int first;
};
constexpr ReferenceParameters reference_parameters[reference_point_count] = {
    {1, 5161}, {2, 5181}, {3, 5191}, {4, 5201}};

bool is_in_block(int number, int first) {
  return number >= first && number < first + static_cast<int>(parameter_axes.size());
}

// The channel's axis at `number` in a block of one parameter per axis, or none.
AxisIndex axis_of_parameter(int number, int first, const BlockSurroundings& around) {
  return around.channel_words.axis_called({parameter_axes.data() + (number - first), 1});
}

double coordinate(AxisIndex axis, const AxisValues& point, const BlockSurroundings& around) {
  return axis.exists() ? as_programmed(around, axis, point[axis]) : 0.0;
}

}  // namespace

std::optional<double> point_parameter(int number, const BlockSurroundings& around) {
  const ProbeResult& probe = around.probe;
  if (number == probe_found) return probe.found ? 1.0 : 0.0;
  if (is_in_block(number, probe_first)) {
    return coordinate(axis_of_parameter(number, probe_first, around), probe.position, around);
  }
  for (const auto& [which, first] : reference_parameters) {
    if (!is_in_block(number, first)) continue;
    const AxisIndex axis = axis_of_parameter(number, first, around);
    if (!axis.exists()) return 0.0;
    return machine_as_programmed(around, axis, around.tables.reference_point(which)[axis]);
  }
  return std::nullopt;
}

bool set_point_parameter(int number, double value, const BlockSurroundings& around) {
  for (const auto& [which, first] : reference_parameters) {
    if (!is_in_block(number, first)) continue;
    const AxisIndex axis = axis_of_parameter(number, first, around);
    if (!axis.exists()) return true;
    AxisValues point = around.tables.reference_point(which);
    point[axis] =
        from_programmed(around, axis, value) * around.tables.machine_reading().counts(axis);
    around.tables.store_reference_point(which, point);
    return true;
  }
  return false;
}

}  // namespace stanok::lang
