// Database: SQL that both engines of the gateway understand, SQLite and PostgreSQL.
//
// Values are texts, NULL is nothing; placeholders $1, $2, ... first appear in this order. Both
// engines take all statements: the engine is chosen once, where the database is opened. One thread.
#pragma once

#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace stanok::gateway {

using Value = std::optional<std::string>;
using Row = std::vector<Value>;
using Rows = std::vector<Row>;

// The database is away, full or does not understand.
class DatabaseError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

class Database {
 public:
  Database() = default;
  virtual ~Database() = default;
  Database(const Database&) = delete;
  Database& operator=(const Database&) = delete;

  // Throws DatabaseError.
  virtual Rows run(const std::string& sql, const Row& values = {}) = 0;
  // How a transaction that writes begins.
  [[nodiscard]] virtual std::string begin() const = 0;
};

// All or nothing: what is not committed is rolled back.
class Transaction {
 public:
  explicit Transaction(Database& database);
  ~Transaction();
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;

  void commit();

 private:
  Database& database_;
  bool is_open_ = true;
};

// `postgresql://...` is a server, anything else a file of SQLite, made where there is none. Throws
// DatabaseError.
[[nodiscard]] std::unique_ptr<Database> open_database(const std::string& name);

[[nodiscard]] bool is_server(const std::string& name);
// Whether the address of a server holds a password, which everybody on the computer could read.
// Throws DatabaseError where stanok has no PostgreSQL.
[[nodiscard]] bool holds_password(const std::string& name);

// With all its digits.
[[nodiscard]] std::string text_of(double number);
[[nodiscard]] double number_of(const Value& value);

}  // namespace stanok::gateway
