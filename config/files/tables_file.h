// Tool table, work offsets and reference points: the tables a machine starts with when it has no
// saved ones.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "channels/contract/machine_config.h"
#include "config/text/key_table.h"

namespace stanok::config {

// Of all axes of a machine, in their order.
[[nodiscard]] std::vector<std::string> names_of_axes(const channels::MachineConfig& machine);

// Offsets are given for the machine's axes `axis_names`. What a row of a tool leaves out is as in
// `base`. Faults go to the scope's list.
[[nodiscard]] channels::TablesConfig read_tables(const std::filesystem::path& file,
                                                 const std::vector<std::string>& axis_names,
                                                 FaultList& faults,
                                                 const channels::TablesConfig& base = {});

// The same from a text of that file, for tables an operator loads. Throws ConfigError.
[[nodiscard]] channels::TablesConfig read_tables_text(const std::string& text,
                                                      const std::filesystem::path& file,
                                                      const std::vector<std::string>& axis_names,
                                                      const channels::TablesConfig& base = {});

// Only the tools of such a text; its offsets are not read, since they need the axes of a machine.
// Throws ConfigError.
[[nodiscard]] std::vector<channels::ToolEdge> read_tools_text(const std::string& text,
                                                              const std::filesystem::path& file);

// The keys of a row of [[tool]], in their order.
[[nodiscard]] const Keys<channels::ToolEdge>& tool_keys();

// The tables as a text that reads back the same, to the bit.
[[nodiscard]] std::string to_toml(const channels::TablesConfig& tables);

// "G54" ... "G59", "G59.1" ... "G59.3", "G54.1 P1" ....
[[nodiscard]] bool is_work_offset(std::string_view name);

// "G28", "G30 P2" to "G30 P4".
[[nodiscard]] bool is_reference_point(std::string_view name);

// Rows of the documentation.
[[nodiscard]] std::vector<KeyRow> tool_key_rows();

}  // namespace stanok::config
