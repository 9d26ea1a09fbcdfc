// PostgreSQL as a module that is loaded when an address of a server is given.
//
// libpq brings some forty libraries with it (Kerberos, LDAP, TLS), which no other command of stanok
// should load, and which a machine without such a server need not have.
#pragma once

#include <memory>
#include <string>

#include "gateway/database/database.h"

namespace stanok::gateway {

// What the module offers, as its symbol `stanok_postgres`. Both sides are built together.
struct PostgresFunctions {
  std::unique_ptr<Database> (*open)(const std::string& address);  // throws DatabaseError
  bool (*holds_password)(const std::string& address);
};

// Loads the module at the first call and keeps it. Throws DatabaseError where there is none.
[[nodiscard]] const PostgresFunctions& postgres();

}  // namespace stanok::gateway
