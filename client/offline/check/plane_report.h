// What `stanok check` tells of the tilted planes of programs: where the rotary axes will stand, as
// a table and as JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "client/offline/check/check_report.h"

namespace stanok::client {

// One row for each place that aligns the tool, and each position that it brings; empty without one.
[[nodiscard]] std::string plane_table(const std::vector<CheckedProgram>& programs,
                                      const Terminal& terminal);

// [{"file", "line", "tool": [x, y, z], "axes": {"A": deg, ...}, "other": {"word": "P1" | "P2",
// "axes": {...}, "limit"}}]. "tool" is the direction of the tool on the table, from its tip into
// the spindle. "other" is the position with the other sign of the first rotary axis, absent where
// there is none; with "limit" its one axis cannot stand there, but only up to this angle.
[[nodiscard]] nlohmann::ordered_json plane_json(const std::vector<CheckedProgram>& programs);

}  // namespace stanok::client
