#include "web/cell/history_desk.h"

#include <boost/asio/co_spawn.hpp>
#include <boost/asio/use_awaitable.hpp>
#include <exception>
#include <new>

#include "gateway/history/answers.h"
#include "gateway/history/queries.h"

namespace stanok::web {
namespace {

namespace asio = boost::asio;
using nlohmann::json;
using Answered = Expected<json, HistoryFault>;

Answered refused(HistoryFault::Kind kind, std::string text) {
  return Unexpected<HistoryFault>(HistoryFault{kind, std::move(text)});
}

// In the thread of the reader.
asio::awaitable<Answered> read(std::string database, const gateway::Query& query, double since_s,
                               std::string machine) {
  try {
    const auto history = gateway::open_history(database);
    co_return gateway::table_json(query, gateway::ask(*history, query, since_s, machine));
  } catch (const std::exception& error) {
    co_return refused(HistoryFault::Kind::failed, error.what());
  }
}

}  // namespace

asio::awaitable<Answered> HistoryDesk::ask(HistoryQuestion question) {
  using enum HistoryFault::Kind;
  if (!has_history())
    co_return refused(no_history, "this server has no history; name one with --history DATABASE");
  const gateway::Query* query = gateway::find_query(question.query);
  if (query == nullptr) co_return refused(bad_question, "unknown query of the history");
  const auto since_s = gateway::time_back_from_now(question.since);
  if (!since_s)
    co_return refused(bad_question, "`since` must be a time before now, such as 30d, 12h or 45min");
  if (waiting_ >= questions_max)
    co_return refused(busy, "too many queries are waiting for the history; try again later");
  ++waiting_;
  Answered answered;
  try {
    answered = co_await asio::co_spawn(reader_, read(database_, *query, *since_s, question.machine),
                                       asio::use_awaitable);
  } catch (const std::bad_alloc&) {  // it costs this answer, not the place of others
    answered = refused(failed, "there is not enough memory to read the history");
  }
  --waiting_;
  co_return answered;
}

}  // namespace stanok::web
