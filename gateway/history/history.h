// History: what happened on the machines of a cell, in a database of either engine.
//
// Rows come from events of outboxes and are known by source and number: whoever writes an event
// again changes nothing. The same tables and the same queries for SQLite and PostgreSQL.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "gateway/database/database.h"
#include "gateway/outbox/outbox.h"

namespace stanok::gateway {

// A table of the history and its columns; source and number come first in each.
struct HistoryTable {
  std::string name;
  std::string time;  // the column by which rows get old
  std::vector<std::string> columns;
};
[[nodiscard]] const std::vector<HistoryTable>& history_tables();

class History {
 public:
  // Brings the tables to the newest version. Throws DatabaseError, also for a history of a newer
  // stanok.
  explicit History(const std::string& database);

  // All or none. Kinds that are no history are passed over. Throws DatabaseError.
  void store(const std::string& source, const std::vector<StoredEvent>& events);
  // Removes what is older.
  void forget_before(double time_s);

  // Rows of `from` that are not here yet; how many of each table were read.
  std::vector<std::int64_t> copy_from(History& from);

  [[nodiscard]] Database& database() { return *database_; }

 private:
  void migrate();
  void insert(const HistoryTable& table, std::span<const Row> rows);
  std::int64_t copy_table(const HistoryTable& table, History& from);

  std::unique_ptr<Database> database_;
};

}  // namespace stanok::gateway
