#include "gateway/history/queries.h"

#include <array>
#include <cstdint>
#include <string>

#include "gateway/outbox/wall_clock.h"

namespace stanok::gateway {
namespace {

using enum ColumnKind;

constexpr std::array run_columns{
    Column{"ended", time},     Column{"machine", text},  Column{"channel", number},
    Column{"program", text},   Column{"version", text},  Column{"time_s", number},
    Column{"path_mm", number}, Column{"blocks", number}, Column{"ok", yes_no}};
constexpr std::string_view runs_sql =
    "SELECT ended_s, machine, channel, program, version, time_s, path_mm, blocks, ok FROM runs "
    "WHERE ended_s >= $1 AND ($2 = '' OR machine = $2) ORDER BY ended_s DESC, source, number LIMIT "
    "1000";

constexpr std::array alarm_columns{
    Column{"time", time}, Column{"machine", text}, Column{"channel", number}, Column{"code", text},
    Column{"text", text}, Column{"file", text},    Column{"line", number}};
constexpr std::string_view alarms_sql =
    "SELECT time_s, machine, channel, code, text, file, line FROM alarms WHERE time_s >= $1 AND "
    "($2 = '' OR machine = $2) ORDER BY time_s DESC, source, number LIMIT 1000";

// OEE by its three factors (ISO 22400-2): what of the time since then a program ran; how near its
// runs that ended well come to the shortest one of the same text; what part of the runs ended well.
constexpr std::array oee_columns{
    Column{"machine", text},        Column{"channel", number},       Column{"runs", number},
    Column{"availability", number}, Column{"effectiveness", number}, Column{"quality", number},
    Column{"oee", number}};
constexpr std::string_view oee_sql =
    "WITH texts AS (SELECT machine, channel, COUNT(*) AS runs, SUM(ok) AS good, SUM(time_s) AS "
    "all_s, SUM(CASE WHEN ok = 1 THEN time_s END) AS good_s, MIN(CASE WHEN ok = 1 THEN time_s END) "
    "AS best_s FROM runs WHERE ended_s >= $1 AND ($2 = '' OR machine = $2) GROUP BY machine, "
    "channel, program, version), factors AS (SELECT machine, channel, SUM(runs) AS runs, "
    "SUM(all_s) "
    "/ (CAST($3 AS DOUBLE PRECISION) - CAST($1 AS DOUBLE PRECISION)) AS availability, SUM(best_s * "
    "good) / SUM(CASE WHEN good_s > 0 THEN good_s END) AS effectiveness, CAST(SUM(good) AS DOUBLE "
    "PRECISION) / SUM(runs) AS quality FROM texts GROUP BY machine, channel) SELECT machine, "
    "channel, runs, availability, effectiveness, quality, availability * effectiveness * quality "
    "FROM factors ORDER BY machine, channel";

constexpr std::array tool_columns{Column{"machine", text}, Column{"tool", number},
                                  Column{"runs", number}, Column{"use_s", number},
                                  Column{"last", time}};
constexpr std::string_view tools_sql =
    "SELECT machine, tool, COUNT(*), SUM(use_s), MAX(time_s) FROM tool_use WHERE time_s >= $1 AND "
    "($2 = '' OR machine = $2) GROUP BY machine, tool ORDER BY machine, tool";

constexpr std::array drift_columns{Column{"machine", text},   Column{"program", text},
                                   Column{"version", text},   Column{"runs", number},
                                   Column{"first_s", number}, Column{"last_s", number},
                                   Column{"drift", number}};
// Texts with enough good runs; what remains is asked of each (`drift_rows`), so that no engine has
// to sort the runs of all.
constexpr std::string_view drift_sql =
    "SELECT machine, program, version, COUNT(*) FROM runs WHERE ok = 1 AND ended_s >= $1 AND ($2 = "
    "'' OR machine = $2) GROUP BY machine, program, version HAVING COUNT(*) >= 8 ORDER BY machine, "
    "program, version";
// Mean over so many runs of a text, the oldest or the newest of them.
constexpr std::string_view oldest_sql =
    "SELECT AVG(time_s) FROM (SELECT time_s FROM runs WHERE machine = $1 AND program = $2 AND "
    "version = $3 AND ok = 1 AND ended_s >= $4 ORDER BY ended_s LIMIT $5) AS quarter";
constexpr std::string_view newest_sql =
    "SELECT AVG(time_s) FROM (SELECT time_s FROM runs WHERE machine = $1 AND program = $2 AND "
    "version = $3 AND ok = 1 AND ended_s >= $4 ORDER BY ended_s DESC LIMIT $5) AS quarter";

constexpr std::array all{
    Query{"runs", "list program runs, newest first, at most 1000", runs_sql, run_columns},
    Query{"alarms", "list alarms, newest first, at most 1000", alarms_sql, alarm_columns},
    Query{"oee", "show the use of each machine: availability, effectiveness, quality", oee_sql,
          oee_columns},
    Query{"tools", "show how long each tool was used in running programs", tools_sql, tool_columns},
    Query{"drift",
          "compare cycle times of the same program text: first and last quarter of its runs",
          drift_sql, drift_columns},
};

// Means of the first and of the last quarter of the runs of the same text. Where their number is no
// multiple of four the first one has one more.
Rows drift_rows(Database& database, const Rows& texts, double since_s) {
  constexpr std::int64_t quarters = 4;
  Rows rows;
  for (const Row& one : texts) {
    const std::int64_t runs = std::stoll(*one[3]);
    const auto mean_of = [&](std::string_view sql, std::int64_t count) {
      return database
          .run(std::string(sql), {one[0], one[1], one[2], text_of(since_s), std::to_string(count)})
          .at(0)
          .at(0);
    };
    const Value first = mean_of(oldest_sql, (runs + quarters - 1) / quarters);
    const Value last = mean_of(newest_sql, runs / quarters);
    const double first_s = number_of(first);
    if (!(first_s > 0.0)) continue;
    rows.push_back({one[0], one[1], one[2], one[3], first, last,
                    text_of((number_of(last) - first_s) / first_s)});
  }
  return rows;
}

}  // namespace

std::span<const Query> queries() {
  return all;
}

Rows ask(History& history, const Query& query, double since_s, const std::string& machine) {
  Row values{text_of(since_s), machine};
  const std::string sql(query.sql);
  if (sql.find("$3") != std::string::npos) values.emplace_back(text_of(wall_clock_s()));
  Rows rows = history.database().run(sql, values);
  return query.sql == drift_sql ? drift_rows(history.database(), rows, since_s) : rows;
}

}  // namespace stanok::gateway
