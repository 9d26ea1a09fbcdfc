// What `stanok check` found in each program, as a table and as JSON.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/diagnostic.h"
#include "base/plane_position.h"
#include "client/terminal/terminal.h"
#include "jobs/dry_run/dry_run.h"

namespace stanok::client {

struct CheckedProgram {
  std::string file;  // as on the command line, or found below its folder
  Diagnostics diagnostics;
  std::uint64_t blocks = 0;
  double seconds = 0.0;  // wall time of the check
  std::vector<jobs::LawBlock> laws{};
  PlanePositions planes{};
};

// One row for each program and their sum: file, blocks, errors, warnings, time.
[[nodiscard]] std::string summary_table(const std::vector<CheckedProgram>& programs,
                                        const Terminal& terminal);

// {"files": [{"file", "blocks", "errors", "warnings", "seconds", "diagnostics", "tilted_planes"}],
// "totals": {...}}; planes as in protocol/contract/plane_json.h.
[[nodiscard]] nlohmann::ordered_json summary_json(const std::vector<CheckedProgram>& programs);

}  // namespace stanok::client
