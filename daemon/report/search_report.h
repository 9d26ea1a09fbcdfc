// A block search as an operator sees it.
#pragma once

#include <nlohmann/json.hpp>

#include "channels/contract/reports.h"

namespace stanok::daemon {

// {"target": "a.nc:12", "calculated", "units", "diameter": [word], "position": {word: value},
//  "point_W", "stands_at", "work_offset", "tool", "tool_prepared",
//  "spindles": [...], "coolant", "feed_law", "not_executed": [...]}; the members behind
//  "calculated" only for a search with calculation. mm, deg, rev/min, m/min.
[[nodiscard]] nlohmann::json search_json(const channels::SearchReport& report);

}  // namespace stanok::daemon
