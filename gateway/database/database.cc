#include "gateway/database/database.h"

#include <array>
#include <charconv>

#include "gateway/database/postgres.h"
#include "gateway/database/sqlite_database.h"

namespace stanok::gateway {

Transaction::Transaction(Database& database) : database_(database) {
  database_.run(database_.begin());
}

Transaction::~Transaction() {
  if (!is_open_) return;
  try {
    database_.run("ROLLBACK");
  } catch (const DatabaseError&) {  // NOLINT(bugprone-empty-catch)
    // The connection has gone, and the transaction with it.
  }
}

void Transaction::commit() {
  database_.run("COMMIT");
  is_open_ = false;
}

bool is_server(const std::string& name) {
  return name.starts_with("postgresql://") || name.starts_with("postgres://");
}

bool holds_password(const std::string& name) {
  return is_server(name) && postgres().holds_password(name);
}

std::unique_ptr<Database> open_database(const std::string& name) {
  if (is_server(name)) return postgres().open(name);
  return std::make_unique<SqliteDatabase>(name);
}

std::string text_of(double number) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), number).ptr;
  return {text.data(), end};
}

double number_of(const Value& value) {
  double number = 0.0;
  if (value) std::from_chars(value->data(), value->data() + value->size(), number);
  return number;
}

}  // namespace stanok::gateway
