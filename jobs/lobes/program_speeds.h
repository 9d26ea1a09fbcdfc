// The speeds at which a part program cuts.
#pragma once

#include <string>
#include <vector>

#include "base/diagnostic.h"
#include "channels/contract/machine_config.h"
#include "lang/contract/environment.h"

namespace stanok::jobs {

struct ProgramSpeedsRequest {
  const channels::MachineConfig& machine;
  int channel = 1;
  int scheme = -1;  // below 0: that of the machine file
  std::string program;
  const lang::Files& files;  // among which the program is
};

struct ProgramSpeeds {
  Diagnostics diagnostics;  // with errors: there are no speeds
  // Of the master spindle in the moves at feed, rising, each once. Under G96 the speed follows the
  // diameter: it is not among them.
  std::vector<double> rev_per_min;
};

[[nodiscard]] ProgramSpeeds program_speeds(const ProgramSpeedsRequest& request);

}  // namespace stanok::jobs
