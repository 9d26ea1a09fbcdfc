// What a display shows of a channel beyond its state: tool, spindles, active codes, feeds, distance
// to go.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "channels/contract/machine_config.h"
#include "channels/contract/output.h"
#include "channels/stores/block_book.h"
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

// By the words of programs, from the programmed point to the end of the current block, a cycle
// being one block; null while no program runs.
[[nodiscard]] nlohmann::json distance_to_go(const channels::ChannelConfig& config,
                                            const channels::ChannelOutput& output,
                                            const channels::BlockReport& block);

}  // namespace stanok::daemon
