// HistoryDesk: reads the history of the gateway for pages, in a thread of its own.
//
// A database may be slow or away: nobody else waits for it, and no more than a few questions do.
// Belongs to the thread of the server.
#pragma once

#include <boost/asio/awaitable.hpp>
#include <boost/asio/thread_pool.hpp>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>

#include "base/expected.h"

namespace stanok::web {

// What is asked of a history, as `stanok history` has it.
struct HistoryQuestion {
  std::string query;          // "runs", "alarms", "oee", "tools", "drift"
  std::string since = "30d";  // back from now: "30d", "12h", "45min"
  std::string machine;        // empty: all
};

struct HistoryFault {
  enum class Kind : std::uint8_t { no_history, bad_question, busy, failed };
  Kind kind = Kind::failed;
  std::string text;
};

class HistoryDesk {
 public:
  static constexpr int questions_max = 8;  // that wait

  // File of SQLite or postgresql://...; empty: there is none.
  explicit HistoryDesk(std::string database) : database_(std::move(database)) {}

  [[nodiscard]] bool has_history() const { return !database_.empty(); }
  // {"query", "columns": [{"name", "kind"}], "rows": [[...]]}
  [[nodiscard]] boost::asio::awaitable<Expected<nlohmann::json, HistoryFault>> ask(
      HistoryQuestion question);

 private:
  std::string database_;
  int waiting_ = 0;
  boost::asio::thread_pool reader_{1};
};

}  // namespace stanok::web
