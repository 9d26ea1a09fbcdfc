// What a display shows of a channel beyond its state: tool, spindles, active codes, feeds, distance
// to go.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "channels/contract/machine_config.h"
#include "channels/contract/output.h"
#include "channels/contract/reports.h"
#include "drives/bus.h"

namespace stanok::daemon {

// {"number", "edge", "name"}; number 0 and no name: there is none.
[[nodiscard]] nlohmann::json tool_at_work(const channels::ToolAtWork& tool,
                                          const channels::TablesConfig& tables);

// Of every spindle of the channel what it is asked for in this cycle, its ramp made, and what its
// drive measures; null without a drive that answers. Clockwise > 0.
[[nodiscard]] nlohmann::json spindles_of(const channels::ChannelConfig& config,
                                         const channels::ChannelOutput& output,
                                         const drives::BusStatus& bus);

// {"for", "number", "channels"}: for what the channel waits: "dwell", "spindle", "brakes", "end" of
// a run, "mark", "input", "channel", "machine"; null: for nothing.
[[nodiscard]] nlohmann::json wait_of(const channels::ChannelOutput& output);

// {"blocks", "to_line", "line"}: how far the axes of a held program can go back along its path, and
// where they are on that way; null: on the path itself.
[[nodiscard]] nlohmann::json retrace_of(const channels::RetraceState& state);

// Of the active codes: G54 and the like; those that switch coolant. Null, empty: none.
[[nodiscard]] nlohmann::json work_offset_of(const std::vector<std::string>& g_codes);
[[nodiscard]] nlohmann::json coolant_of(const std::vector<std::string>& m_codes);

// The active codes; of spindle and coolant those that were ordered last, whoever did.
[[nodiscard]] lang::ActiveCodes codes_in_effect(const lang::Meaning& meaning,
                                                const channels::ChannelOutput& output);

// The words that lead to the programmed point; mm and deg, diameters where they are active.
[[nodiscard]] nlohmann::json position_of(const channels::ChannelConfig& config,
                                         const channels::ChannelOutput& output,
                                         const lang::Meaning& meaning);
// The programmed point itself, in the workpiece system: radii.
[[nodiscard]] nlohmann::json point_of(const channels::ChannelConfig& config,
                                      const channels::ChannelOutput& output);
// The words that are diameters.
[[nodiscard]] nlohmann::json diameters_of(const channels::ChannelConfig& config,
                                          const lang::Meaning& meaning);

// By the words of programs, from the programmed point to the end of the current block, a cycle
// being one block; null while no program runs.
[[nodiscard]] nlohmann::json distance_to_go(const channels::ChannelConfig& config,
                                            const channels::ChannelOutput& output,
                                            const channels::SituationReport& situation);

}  // namespace stanok::daemon
