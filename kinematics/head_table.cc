// Head-table scheme: see head_table.h for the formulas.
#include "kinematics/head_table.h"

#include "kinematics/scheme.h"

namespace stanok::kinematics {

std::vector<SchemeKey> HeadTable::Geometry::keys() {
  using enum KeyPresence;
  return {
      {"head_axis", AxisName{head_axis, "B"}, "rotary axis that carries the spindle"},
      {"head_vector", Direction{head_vector}, "direction of head_axis"},
      {"table_axis", AxisName{table_axis, "C"}, "rotary axis that carries the workpiece"},
      {"table_vector", Direction{table_vector}, "direction of table_axis"},
      {"pivot_to_spindle", Place{pivot_to_spindle},
       "from the pivot to the spindle nose, head upright", required},
      {"table_centre", Place{table_centre},
       "position of X, Y, Z with the pivot on the table's axis", required},
  };
}

HeadTable::HeadTable(const SchemeConfig& config)
    : HeadTable(config, std::get<Geometry>(config.geometry)) {}

HeadTable::HeadTable(const SchemeConfig& config, const Geometry& geometry)
    : RotaryScheme(
          config,
          {.head = {{geometry.head_axis, geometry.head_vector, geometry.pivot_to_spindle}},
           .table = {{.axis = geometry.table_axis, .vector = geometry.table_vector, .offset = {}}},
           .centre = geometry.table_centre}) {}

std::string HeadTable::defect(const SchemeConfig& config) {
  const auto& geometry = std::get<Geometry>(config.geometry);
  return rotary_scheme_defect(
      config, {"head_axis", geometry.head_axis, "head_vector", geometry.head_vector},
      {"table_axis", geometry.table_axis, "table_vector", geometry.table_vector});
}

AxisVector<double> HeadTable::zero_default(const SchemeConfig& config) {
  const auto& geometry = std::get<Geometry>(config.geometry);
  return linear_zero(config, geometry.table_centre - geometry.pivot_to_spindle);
}

}  // namespace stanok::kinematics
