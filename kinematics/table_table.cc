// Table-table scheme: see table_table.h for the formulas.
#include "kinematics/table_table.h"

namespace stanok::kinematics {

TableTable::TableTable(const SchemeConfig& config)
    : RotaryScheme(
          config,
          {.head = {},
           .table = {{config.outer_axis, config.outer_vector, config.centre_to_centre},
                     {.axis = config.inner_axis, .vector = config.inner_vector, .offset = {}}},
           .centre = config.table_centre}) {}

std::string table_table_defect(const SchemeConfig& config) {
  return rotary_scheme_defect(
      config, {"outer_axis", config.outer_axis, "outer_vector", config.outer_vector},
      {"inner_axis", config.inner_axis, "inner_vector", config.inner_vector});
}

}  // namespace stanok::kinematics
