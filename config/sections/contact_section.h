// [[contact]]: what a simulated machine touches: an input that is on where an axis stands.
#pragma once

#include <vector>

#include "config/sections/machine_description.h"
#include "config/text/key_table.h"

namespace stanok::config {

[[nodiscard]] std::vector<SimulatedContact> read_contacts(
    Subtables contacts, const std::vector<channels::AxisConfig>& axes, const Scope& scope);

// Rows of the documentation.
[[nodiscard]] std::vector<KeyRow> contact_key_rows();

}  // namespace stanok::config
