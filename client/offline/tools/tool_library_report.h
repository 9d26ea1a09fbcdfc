// What `tool import` and `tool export` say: what is not carried, what was assumed, what is wrong.
#pragma once

#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "config/text/config_error.h"
#include "jobs/tools/foreign_tools.h"

namespace stanok::client {

// A line for each tool, with its fields.
[[nodiscard]] std::string to_text(std::span<const jobs::NotCarried> not_carried);
[[nodiscard]] nlohmann::ordered_json to_json(std::span<const jobs::NotCarried> not_carried);

// The faults of a file, as `--json` has them.
[[nodiscard]] nlohmann::ordered_json refusal_json(const config::ConfigError& error);

}  // namespace stanok::client
