// What the methods answer, as JSON Schema (draft 7): all members that a result has; others may be
// added.
//
// A row of the command table gives the shape of its result: JSON with types in the place of values:
// "string", "integer", "number", "boolean", "any", with a question mark where null stands for none;
// "$name" for a shape of its own; a list of one shape for an array of it; an object with the member
// "*" for one with any names. A member whose name ends with "?" may be left out.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "protocol/contract/method_table.h"

namespace stanok::protocol {

[[nodiscard]] nlohmann::json result_schema(const Method& method);

}  // namespace stanok::protocol
