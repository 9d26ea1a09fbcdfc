// What the machine is made of, as JSON: drives, tools, offsets, programs, recorder
// (docs/reference/protocol.md, "Results").
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>

#include "daemon/cycle/running_machine.h"

namespace stanok::daemon {

// One edge, by the keys of the tables file.
[[nodiscard]] nlohmann::json tool_json(const channels::ToolEdge& tool);
[[nodiscard]] nlohmann::json tool_list(RunningMachine& machine);
// Nothing: there is no such edge.
[[nodiscard]] std::optional<nlohmann::json> tool_edge(RunningMachine& machine, int number,
                                                      int edge);
// All tools and work offsets as a text that tool.load and the machine file take.
[[nodiscard]] nlohmann::json tables_text(RunningMachine& machine);
[[nodiscard]] nlohmann::json offset_list(RunningMachine& machine);
// What programs announced with #workpiece and #workpiece_pos, by channel.
[[nodiscard]] nlohmann::json workpiece_status(RunningMachine& machine);
[[nodiscard]] nlohmann::json log_status(RunningMachine& machine);

// Regular files beneath the root, by name; links are not followed, hidden files and folders left
// out. "complete" is false when there are more than `files_max`.
[[nodiscard]] nlohmann::json program_list(const std::filesystem::path& root,
                                          std::size_t files_max = 10000);

}  // namespace stanok::daemon
