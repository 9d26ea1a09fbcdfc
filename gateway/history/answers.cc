#include "gateway/history/answers.h"

#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <stdexcept>

#include "gateway/outbox/wall_clock.h"

namespace stanok::gateway {
namespace {

using nlohmann::json;

std::string_view name_of(ColumnKind kind) {
  switch (kind) {
    case ColumnKind::text:
      return "text";
    case ColumnKind::number:
      return "number";
    case ColumnKind::time:
      return "time";
    case ColumnKind::yes_no:
      return "yes_no";
  }
  return "";
}

}  // namespace

std::optional<double> time_back_from_now(std::string_view text) {
  double count = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), count);
  const std::string_view unit(end, static_cast<std::size_t>(text.data() + text.size() - end));
  const double unit_s = unit == "d" ? 86400.0 : unit == "h" ? 3600.0 : unit == "min" ? 60.0 : 0.0;
  if (error != std::errc() || unit_s == 0.0 || !(count > 0.0)) return std::nullopt;
  return wall_clock_s() - count * unit_s;
}

const Query* find_query(std::string_view name) {
  const auto query = std::ranges::find(queries(), name, &Query::name);
  return query == queries().end() ? nullptr : &*query;
}

std::unique_ptr<History> open_history(const std::string& database) {
  if (!is_server(database) && access(database.c_str(), F_OK) != 0)
    throw std::runtime_error("there is no history " + database +
                             "; name it with --database (stanok) or --history (stanok-web), as "
                             "with stanok-gateway --history");
  return std::make_unique<History>(database);
}

json json_of(const Value& value, ColumnKind kind) {
  if (!value) return nullptr;
  if (kind == ColumnKind::text) return *value;
  if (kind == ColumnKind::yes_no) return *value == "1";
  return number_of(value);
}

json table_json(const Query& query, const Rows& rows) {
  json columns = json::array();
  for (const Column& column : query.columns)
    columns.push_back({{"name", column.name}, {"kind", name_of(column.kind)}});
  json lines = json::array();
  for (const Row& row : rows) {
    json line = json::array();
    for (std::size_t i = 0; i < row.size(); ++i)
      line.push_back(json_of(row[i], query.columns[i].kind));
    lines.push_back(std::move(line));
  }
  return {{"query", query.name}, {"columns", std::move(columns)}, {"rows", std::move(lines)}};
}

}  // namespace stanok::gateway
