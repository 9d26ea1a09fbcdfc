// A situation of a log, for people and as JSON. Lengths mm, angles deg, axes by their words.
#pragma once

#include <nlohmann/json.hpp>
#include <stanok_messages/situation_t.hpp>
#include <string>
#include <vector>

#include "recording/read/log_contents.h"

namespace stanok::client {

// `contents` of the log that it is from: words of the axes, and when the log begins.
[[nodiscard]] nlohmann::ordered_json situation_json(const situation_t& situation,
                                                    const recording::LogContents& contents);

// Time, channel, number, work offset, tool, length and codes.
[[nodiscard]] std::vector<std::string> situation_row(const situation_t& situation,
                                                     const recording::LogContents& contents);

}  // namespace stanok::client
