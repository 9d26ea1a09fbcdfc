#include "web/cell/machine_glance.h"

#include <array>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/this_coro.hpp>
#include <boost/asio/use_awaitable.hpp>
#include <memory>

#include "protocol/connection/machine_connection.h"
#include "protocol/contract/json_rpc.h"

namespace stanok::web {
namespace {

namespace asio = boost::asio;
using nlohmann::json;

// null: no answer, or a refusal.
asio::awaitable<json> ask(protocol::MachineConnection& connection, int id, std::string method,
                          json parameters) {
  std::string request = protocol::request_line(id, method, parameters);
  request.pop_back();
  if (!co_await connection.send(std::move(request))) co_return json();
  while (const auto line = co_await connection.next_line()) {
    json message = protocol::json_from_text(*line);
    if (!message.is_object()) co_return json();
    if (message.value("id", json()) == id) co_return message.value("result", json());
  }
  co_return json();
}

constexpr std::array of_status{"program", "line",    "predicted_s", "remaining_s",
                               "alarm",   "held_by", "override",    "speed_mm_s",
                               "g_codes", "words",   "cycle",       "position"};

// What an overview shows of a channel, and by what it sees whether anything moves.
json tile_of(const json& channel, const json& status) {
  json tile;
  for (const char* member : {"id", "name", "state", "program_status"})
    tile[member] = channel.value(member, json());
  for (const char* member : of_status)
    tile[member] = status.is_object() ? status.value(member, json()) : json();
  return tile;
}

}  // namespace

MachineGlance::MachineGlance(std::filesystem::path socket)
    : socket_(std::move(socket)), machine_(socket_.stem().string()) {}

// Who comes while another one looks gets what was seen before.
asio::awaitable<bool> MachineGlance::daemon_answers() {
  const auto now = Clock::now();
  if (greeted_ == Clock::time_point() || now - greeted_ >= good_for) {
    greeted_ = now;
    co_await look(Depth::greeting);
  }
  co_return answers_;
}

asio::awaitable<json> MachineGlance::summary() {
  const auto now = Clock::now();
  if (seen_ == Clock::time_point() || now - seen_ >= good_for) {
    seen_ = greeted_ = now;
    co_await look(Depth::state);
  }
  const bool is_known = answers_ && status_.is_object();
  co_return json{{"id", id()},
                 {"name", machine_},
                 {"answers", answers_},
                 {"on", is_known ? status_.value("on", json()) : json()},
                 {"channels", is_known ? channels_ : json::array()}};
}

asio::awaitable<void> MachineGlance::look(Depth depth) {
  const auto executor = co_await asio::this_coro::executor;
  const auto connection = std::make_shared<protocol::MachineConnection>(executor);
  asio::steady_timer patience(executor, good_for);
  close_when_over(patience, connection);
  const bool is_connected = co_await connection->connect(socket_);
  std::optional<std::string> line;
  if (is_connected) line = co_await connection->next_line();
  const json hello = line ? protocol::json_from_text(*line) : json();
  answers_ = hello.is_object();
  is_full_ = answers_ && hello.contains("method") && hello["method"] == "dropped";
  if (answers_ && hello.contains("params")) machine_ = hello["params"].value("machine", machine_);
  if (depth == Depth::greeting) {
    patience.cancel();
    co_return;
  }
  json status;
  json tiles = json::array();
  int id = 0;
  if (answers_) status = co_await ask(*connection, ++id, "machine.status", json::object());
  if (status.is_object()) {
    for (const json& channel : status.value("channels", json::array())) {
      json parameters{{"channel", channel.value("id", 0)}};
      const json of_channel =
          co_await ask(*connection, ++id, "channel.status", std::move(parameters));
      tiles.push_back(tile_of(channel, of_channel));
    }
  }
  patience.cancel();
  status_ = std::move(status);
  channels_ = std::move(tiles);
}

}  // namespace stanok::web
