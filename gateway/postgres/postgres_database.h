// PostgresDatabase: a connection to a server of PostgreSQL. Its password comes from where libpq
// looks for it: a password file, never the address.
#pragma once

#include <libpq-fe.h>

#include <memory>
#include <string>

#include "gateway/database/database.h"

namespace stanok::gateway {

class PostgresDatabase final : public Database {
 public:
  // Throws DatabaseError; gives up after some seconds.
  explicit PostgresDatabase(const std::string& address);

  Rows run(const std::string& sql, const Row& values = {}) override;
  [[nodiscard]] std::string begin() const override { return "BEGIN"; }

 private:
  struct Close {
    void operator()(PGconn* connection) const { PQfinish(connection); }
  };
  std::unique_ptr<PGconn, Close> connection_;
};

// Of what libpq understands as an address; false for anything else.
[[nodiscard]] bool address_holds_password(const std::string& address);

}  // namespace stanok::gateway
