// SqliteDatabase: a file of SQLite. Several processes may have it open: readers never wait, who
// writes waits for another one for five seconds.
#pragma once

#include <sqlite3.h>

#include <filesystem>
#include <map>
#include <memory>
#include <string>

#include "gateway/database/database.h"

namespace stanok::gateway {

class SqliteDatabase final : public Database {
 public:
  // Throws DatabaseError.
  explicit SqliteDatabase(const std::filesystem::path& file);

  Rows run(const std::string& sql, const Row& values = {}) override;
  [[nodiscard]] std::string begin() const override { return "BEGIN IMMEDIATE"; }

 private:
  struct Close {
    void operator()(sqlite3* database) const { sqlite3_close_v2(database); }
    void operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }
  };
  using Statement = std::unique_ptr<sqlite3_stmt, Close>;

  // Prepared once and kept.
  sqlite3_stmt* statement(const std::string& sql);
  [[nodiscard]] DatabaseError error(const std::string& doing) const;

  std::string file_;
  std::unique_ptr<sqlite3, Close> database_;
  std::map<std::string, Statement> statements_;
};

}  // namespace stanok::gateway
