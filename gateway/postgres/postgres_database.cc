#include "gateway/postgres/postgres_database.h"

#include <array>
#include <string_view>

namespace stanok::gateway {
namespace {

struct Clear {
  void operator()(PGresult* result) const { PQclear(result); }
  void operator()(PQconninfoOption* options) const { PQconninfoFree(options); }
};

Rows rows_of(const PGresult& result) {
  Rows rows;
  const int columns = PQnfields(&result);
  for (int i = 0; i < PQntuples(&result); ++i) {
    Row row;
    for (int column = 0; column < columns; ++column) {
      const bool is_null = PQgetisnull(&result, i, column) == 1;
      row.push_back(is_null ? Value() : Value(PQgetvalue(&result, i, column)));
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

// Notices ("relation exists already") are nothing to tell.
void ignore_notice(void* /*unused*/, const char* /*text*/) {}

std::string first_line(const std::string& text) {
  return text.substr(0, text.find('\n'));
}

}  // namespace

PostgresDatabase::PostgresDatabase(const std::string& address) {
  // The address comes last and wins. A server that goes silently is found out by keepalives.
  constexpr std::array names{"connect_timeout",
                             "keepalives_idle",
                             "keepalives_interval",
                             "keepalives_count",
                             "tcp_user_timeout",
                             "application_name",
                             "dbname",
                             static_cast<const char*>(nullptr)};
  const std::array values{
      "5", "10", "5", "3", "30000", "stanok", address.c_str(), static_cast<const char*>(nullptr)};
  constexpr int expand = 1;
  connection_.reset(PQconnectdbParams(names.data(), values.data(), expand));
  if (connection_ == nullptr || PQstatus(connection_.get()) != CONNECTION_OK)
    throw DatabaseError(first_line(PQerrorMessage(connection_.get())));
  PQsetNoticeProcessor(connection_.get(), ignore_notice, nullptr);
}

Rows PostgresDatabase::run(const std::string& sql, const Row& values) {
  std::vector<const char*> texts;
  for (const Value& value : values) texts.push_back(value ? value->c_str() : nullptr);
  constexpr int as_text = 0;
  const std::unique_ptr<PGresult, Clear> result(
      PQexecParams(connection_.get(), sql.c_str(), static_cast<int>(texts.size()), nullptr,
                   texts.data(), nullptr, nullptr, as_text));
  const ExecStatusType status = PQresultStatus(result.get());
  if (status != PGRES_COMMAND_OK && status != PGRES_TUPLES_OK)
    throw DatabaseError(first_line(PQerrorMessage(connection_.get())) + " (" + sql + ")");
  return rows_of(*result);
}

bool address_holds_password(const std::string& address) {
  const std::unique_ptr<PQconninfoOption, Clear> options(PQconninfoParse(address.c_str(), nullptr));
  if (options == nullptr) return false;
  for (const PQconninfoOption* one = options.get(); one->keyword != nullptr; ++one)
    if (std::string_view(one->keyword) == "password" && one->val != nullptr) return true;
  return false;
}

}  // namespace stanok::gateway
