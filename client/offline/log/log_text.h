// What people read of a log: its summary, and a row for each of its situations.
#pragma once

#include <stanok_messages/situation_t.hpp>
#include <string>
#include <vector>

#include "client/terminal/terminal.h"
#include "recording/read/log_contents.h"

namespace stanok::client {

[[nodiscard]] std::string text_of(const recording::LogContents& contents, const Terminal& terminal);

// Time, channel, number, work offset, tool, length and codes. `contents` of the log that it is
// from.
[[nodiscard]] std::vector<std::string> situation_row(const situation_t& situation,
                                                     const recording::LogContents& contents);

}  // namespace stanok::client
