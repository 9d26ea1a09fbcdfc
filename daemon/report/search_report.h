// A block search as an operator sees it, and whether a start means what was seen.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "channels/contract/output.h"
#include "channels/contract/reports.h"
#include "daemon/cycle/running_machine.h"
#include "protocol/contract/failure.h"

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

// Why `program.start` with these parameters is refused; nothing: no search waits for the start, or
// it is the one whose number is given, nothing has changed since, and what the start changes in the
// spindle was asked for.
[[nodiscard]] std::optional<protocol::Failure> obstacle_to_start(RunningMachine& machine,
                                                                 int channel,
                                                                 const nlohmann::json& parameters);

}  // namespace stanok::daemon
