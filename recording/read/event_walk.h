// EventWalk: the events of a log in the order of the file, with the names of the program files that
// they number.
//
// A message says which run of which channel it belongs to, and the number of a file within that
// run: 0 is the program, then what it reads in the order in which it is read. The texts that were
// asked for, PROGRAM_READ, tell that order; the state of a channel, 20 times a second, tells which
// program a run is of. An event therefore waits for the next state of its channel that knows its
// run, at most behind `waiting_max` others.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <stanok_messages/channel_state_t.hpp>
#include <stanok_messages/event_t.hpp>
#include <stanok_messages/program_read_t.hpp>
#include <string>
#include <utility>
#include <vector>

#include "recording/log/log_reader.h"

namespace stanok::recording {

struct NamedEvent {
  event_t event;
  std::string file;  // as the program asks for it; empty: no program's, or the log does not tell
};

class EventWalk {
 public:
  [[nodiscard]] static Expected<EventWalk, LogError> open(const std::filesystem::path& file);

  // The next one; nothing at the end of the log.
  [[nodiscard]] std::optional<NamedEvent> next();

 private:
  static constexpr std::size_t waiting_max = 1000;

  // Files that a program read when it was loaded, in the order of their numbers.
  struct Files {
    std::vector<std::string> names;
    std::vector<std::string> paths;  // where they were found
  };
  using Run = std::pair<int, int>;  // channel, number

  explicit EventWalk(LogReader reader) : reader_(std::move(reader)) {}
  // False at the end of the log.
  [[nodiscard]] bool read_message();
  void take(const program_read_t& read);
  void take(const channel_state_t& state);
  [[nodiscard]] std::shared_ptr<const Files> files_of_program(const std::string& name) const;
  [[nodiscard]] bool waits_for_name(const event_t& event) const;
  [[nodiscard]] std::string file_of(const event_t& event) const;

  LogReader reader_;
  std::deque<event_t> waiting_;
  std::vector<std::shared_ptr<Files>> programs_;       // the one that was loaded last comes last
  std::map<Run, std::shared_ptr<const Files>> files_;  // nullptr: the log does not tell
  std::map<int, int> latest_run_;                      // by channel
};

}  // namespace stanok::recording
