// The single tables of the machine file: [machine], [drives], [lcm], [recorder],
// [simulation].
#pragma once

#include <vector>

#include "config/sections/machine_description.h"
#include "config/text/key_table.h"

namespace stanok::config {

// [machine]
struct MachineSection {
  std::string name;
  int cycle_us = 1000;
  int catch_up_max = 3;
  double stop_limits = 1.2;
  double stop_time_max_s = 0.0;
  double request_age_max_s = 0.5;
  int retrace_memory_mb = 64;
  bool first_run = false;
  std::string tables;  // file name; empty: none
  bool tables_write_protected = false;
  int program_size_max_mb = 256;
  int program_steps_max_m = 1000;
  std::string program_encoding;  // empty: UTF-8
};

[[nodiscard]] const Keys<MachineSection>& machine_keys();

// [simulation]
struct SimulationSection {
  SimulationConfig simulation;
  Subtable cutting = nullptr;
  Subtables tools = nullptr;
  Subtable setter = nullptr;
};
[[nodiscard]] const Keys<SimulationSection>& simulation_keys();

// [drives]; the drives of the axes stand with the axes.
[[nodiscard]] drives::BusConfig read_bus(const toml::table& table, const Scope& scope);
[[nodiscard]] std::string read_lcm_url(const toml::table& table, const Scope& scope);
[[nodiscard]] RecorderConfig read_recorder(const toml::table& table, const Scope& scope);
// Whether the machine has the section or not; its channels are known.
[[nodiscard]] channels::EntryLimits read_entry_limits(Subtable table,
                                                      const channels::MachineConfig& machine,
                                                      const Scope& scope);

// Rows of the documentation.
[[nodiscard]] std::vector<KeyRow> drives_key_rows();
[[nodiscard]] std::vector<KeyRow> lcm_key_rows();
[[nodiscard]] std::vector<KeyRow> recorder_key_rows();
[[nodiscard]] std::vector<KeyRow> entry_limits_key_rows();

}  // namespace stanok::config
