// The summary of a log, for people and as JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "client/terminal/terminal.h"
#include "recording/read/log_contents.h"

namespace stanok::client {

[[nodiscard]] std::string text_of(const recording::LogContents& contents, const Terminal& terminal);
[[nodiscard]] nlohmann::ordered_json to_json(const recording::LogContents& contents);

}  // namespace stanok::client
