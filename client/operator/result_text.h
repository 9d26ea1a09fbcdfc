// Results of operator methods as text for people.
//
// Lists become tables with the columns named in one list per method; single objects become lines
// "name: value". What has no list of its own is shown member by member, so that nothing is hidden.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "client/terminal/terminal.h"

namespace stanok::client {

// Ends with a line end; "" where there is nothing to say but that it was done.
[[nodiscard]] std::string result_text(std::string_view method, const nlohmann::json& result,
                                      const Terminal& terminal);

// Exit code of a command whose result says that something is wrong ("ok": false): that of its first
// error, or of its alarm; 1 where it names none. Everything else is 0.
[[nodiscard]] int result_exit_code(const nlohmann::json& result);

// A value in one cell: numbers short, lists and objects in one line, null as "-".
[[nodiscard]] std::string cell_text(const nlohmann::json& value);

}  // namespace stanok::client
