// What `stanok check --estimate` tells of the blocks under a feed law: as a table and as JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "client/offline/check/check_report.h"

namespace stanok::client {

// One row for each block under a law; what it has none of is left out.
[[nodiscard]] std::string estimate_table(const std::vector<CheckedProgram>& programs,
                                         const Terminal& terminal);

// {"diagnostics": [as `check --json`], "feed_laws": [{"file", "line", "law", "path_mm",
// "increments", "feed_first", "feed_last", "feed_unit", "time_s", "time_is_least",
// "closed_form_s", "cycle_s", "cycle_closed_form_s", "k_a", "k_b", "k_m"}], "tilted_planes": [as in
// protocol/contract/plane_json.h]}; "feed_unit" is "mm/min" or "mm/rev", fields without a value are
// absent.
[[nodiscard]] nlohmann::ordered_json estimate_json(const std::vector<CheckedProgram>& programs);

}  // namespace stanok::client
