#include "gateway/history/history.h"

#include <array>

#include "gateway/outbox/event_kinds.h"
#include "protocol/contract/json_text.h"

namespace stanok::gateway {
namespace {

using nlohmann::json;

// Each entry leads to the next version; none is ever changed. DOUBLE PRECISION and BIGINT are what
// both engines understand.
const std::vector<std::vector<std::string>>& migrations() {
  // NOLINTBEGIN(bugprone-suspicious-missing-comma): statements go on in the next line
  static const std::vector<std::vector<std::string>> steps{
      {"CREATE TABLE runs (source TEXT NOT NULL, number BIGINT NOT NULL, machine TEXT NOT NULL, "
       "channel INTEGER NOT NULL, program TEXT NOT NULL, version TEXT NOT NULL, begun_s DOUBLE "
       "PRECISION NOT NULL, ended_s DOUBLE PRECISION NOT NULL, time_s DOUBLE PRECISION NOT NULL, "
       "path_mm DOUBLE PRECISION NOT NULL, blocks BIGINT NOT NULL, ok INTEGER NOT NULL, PRIMARY "
       "KEY (source, number))",
       "CREATE INDEX runs_by_time ON runs (ended_s)",
       "CREATE INDEX runs_by_machine ON runs (machine, ended_s)",
       "CREATE INDEX runs_by_text ON runs (machine, program, version, ended_s, ok, time_s)",
       "CREATE TABLE alarms (source TEXT NOT NULL, number BIGINT NOT NULL, machine TEXT NOT NULL, "
       "time_s DOUBLE PRECISION NOT NULL, channel INTEGER NOT NULL, code TEXT NOT NULL, text TEXT "
       "NOT NULL, file TEXT, line BIGINT, PRIMARY KEY (source, number))",
       "CREATE INDEX alarms_by_time ON alarms (time_s)",
       "CREATE INDEX alarms_by_machine ON alarms (machine, time_s)",
       "CREATE TABLE tool_use (source TEXT NOT NULL, number BIGINT NOT NULL, machine TEXT NOT "
       "NULL, time_s DOUBLE PRECISION NOT NULL, tool INTEGER NOT NULL, use_s DOUBLE PRECISION NOT "
       "NULL, PRIMARY KEY (source, number))",
       "CREATE INDEX tool_use_by_time ON tool_use (time_s)",
       "CREATE TABLE measurements (source TEXT NOT NULL, number BIGINT NOT NULL, machine TEXT NOT "
       "NULL, time_s DOUBLE PRECISION NOT NULL, channel INTEGER NOT NULL, text TEXT NOT NULL, "
       "PRIMARY KEY (source, number))",
       "CREATE INDEX measurements_by_time ON measurements (time_s)"}};
  // NOLINTEND(bugprone-suspicious-missing-comma)
  return steps;
}

const HistoryTable* table_of(std::string_view kind) {
  const auto& tables = history_tables();
  if (kind == event::run_ended) return &tables[0];
  if (kind == event::alarm) return &tables[1];
  if (kind == event::tool_use) return &tables[2];
  if (kind == event::measurement) return &tables[3];
  return nullptr;
}

Value value_of(const json& member) {
  if (member.is_null()) return std::nullopt;
  if (member.is_string()) return member.get<std::string>();
  if (member.is_boolean()) return member.get<bool>() ? "1" : "0";
  return protocol::json_text(member);
}

Row row_of(const HistoryTable& table, const std::string& source, const StoredEvent& stored) {
  json members = stored.event.content;
  members["source"] = source;
  members["number"] = stored.number;
  members["machine"] = stored.event.machine;
  if (!members.contains("time_s")) members["time_s"] = stored.event.time_s;
  Row row;
  for (const std::string& column : table.columns)
    row.push_back(value_of(members.value(column, json())));
  return row;
}

std::string list_of(const std::vector<std::string>& columns) {
  std::string list;
  for (const std::string& column : columns) list += (list.empty() ? "" : ", ") + column;
  return list;
}

}  // namespace

const std::vector<HistoryTable>& history_tables() {
  static const std::vector<HistoryTable> tables{
      {"runs",
       "ended_s",
       {"source", "number", "machine", "channel", "program", "version", "begun_s", "ended_s",
        "time_s", "path_mm", "blocks", "ok"}},
      {"alarms",
       "time_s",
       {"source", "number", "machine", "time_s", "channel", "code", "text", "file", "line"}},
      {"tool_use", "time_s", {"source", "number", "machine", "time_s", "tool", "use_s"}},
      {"measurements", "time_s", {"source", "number", "machine", "time_s", "channel", "text"}},
  };
  return tables;
}

History::History(const std::string& database) : database_(open_database(database)) {
  migrate();
}

void History::migrate() {
  Transaction transaction(*database_);
  database_->run("CREATE TABLE IF NOT EXISTS schema_version (version INTEGER NOT NULL)");
  const Rows rows = database_->run("SELECT version FROM schema_version");
  const std::size_t newest = migrations().size();
  const std::size_t version = rows.empty() ? 0 : std::stoul(*rows[0][0]);
  if (version > newest)
    throw DatabaseError("the history has version " + std::to_string(version) +
                        ", created by a newer stanok; this one supports " + std::to_string(newest));
  for (std::size_t step = version; step < newest; ++step)
    for (const std::string& statement : migrations().at(step)) database_->run(statement);
  if (rows.empty())
    database_->run("INSERT INTO schema_version VALUES ($1)", {std::to_string(newest)});
  else
    database_->run("UPDATE schema_version SET version = $1", {std::to_string(newest)});
  transaction.commit();
}

void History::store(const std::string& source, const std::vector<StoredEvent>& events) {
  Transaction transaction(*database_);
  for (const StoredEvent& stored : events)
    if (const HistoryTable* table = table_of(stored.event.kind))
      insert(*table, std::array{row_of(*table, source, stored)});
  transaction.commit();
}

void History::insert(const HistoryTable& table, std::span<const Row> rows) {
  std::string sql = "INSERT INTO " + table.name + " (" + list_of(table.columns) + ") VALUES ";
  Row values;
  for (const Row& row : rows) {
    sql += values.empty() ? "(" : "), (";
    for (std::size_t i = 0; i < row.size(); ++i) {
      values.push_back(row[i]);
      sql += (i == 0 ? "$" : ", $") + std::to_string(values.size());
    }
  }
  database_->run(sql + ") ON CONFLICT (source, number) DO NOTHING", values);
}

void History::forget_before(double time_s) {
  for (const HistoryTable& table : history_tables())
    database_->run("DELETE FROM " + table.name + " WHERE " + table.time + " < $1",
                   {text_of(time_s)});
}

std::vector<std::int64_t> History::copy_from(History& from) {
  std::vector<std::int64_t> counts;
  for (const HistoryTable& table : history_tables()) counts.push_back(copy_table(table, from));
  return counts;
}

std::int64_t History::copy_table(const HistoryTable& table, History& from) {
  const std::string sql = "SELECT " + list_of(table.columns) + " FROM " + table.name +
                          " WHERE (source, number) > ($1, $2) ORDER BY source, number LIMIT 500";
  std::int64_t count = 0;
  Row last{"", "0"};
  while (true) {
    const Rows rows = from.database().run(sql, last);
    if (rows.empty()) return count;
    Transaction transaction(*database_);
    insert(table, rows);
    transaction.commit();
    count += static_cast<std::int64_t>(rows.size());
    last = {rows.back()[0], rows.back()[1]};
  }
}

}  // namespace stanok::gateway
