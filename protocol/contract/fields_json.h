// Fields of a result as JSON, the same in `stanok ... --json`, in answers of the daemon and in
// Python.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "base/fields.h"

namespace stanok::protocol {

// Null where a value is none.
[[nodiscard]] nlohmann::ordered_json fields_json(const Fields& fields);
[[nodiscard]] nlohmann::ordered_json list_json(const FieldList& list);

// Appends the object and an end of line; numbers as short as they are ("1", not "1.0").
void append_json_line(std::string& text, const Fields& fields);

}  // namespace stanok::protocol
