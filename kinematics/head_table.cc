// Head-table scheme: see head_table.h for the formulas.
#include "kinematics/head_table.h"

namespace stanok::kinematics {

HeadTable::HeadTable(const SchemeConfig& config)
    : RotaryScheme(
          config,
          {.head = {{config.head_axis, config.head_vector, config.pivot_to_spindle}},
           .table = {{.axis = config.table_axis, .vector = config.table_vector, .offset = {}}},
           .centre = config.table_centre}) {}

std::string head_table_defect(const SchemeConfig& config) {
  return rotary_scheme_defect(
      config, {"head_axis", config.head_axis, "head_vector", config.head_vector},
      {"table_axis", config.table_axis, "table_vector", config.table_vector});
}

}  // namespace stanok::kinematics
