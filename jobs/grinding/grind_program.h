// The part program of a grinding cycle for a machine file: its grind channel, spindles and limits.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "process/grinding/part_program.h"

namespace stanok::jobs {

struct GrindMachine {
  std::filesystem::path machine_file;  // empty: part spindle 1, and no wheel
  int channel = 0;                     // 0: the first grind channel
  double wheel_speed_m_per_s = 35.0;   // of the wheel's surface
};

struct GrindProgramRequest {
  process::GrindingProcess process;
  process::InfeedLaw law;
  GrindMachine machine;
  std::string title;
  double spark_out_revolutions = 0.0;
  double gauge_margin_mm = 0.0;
};

struct GrindProgram {
  std::string text;
  std::vector<std::string> warnings;
};

// Throws std::runtime_error when the machine has no grind channel with X, or cannot turn that fast.
[[nodiscard]] GrindProgram grind_program(const GrindProgramRequest& request);

}  // namespace stanok::jobs
