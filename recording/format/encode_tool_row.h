// The row of the tool at work to an LCM message and back.
#pragma once

#include <optional>
#include <stanok_messages/tool_row_t.hpp>

#include "channels/contract/tool_row.h"
#include "recording/format/encode.h"

namespace stanok::recording {

[[nodiscard]] tool_row_t to_tool_row(int channel, const channels::ToolRow& row, const Stamp& stamp);

// Nothing when the message says what no tool table can: on the bus and in a damaged log the numbers
// may be any.
[[nodiscard]] std::optional<channels::ToolRow> from_tool_row(const tool_row_t& message);

}  // namespace stanok::recording
