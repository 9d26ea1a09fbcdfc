// What gateway/database/postgres.cc asks of this module, by these names.
#include <exception>
#include <memory>
#include <string>
#include <string_view>

#include "gateway/database/postgres.h"
#include "gateway/postgres/postgres_database.h"

using stanok::gateway::PostgresDatabase;
using stanok::gateway::PostgresFunctions;

extern "C" const PostgresFunctions stanok_postgres;

const PostgresFunctions stanok_postgres{
    .open = [](const std::string& address) -> std::unique_ptr<stanok::gateway::Database> {
      return std::make_unique<PostgresDatabase>(address);
    },
    .holds_password = &stanok::gateway::address_holds_password};
