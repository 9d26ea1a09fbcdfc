// [[simulation.tool]] and [simulation.tool_setter]: what a simulated machine measures.
#pragma once

#include <vector>

#include "channels/contract/machine_config.h"
#include "config/sections/machine_description.h"
#include "config/text/key_table.h"

namespace stanok::config {

[[nodiscard]] std::vector<RealTool> read_real_tools(Subtables tools,
                                                    const channels::MachineConfig& machine,
                                                    const Scope& scope);
[[nodiscard]] ToolSetterConfig read_tool_setter(const toml::table& table,
                                                const channels::MachineConfig& machine,
                                                const Scope& scope);

// Rows of the documentation.
[[nodiscard]] std::vector<KeyRow> real_tool_key_rows();
[[nodiscard]] std::vector<KeyRow> tool_setter_key_rows();

}  // namespace stanok::config
