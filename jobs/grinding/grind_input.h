// What a job on plunge cycles is asked for: a process file or a control file, and what is to hold
// instead of what it says.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/diagnostic.h"
#include "base/expected.h"
#include "process/grinding/control_file.h"
#include "process/grinding/cycle_design.h"

namespace stanok::jobs {

struct GrindRequest {
  std::string input;  // process file (.toml) or control file
  // Instead of what the process says; below 0, or 0 for the time step: that.
  bool exact = false;
  double burn_margin = -1.0;
  double spark_out_revolutions = -1.0;
  double time_step_s = 0.0;
  // What a design or a study needs besides.
  int points = -1;  // below 0: as many as pay
  std::vector<double> at_mm;
  int decimals = 0;  // 0: as many as the feeds need
  double feedback = 0.5;
  int iterations = 40;
  bool force = false;
};

// A request, and the control file when that is what it was read from.
struct GrindInput {
  process::DesignRequest request;
  std::optional<process::ControlFile> control;
};

// A control file (`control_input`), or by its name a process file or a control file
// (`grind_input`), or what is wrong with the control file. A process file that is wrong is a
// ConfigError; a file that cannot be read a std::runtime_error.
[[nodiscard]] Expected<GrindInput, Diagnostics> control_input(const GrindRequest& asked);
[[nodiscard]] Expected<GrindInput, Diagnostics> grind_input(const GrindRequest& asked);

}  // namespace stanok::jobs
