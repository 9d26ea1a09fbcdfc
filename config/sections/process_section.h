// [process]: force control of the channels; [simulation.cutting]: the cut behind the simulated
// spindle.
#pragma once

#include <vector>

#include "channels/contract/machine_config.h"
#include "config/sections/machine_description.h"
#include "config/text/key_table.h"

namespace stanok::config {

// Marks the channels that have force control.
[[nodiscard]] ProcessConfig read_process(const toml::table& table, channels::MachineConfig& machine,
                                         const Scope& scope);

[[nodiscard]] CuttingConfig read_cutting(const toml::table& table,
                                         const channels::MachineConfig& machine,
                                         const Scope& scope);

// Rows of the documentation.
[[nodiscard]] std::vector<KeyRow> process_key_rows();
[[nodiscard]] std::vector<KeyRow> cutting_key_rows();
[[nodiscard]] std::vector<KeyRow> stock_key_rows();

}  // namespace stanok::config
