// What the methods answer, as JSON Schema (draft 7): all members that a result has; others may be
// added.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string_view>

namespace stanok::protocol {

// Of a method of the table.
[[nodiscard]] nlohmann::json result_schema(std::string_view method);

}  // namespace stanok::protocol
