// What a machine file says, as the structs that its sections fill: the machine, its drives, the
// recorder and the plant behind simulated drives. config/files/machine_file.h reads it.
#pragma once

#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "channels/contract/machine_config.h"
#include "config/text/source_file.h"
#include "drives/bus_config.h"
#include "process/adaptive/force_control_config.h"

namespace stanok::config {

// [recorder]
struct RecorderConfig {
  std::filesystem::path directory;  // empty: below the state directory
  int size_mb = 1024;               // of one log file before the next begins
  double flight_s = 60.0;           // kept in memory for the case of a fault; 0: nothing
  // Of all logs and flight files of the machine together; 0: no bound.
  double logs_max_gb = 20.0;
  double logs_max_days = 90.0;
  double free_space_min_gb = 1.0;  // that they leave free on their disk
};

// [process]: force control of the channels that have it.
struct ProcessConfig {
  process::ForceControlConfig control;
};

// [[simulation.cutting.stock]]
struct StockSection {
  double z_mm = 0.0;  // where it begins; it reaches to the next one
  double radius_mm = 0.0;
  double hardness_hb = 200.0;
};

// [simulation.cutting]: the cut behind a simulated spindle, in the frame of the program.
struct CuttingConfig {
  int channel = 1;
  double specific_force_n = 1600.0;  // C of P_z = C t S^y (HB / hardness)^e
  double feed_exponent = 0.75;       // y
  double hardness_hb = 200.0;
  double hardness_exponent = 0.75;  // e
  double efficiency = 1.0;
  double power_lag_s = 0.02;
  int sample_ms = 10;
  double vibration_um = 0.0;  // self-oscillation; 0: none
  double vibration_hz = 100.0;
  double vibration_mass_kg = 1.0;
  std::vector<StockSection> stock;  // from the face on, z falls; empty: there is no cut
};

// [[simulation.tool]]: what a tool of a simulated machine really is, whatever the table of tools
// says of it: what is not given is as the table has it at the start, mm.
struct RealTool {
  static constexpr double as_table = std::numeric_limits<double>::infinity();

  int number = 0;
  int edge = 1;
  double length = as_table, length_x = as_table, length_y = as_table;
  double radius = as_table;
};

// [simulation.tool_setter]: a disc that switches probe_input of its channel where a tool touches
// it. The middle of its upper face, in readings of the axes with the spindle nose there, mm.
struct ToolSetterConfig {
  int channel = 0;  // 0: there is none
  double x = 0.0, y = 0.0, z = 0.0;
  double diameter = 0.0;
  double height = 10.0;
};

// [simulation]: plant behind the simulated drives.
struct SimulationConfig {
  double drive_frequency_hz = 40.0;  // natural frequency of the position loop
  double drive_damping = 0.8;
  // Drives whose position loop is closed in the cycle: velocity loop, and load on a spring.
  double servo_frequency_hz = 150.0;
  double servo_damping = 0.7;
  double resonance_frequency_hz = 80.0;  // 0: none
  double resonance_damping = 0.1;
  bool outputs_to_inputs = false;  // outputs of programs come back as inputs of the same number
  CuttingConfig cutting;
  std::vector<RealTool> tools;
  ToolSetterConfig setter;
};

// [[contact]]: a digital input that is on while an axis stands between two positions; a surface for
// a probe, or a stop.
struct SimulatedContact {
  int input = 0;
  int axis = 0;  // of the machine
  double from = -std::numeric_limits<double>::infinity();
  double to = std::numeric_limits<double>::infinity();
};

// [axis.plant]: the machine behind the simulated drive of an axis, mm or deg.
struct AxisSimulation {
  static constexpr double none = std::numeric_limits<double>::infinity();

  bool absolute_encoder = true;    // else it counts from where it is switched on
  double home_switch_from = none;  // active from here to there
  double home_switch_to = -none;
  double limit_negative = -none;  // active at and below
  double limit_positive = none;   // active at and above
  double index_position = 0.0;    // of one of the pulses
  double index_pitch = 0.0;       // 0: there are none
  double backlash = 0.0;
  double dry_friction = 0.0;  // mm/s2, deg/s2
};

struct MachineFile {
  std::filesystem::path path;
  std::vector<SourceFile> sources;  // the machine file and those that it names
  channels::MachineConfig machine;
  drives::BusConfig bus;  // kind none: no [drives], setpoints only
  std::string lcm_url = "udpm://239.255.76.67:7667?ttl=0";
  RecorderConfig recorder;
  ProcessConfig process;
  SimulationConfig simulation;
  std::vector<AxisSimulation> axis_plants;  // in machine axis order
  std::vector<SimulatedContact> contacts;
};

}  // namespace stanok::config
