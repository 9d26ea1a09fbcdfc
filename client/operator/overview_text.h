// The state of all channels on a few lines, as `stanok watch` draws it.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "client/terminal/terminal.h"

namespace stanok::client {

// `channels` as in a status notification (docs/reference/protocol.md): a table with one row per
// channel, and below it the active alarms.
[[nodiscard]] std::string overview_text(const nlohmann::json& channels, const Terminal& terminal);

}  // namespace stanok::client
