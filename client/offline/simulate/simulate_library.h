// `stanok simulate` of several programs, or folders of them: each run by itself, from the same
// start.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "client/offline/library/library_run.h"
#include "client/offline/machine/job_options.h"
#include "client/offline/workpiece/simulated_parts.h"
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
  // Bytes of PNG files of what it leaves of its blanks; names of the files once these are written.
  std::vector<std::string> pictures{};
};

struct LibrarySimulation {
  JobOptions job;
  double limit_s = -1.0;   // of machine time for each; < 0: none
  bool drives = false;     // simulated ones; without them they are ideal
  std::string pictures{};  // folder for them; empty: none are drawn
  std::uint64_t workpiece_memory_mib = simulation::memory_default >> 20U;
};

// Reads the machine file; throws what it throws.
[[nodiscard]] LibraryWork simulation_work(const LibrarySimulation& wanted);
// Diagnostics as they come, and the table, or the JSON, of all.
[[nodiscard]] LibraryOutput simulation_output(const LibrarySimulation& wanted);

// One row for each program and their sum: file, blocks, time, path, what became of it.
[[nodiscard]] std::string simulated_table(const std::vector<SimulatedProgram>& programs,
                                          const Terminal& terminal);
// {"files": [{"file", "ok", "blocks", "time_s", "path_mm", "pictures", "diagnostics"}], "totals":
// {"programs", "failed", "blocks", "time_s", "path_mm"}}; "pictures" where there are any.
[[nodiscard]] nlohmann::ordered_json simulated_json(const std::vector<SimulatedProgram>& programs);

}  // namespace stanok::client
