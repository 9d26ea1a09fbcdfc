#include "gateway/database/sqlite_database.h"

namespace stanok::gateway {
namespace {

constexpr int patience_ms = 5000;

// A statement is reset however its use ends: one that is not holds a lock.
class Use {
 public:
  explicit Use(sqlite3_stmt* statement) : statement_(statement) {}
  ~Use() {
    sqlite3_reset(statement_);
    sqlite3_clear_bindings(statement_);
  }
  Use(const Use&) = delete;
  Use& operator=(const Use&) = delete;

 private:
  sqlite3_stmt* statement_;
};

void bind(sqlite3_stmt* statement, const Row& values) {
  int place = 0;
  for (const Value& value : values) {
    ++place;
    if (!value) continue;
    sqlite3_bind_text64(statement, place, value->data(), value->size(), SQLITE_TRANSIENT,
                        SQLITE_UTF8);
  }
}

Row row_of(sqlite3_stmt* statement) {
  Row row;
  for (int column = 0; column < sqlite3_column_count(statement); ++column) {
    // Through the number: SQLite writes only 15 of its 17 digits.
    if (sqlite3_column_type(statement, column) == SQLITE_FLOAT) {
      row.emplace_back(text_of(sqlite3_column_double(statement, column)));
      continue;
    }
    const auto* text = reinterpret_cast<const char*>(sqlite3_column_text(statement, column));
    row.push_back(text == nullptr ? Value() : Value(text));
  }
  return row;
}

}  // namespace

SqliteDatabase::SqliteDatabase(const std::filesystem::path& file) : file_(file.string()) {
  sqlite3* opened = nullptr;
  const int result =
      sqlite3_open_v2(file_.c_str(), &opened,
                      SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE | SQLITE_OPEN_NOMUTEX, nullptr);
  database_.reset(opened);
  if (result != SQLITE_OK) throw error("cannot be opened");
  sqlite3_busy_timeout(opened, patience_ms);
  run("PRAGMA journal_mode = WAL");
  // What is committed survives a loss of power.
  run("PRAGMA synchronous = FULL");
}

Rows SqliteDatabase::run(const std::string& sql, const Row& values) {
  sqlite3_stmt* const prepared = statement(sql);
  const Use use(prepared);
  bind(prepared, values);
  Rows rows;
  int result = sqlite3_step(prepared);
  for (; result == SQLITE_ROW; result = sqlite3_step(prepared)) rows.push_back(row_of(prepared));
  if (result != SQLITE_DONE) throw error(sql);
  return rows;
}

sqlite3_stmt* SqliteDatabase::statement(const std::string& sql) {
  const auto known = statements_.find(sql);
  if (known != statements_.end()) return known->second.get();
  sqlite3_stmt* prepared = nullptr;
  const auto bytes = static_cast<int>(sql.size());
  if (sqlite3_prepare_v2(database_.get(), sql.data(), bytes, &prepared, nullptr) != SQLITE_OK)
    throw error(sql);
  return statements_.emplace(sql, Statement(prepared)).first->second.get();
}

DatabaseError SqliteDatabase::error(const std::string& doing) const {
  return DatabaseError(file_ + ": " + sqlite3_errmsg(database_.get()) + " (" + doing + ")");
}

}  // namespace stanok::gateway
