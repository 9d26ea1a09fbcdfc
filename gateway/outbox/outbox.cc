#include "gateway/outbox/outbox.h"

#include <algorithm>
#include <array>

#include "gateway/outbox/wall_clock.h"
#include "protocol/contract/json_rpc.h"
#include "protocol/contract/json_text.h"

namespace stanok::gateway {
namespace {

using nlohmann::json;

// The source is made by the database, so that two processes never make two.
constexpr std::array tables{
    "CREATE TABLE IF NOT EXISTS events (number INTEGER PRIMARY KEY AUTOINCREMENT, machine TEXT NOT "
    "NULL, kind TEXT NOT NULL, time_s REAL NOT NULL, content TEXT NOT NULL)",
    "CREATE TABLE IF NOT EXISTS consumers (name TEXT PRIMARY KEY, position INTEGER NOT NULL)",
    "CREATE TABLE IF NOT EXISTS marks (machine TEXT PRIMARY KEY, mark TEXT NOT NULL)",
    "CREATE TABLE IF NOT EXISTS source (one INTEGER PRIMARY KEY, name TEXT NOT NULL)",
    "INSERT OR IGNORE INTO source VALUES (1, lower(hex(randomblob(8))))",
    "CREATE TABLE IF NOT EXISTS sparkplug (one INTEGER PRIMARY KEY, session INTEGER NOT NULL)",
    "INSERT OR IGNORE INTO sparkplug VALUES (1, 0)",
};

std::int64_t integer_of(const Value& value) {
  return value ? std::stoll(*value) : 0;
}

}  // namespace

Outbox::Outbox(const std::filesystem::path& file, std::int64_t events_max)
    : database_(file), events_max_(events_max) {
  Transaction transaction(database_);
  for (const char* table : tables) database_.run(table);
  transaction.commit();
  source_ = *database_.run("SELECT name FROM source").at(0).at(0);
}

void Outbox::set_consumers(const std::vector<std::string>& names) {
  Transaction transaction(database_);
  const Rows known = database_.run("SELECT name FROM consumers");
  for (const Row& row : known)
    if (std::ranges::find(names, *row[0]) == names.end())
      database_.run("DELETE FROM consumers WHERE name = $1", row);
  for (const std::string& name : names)
    database_.run("INSERT OR IGNORE INTO consumers VALUES ($1, 0)", {name});
  transaction.commit();
}

void Outbox::append(const std::vector<Event>& events, const std::string& machine,
                    const json& mark) {
  Transaction transaction(database_);
  for (const Event& event : events) insert(event);
  database_.run("INSERT INTO marks VALUES ($1, $2) ON CONFLICT (machine) DO UPDATE SET mark = $2",
                {machine, protocol::json_text(mark)});
  keep_bound();
  transaction.commit();
}

void Outbox::insert(const Event& event) {
  database_.run(
      "INSERT INTO events (machine, kind, time_s, content) VALUES ($1, $2, $3, $4)",
      {event.machine, event.kind, text_of(event.time_s), protocol::json_text(event.content)});
}

void Outbox::keep_bound() {
  const Row bounds =
      database_.run("SELECT coalesce(min(number), 0), coalesce(max(number), 0) FROM events").at(0);
  const std::int64_t first = integer_of(bounds[0]);
  const std::int64_t count = integer_of(bounds[1]) - first + 1;
  if (count <= events_max_) return;
  const std::int64_t given_up = count - events_max_ + events_max_ / 100;
  const std::int64_t last = first + given_up - 1;
  database_.run("DELETE FROM events WHERE number <= $1", {std::to_string(last)});
  insert({"", "lost", wall_clock_s(), {{"first", first}, {"last", last}}});
}

json Outbox::mark(const std::string& machine) {
  const Rows rows = database_.run("SELECT mark FROM marks WHERE machine = $1", {machine});
  return rows.empty() ? json() : protocol::json_from_text(*rows[0][0]);
}

std::int64_t Outbox::position(const std::string& consumer) {
  const Rows rows = database_.run("SELECT position FROM consumers WHERE name = $1", {consumer});
  return rows.empty() ? 0 : integer_of(rows[0][0]);
}

void Outbox::set_position(const std::string& consumer, std::int64_t number) {
  Transaction transaction(database_);
  database_.run("UPDATE consumers SET position = $1 WHERE name = $2",
                {std::to_string(number), consumer});
  database_.run("DELETE FROM events WHERE number <= (SELECT min(position) FROM consumers)");
  transaction.commit();
}

std::uint64_t Outbox::sparkplug_session() {
  const Row row = database_.run("SELECT session FROM sparkplug").at(0);
  return static_cast<std::uint64_t>(integer_of(row[0]));
}

// Eclipse Sparkplug 3.0.0, 6.4.4: 0 to 255, and 0 again.
void Outbox::note_sparkplug_session() {
  database_.run("UPDATE sparkplug SET session = (session + 1) % 256");
}

std::vector<StoredEvent> Outbox::behind(std::int64_t number, std::int64_t count) {
  const Rows rows = database_.run(
      "SELECT number, machine, kind, time_s, content FROM events WHERE number > $1 ORDER BY number "
      "LIMIT $2",
      {std::to_string(number), std::to_string(count)});
  std::vector<StoredEvent> events;
  for (const Row& row : rows)
    events.push_back({integer_of(row[0]),
                      {*row[1], *row[2], number_of(row[3]), protocol::json_from_text(*row[4])}});
  return events;
}

}  // namespace stanok::gateway
