// Keys of [axis.plant]: what the simulated drive of an axis has beyond its position loop.
#pragma once

#include <vector>

#include "config/sections/machine_description.h"
#include "config/text/key_table.h"

namespace stanok::config {

[[nodiscard]] AxisSimulation read_axis_plant(const toml::table& table, const Scope& scope);

// Rows of the documentation.
[[nodiscard]] std::vector<KeyRow> axis_plant_key_rows();

}  // namespace stanok::config
