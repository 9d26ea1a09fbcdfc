// Table-table scheme: see table_table.h for the formulas.
#include "kinematics/table_table.h"

#include "kinematics/scheme.h"

namespace stanok::kinematics {

std::vector<SchemeKey> TableTable::Geometry::keys() {
  using enum KeyPresence;
  return {
      {"outer_axis", AxisName{outer_axis}, "rotary axis nearest to the bed", required},
      {"outer_vector", Direction{outer_vector}, "direction of outer_axis", required},
      {"inner_axis", AxisName{inner_axis}, "rotary axis nearest to the workpiece", required},
      {"inner_vector", Direction{inner_vector}, "direction of inner_axis, outer axis at 0",
       required},
      {"table_centre", Place{table_centre},
       "position of X, Y, Z with the spindle nose at the centre on outer_axis", required},
      {"centre_to_centre", Place{centre_to_centre},
       "from the centre on outer_axis to the one on inner_axis, table at 0"},
  };
}

TableTable::TableTable(const SchemeConfig& config)
    : TableTable(config, std::get<Geometry>(config.geometry)) {}

TableTable::TableTable(const SchemeConfig& config, const Geometry& geometry)
    : RotaryScheme(
          config,
          {.head = {},
           .table = {{geometry.outer_axis, geometry.outer_vector, geometry.centre_to_centre},
                     {.axis = geometry.inner_axis, .vector = geometry.inner_vector, .offset = {}}},
           .centre = geometry.table_centre}) {}

std::string TableTable::defect(const SchemeConfig& config) {
  const auto& geometry = std::get<Geometry>(config.geometry);
  return rotary_scheme_defect(
      config, {"outer_axis", geometry.outer_axis, "outer_vector", geometry.outer_vector},
      {"inner_axis", geometry.inner_axis, "inner_vector", geometry.inner_vector});
}

AxisVector<double> TableTable::zero_default(const SchemeConfig& config) {
  const auto& geometry = std::get<Geometry>(config.geometry);
  return linear_zero(config, geometry.table_centre + geometry.centre_to_centre);
}

}  // namespace stanok::kinematics
