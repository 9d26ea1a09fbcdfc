// Where the rotary axes stand in tilted planes, for people: the same of `stanok check` and of the
// check by a daemon.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "client/terminal/terminal.h"

namespace stanok::client {

// One row for each of `planes` (protocol/contract/plane_json.h); empty without one.
[[nodiscard]] std::string plane_table(const nlohmann::ordered_json& planes,
                                      const Terminal& terminal);

}  // namespace stanok::client
