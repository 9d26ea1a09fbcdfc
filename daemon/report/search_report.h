// A block search as an operator sees it.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "channels/contract/output.h"
#include "channels/contract/reports.h"

namespace stanok::daemon {

// {"target": "a.nc:12", "calculated", "units", "diameter": [word], "position": {word: value},
//  "point_W", "stands_at", "work_offset", "tool", "tool_prepared",
//  "spindles": [...], "coolant", "feed_law", "not_executed": [...]}; the members behind
//  "calculated" only for a search with calculation. mm, deg, rev/min, m/min.
// `output` is that of the channel now.
[[nodiscard]] nlohmann::json search_json(const channels::SearchReport& report,
                                         const channels::ChannelOutput& output);

// What a start would change at the height of the approach: "tool 3 instead of 1", "spindle 1
// turning", "coolant flood".
[[nodiscard]] std::vector<std::string> changes_of_start(const channels::SearchReport& report,
                                                        const channels::ChannelOutput& output);

}  // namespace stanok::daemon
