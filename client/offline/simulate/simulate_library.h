// `stanok simulate` of several programs, or folders of them: each run by itself, from the same
// start.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "client/offline/library/library_run.h"
#include "client/offline/machine/job_options.h"
#include "client/terminal/terminal.h"

namespace stanok::client {

// What became of a program.
struct SimulatedProgram {
  std::string file;
  bool ok = false;
  std::uint64_t blocks = 0;
  double time_s = 0.0;  // machine time of its run
  double path_mm = 0.0;
  Diagnostics diagnostics{};  // errors, alarms, refusals; W821: it was ended at the limit
};

struct LibrarySimulation {
  JobOptions job;
  double limit_s = -1.0;  // of machine time for each; < 0: none
  bool drives = false;    // simulated ones; without them they are ideal
};

// Reads the machine file; throws what it throws.
[[nodiscard]] LibraryWork simulation_work(const LibrarySimulation& wanted);
// Diagnostics as they come, and the table, or the JSON, of all.
[[nodiscard]] LibraryOutput simulation_output(const LibrarySimulation& wanted);

// One row for each program and their sum: file, blocks, time, path, what became of it.
[[nodiscard]] std::string simulated_table(const std::vector<SimulatedProgram>& programs,
                                          const Terminal& terminal);
// {"files": [{"file", "ok", "blocks", "time_s", "path_mm", "diagnostics"}], "totals": {"programs",
// "failed", "blocks", "time_s", "path_mm"}}.
[[nodiscard]] nlohmann::ordered_json simulated_json(const std::vector<SimulatedProgram>& programs);

}  // namespace stanok::client
