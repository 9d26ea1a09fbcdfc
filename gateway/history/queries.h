// What is asked of a history: runs, alarms, use of machines and tools, drift of cycle times. The
// same statements for both engines.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "gateway/history/history.h"

namespace stanok::gateway {

enum class ColumnKind : std::uint8_t { text, number, time, yes_no };

struct Column {
  std::string_view name;
  ColumnKind kind;
};

struct Query {
  std::string_view name;  // as a verb of `stanok history`
  std::string_view help;
  std::string_view sql;  // $1: since when, in s since 1970; $2: a machine, or empty; $3: now, in s
  std::span<const Column> columns;
};

[[nodiscard]] std::span<const Query> queries();

// Empty `machine`: all of them. Throws DatabaseError.
[[nodiscard]] Rows ask(History& history, const Query& query, double since_s,
                       const std::string& machine);

}  // namespace stanok::gateway
