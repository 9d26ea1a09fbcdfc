// The status of a channel as an operator reads it: program, codes, feed in mm/min, spindles, tool,
// and a table of the axes in the order of the machine file.
//
// `status` is the result of channel.status or the channel of a subscription; members that are not
// known here are shown by name below.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "client/terminal/terminal.h"

namespace stanok::client {

[[nodiscard]] std::string channel_text(const nlohmann::json& status, const Terminal& terminal);

// The values of an object by axes or words, in the order of the channel: "X 1.5000  Y -2".
[[nodiscard]] std::string position_text(const nlohmann::json& status);

// The answer to channel.position: a word a line, or, where the answer has them, a table for each
// word with the terms that lead to it.
[[nodiscard]] std::string origin_text(const nlohmann::json& result, const Terminal& terminal);

// The channels of a subscription, by their numbers: as text "10" would come before "2".
[[nodiscard]] std::vector<nlohmann::json> channels_in_order(const nlohmann::json& channels);

// The same status with its axes in the order of the machine file, for output as JSON.
[[nodiscard]] nlohmann::ordered_json in_machine_order(const nlohmann::json& status);

// "1:04:09", "4:09"; "-" for none.
[[nodiscard]] std::string duration_text(const nlohmann::json& seconds);

}  // namespace stanok::client
