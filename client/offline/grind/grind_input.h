// What the grind commands are given: options, and the process or control file they name.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/diagnostic.h"
#include "base/expected.h"
#include "client/offline/grind/grind_program.h"
#include "process/grinding/control_file.h"
#include "process/grinding/cycle_design.h"

namespace stanok::client {

struct GrindOptions {
  std::string input;  // process file or control file
  bool json = false;
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
  std::vector<std::string> variations;
  std::string part = "1/1";
  std::vector<std::string> spreads;
  // Files to write; empty: none.
  std::string out;
  std::string program;
  std::string picture;
  std::string optimum_picture;
  // What a part program needs besides.
  GrindMachineOptions machine;
  double gauge_margin_mm = 0.0;
};

// A request, and the control file when that is what it was read from.
struct GrindInput {
  process::DesignRequest request;
  std::optional<process::ControlFile> control;
};

// A control file (`control_input`), or by its name a process file or a control file
// (`grind_input`), or what is wrong with the control file. A process file that is wrong is a
// ConfigError; a file that cannot be read a std::runtime_error.
[[nodiscard]] Expected<GrindInput, Diagnostics> control_input(const GrindOptions& options);
[[nodiscard]] Expected<GrindInput, Diagnostics> grind_input(const GrindOptions& options);

// The same for the command line: a control file (`read_control_input`), or by its name a process
// file or a control file. What is wrong with it is printed, as text or JSON; nothing then. A
// process file that is wrong, where JSON is not asked for, is a ConfigError; a file that cannot be
// read a std::runtime_error.
[[nodiscard]] std::optional<GrindInput> read_control_input(const GrindOptions& options);
[[nodiscard]] std::optional<GrindInput> read_input(const GrindOptions& options);

}  // namespace stanok::client
