// What the grind commands are given: options, and the process or control file they name.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "jobs/grinding/grind_input.h"
#include "jobs/grinding/grind_program.h"

namespace stanok::client {

struct GrindOptions : jobs::GrindRequest {
  bool json = false;
  std::vector<std::string> variations;
  std::string part = "1/1";
  std::vector<std::string> spreads;
  // Files to write; empty: none.
  std::string out;
  std::string program;
  std::string picture;
  std::string optimum_picture;
  // What a part program needs besides.
  jobs::GrindMachine machine;
  double gauge_margin_mm = 0.0;
};

// A control file (`read_control_input`), or by its name a process file or a control file. What is
// wrong with it is printed, as text or JSON; nothing then. A process file that is wrong, where JSON
// is not asked for, is a ConfigError; a file that cannot be read a std::runtime_error.
[[nodiscard]] std::optional<jobs::GrindInput> read_control_input(const GrindOptions& options);
[[nodiscard]] std::optional<jobs::GrindInput> read_input(const GrindOptions& options);

}  // namespace stanok::client
