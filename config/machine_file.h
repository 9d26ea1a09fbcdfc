// The machine file: everything stanokd, simulate and stanok-drives know of one machine.
//
// read_machine_file is strict: an unknown or missing key, a wrong kind or a value that contradicts
// another is an error with its place and remedy, and all errors of the file and the files it names
// are shown at once. Paths in it are relative to the machine file. All keys: docs/configuration.md.
#pragma once

#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "channels/machine_config.h"
#include "config/config_error.h"
#include "drives/bus_config.h"

namespace stanok::config {

// [recorder]
struct RecorderConfig {
  std::filesystem::path directory;  // empty: below the state directory
  int size_mb = 1024;               // of one log file before the next begins
};

// [process]: what force control takes when the program does not say.
struct ProcessConfig {
  double feed_min = 0.0;            // mm/s
  double feed_max = 0.0;            // mm/s; 0: the programmed feed
  double vibration_level_um = 0.0;  // permissible level; 0: vibration does not act
  double reduced_mass_kg = 0.0;     // of the oscillating system
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
  channels::MachineConfig machine;
  drives::BusConfig bus;  // kind none: no [drives], set-points only
  std::string lcm_url = "udpm://239.255.76.67:7667?ttl=0";
  RecorderConfig recorder;
  ProcessConfig process;
  SimulationConfig simulation;
  std::vector<AxisSimulation> axis_plants;  // in machine axis order
};

// Throws ConfigError.
[[nodiscard]] MachineFile read_machine_file(const std::filesystem::path& path);

}  // namespace stanok::config
