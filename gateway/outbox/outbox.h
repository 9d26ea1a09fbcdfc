// Outbox: events on the disk until everybody who is to get them has them.
//
// Events are numbered 1, 2, 3, ... over all machines; the numbers are of one *source*, the file: a
// new file has a new source. Consumers (the broker, the history) each have the number up to which
// they have everything. What all have is deleted. When more than a bound wait, the oldest
// are given up, a hundredth of the bound at a time, and an event `lost` says how many: who receives
// sees the gap in the numbers besides.
//
// An event and the mark of the machine up to which it was read are written together: whatever is
// not written is read again. Each thread opens an outbox of its own on the same file.
#pragma once

#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "gateway/database/sqlite_database.h"

namespace stanok::gateway {

struct Event {
  std::string machine;
  std::string kind;
  double time_s = 0.0;  // since 1970, UTC
  nlohmann::json content;
};

struct StoredEvent {
  std::int64_t number = 0;
  Event event;
};

class Outbox {
 public:
  static constexpr std::int64_t usual_events_max = 1'000'000;

  // Throws DatabaseError.
  explicit Outbox(const std::filesystem::path& file, std::int64_t events_max = usual_events_max);

  [[nodiscard]] const std::string& source() const { return source_; }

  // Those named and no others are waited for.
  void set_consumers(const std::vector<std::string>& names);

  // All or none of it; the mark is the machine's own word for where it goes on reading.
  void append(const std::vector<Event>& events, const std::string& machine,
              const nlohmann::json& mark);
  // Null before the first one.
  [[nodiscard]] nlohmann::json mark(const std::string& machine);

  [[nodiscard]] std::int64_t position(const std::string& consumer);
  void set_position(const std::string& consumer, std::int64_t number);
  // Of the next connection to hosts of Sparkplug, from 0 on, and that it has come about.
  [[nodiscard]] std::uint64_t sparkplug_session();
  void note_sparkplug_session();

  // At most `count` events with higher numbers, in their order.
  [[nodiscard]] std::vector<StoredEvent> behind(std::int64_t number, std::int64_t count);

 private:
  void insert(const Event& event);
  void keep_bound();

  SqliteDatabase database_;
  std::int64_t events_max_;
  std::string source_;
};

}  // namespace stanok::gateway
