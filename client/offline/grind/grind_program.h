// The part program of a grinding cycle for a machine file: its grind channel, spindles and limits.
#pragma once

#include <filesystem>
#include <string>

#include "process/grinding/part_program.h"

namespace stanok::client {

struct GrindMachineOptions {
  std::filesystem::path machine_file;  // empty: part spindle 1, and no wheel
  int channel = 0;                     // 0: the first grind channel
  double wheel_speed_m_per_s = 35.0;   // of the wheel's surface
};

// What the machine adds to a program: spindle numbers and the speed of the wheel. Throws
// std::runtime_error when it has no grind channel with X, or cannot turn that fast.
[[nodiscard]] process::ProgramOptions program_options(const process::GrindingProcess& process,
                                                      const process::InfeedLaw& law,
                                                      const GrindMachineOptions& options);

}  // namespace stanok::client
