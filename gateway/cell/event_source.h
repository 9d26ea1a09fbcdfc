// EventSource: events of one machine out of what its daemon remembers, each once.
//
// The daemon keeps runs and alarms with numbers that count up in each channel as long as its
// journal is the same, measurements since it started. The mark in the outbox says up to which
// number they have been read, of which journal and which daemon (boot of the computer, process,
// start), so that neither a gateway nor a disk that was away loses or doubles any: what could not
// be written is found again. Times are those that the daemon tells, else those of the cycles by the
// clock of the gateway.
#pragma once

#include <chrono>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "gateway/outbox/outbox.h"

namespace stanok::gateway {

// When a daemon started, as long as its computer has not been started anew.
struct DaemonStart {
  std::string boot;
  int process = 0;
  double started_s = 0.0;    // since the boot; not earlier
  double uncertain_s = 0.0;  // and not later than so long after that
  std::string history{};     // id of its journal; empty: it has none
};

// Of the daemon that was asked at `asked` and said until now that it runs as `process` since
// `uptime_s`.
[[nodiscard]] DaemonStart daemon_start(int process, double uptime_s,
                                       std::chrono::steady_clock::time_point asked);

class EventSource {
 public:
  EventSource(std::string machine, Outbox& outbox);

  // A daemon has been reached; another one than before counts from 1 again what is not in a journal
  // that it goes on with.
  void meet(const DaemonStart& start);
  // Cycle 0 was then, and one lasts so long.
  void set_clock(double zero_s, double cycle_s);

  // Programs of runs that are new in an answer to `program.history`.
  [[nodiscard]] std::set<std::string> new_programs(const nlohmann::json& runs) const;
  // `versions` of the texts of these programs. Throws DatabaseError, and nothing has happened.
  void take_runs(const nlohmann::json& runs, const std::map<std::string, std::string>& versions);
  // An answer to `alarm.history`; throws likewise.
  void take_alarms(const nlohmann::json& alarms);
  // An answer to `measurement.history`; throws likewise.
  void take_measurements(const nlohmann::json& measurements);

  // The tool is in the spindle of a program that runs.
  void add_tool_time(int tool, double seconds);

  [[nodiscard]] nlohmann::json parts() const { return mark_["parts"]; }
  [[nodiscard]] nlohmann::json tools() const { return mark_["tools"]; }

 private:
  // Of a row: its time, else that of its cycle, by the names of these members.
  [[nodiscard]] double time_of(const nlohmann::json& row, const char* at, const char* cycle) const;
  [[nodiscard]] Event event(std::string_view kind, double time_s, nlohmann::json content) const;
  void append_run(const nlohmann::json& run, const std::string& version, nlohmann::json& mark,
                  std::vector<Event>& events) const;
  void append_tool_use(nlohmann::json& mark, std::vector<Event>& events) const;
  struct RowKind {
    std::string_view event;
    const char* counted;  // in the mark
  };
  void take_rows(const nlohmann::json& rows, const RowKind& kind,
                 std::initializer_list<const char*> names);
  // When numbers have been skipped, the daemon had forgotten them.
  void append_forgotten(const nlohmann::json& row, std::int64_t known, std::string_view what,
                        std::vector<Event>& events) const;
  void write(const std::vector<Event>& events, nlohmann::json mark);

  std::string machine_;
  Outbox& outbox_;
  nlohmann::json mark_;
  double zero_s_ = 0.0;
  double cycle_s_ = 1e-3;
  // Since the gateway started; what of it is written is in `used` of the mark, which is not kept.
  std::map<int, double> tool_time_s_;
};

}  // namespace stanok::gateway
