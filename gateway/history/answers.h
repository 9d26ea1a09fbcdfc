// How questions to a history are put and answered outside of SQL: times back from now, values as
// JSON, a history that must be there.
#pragma once

#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "gateway/history/queries.h"

namespace stanok::gateway {

// "30d", "12h", "45min", back from now, in s since 1970; nothing: it is none of these.
[[nodiscard]] std::optional<double> time_back_from_now(std::string_view text);

// nullptr: there is no such query.
[[nodiscard]] const Query* find_query(std::string_view name);

// A file that is not there is a mistake, not a history without entries. Throws std::runtime_error.
[[nodiscard]] std::unique_ptr<History> open_history(const std::string& database);

// A value as its column has it; NULL is null.
[[nodiscard]] nlohmann::json json_of(const Value& value, ColumnKind kind);
// {"query", "columns": [{"name", "kind"}], "rows": [[...]]}; kinds: text, number, time, yes_no.
[[nodiscard]] nlohmann::json table_json(const Query& query, const Rows& rows);

}  // namespace stanok::gateway
