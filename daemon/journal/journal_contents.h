// JournalContents: what the records of a journal come to, and the records that are enough to say
// it again.
//
// Records are taken in their order; what was seen of alarms may be told before these are. Of each
// channel the newest runs and alarms are remembered, and of all the newest actions of operators;
// the rest is forgotten, so that a journal can be made short. Plain data; belongs to one thread.
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "channels/contract/reports.h"

namespace stanok::daemon {

// Kinds of records, their member "kind".
namespace journal_kind {
inline constexpr const char* journal = "journal";      // the first: {"id"}
inline constexpr const char* start = "start";          // of the daemon
inline constexpr const char* end = "end";              // orderly
inline constexpr const char* run_begun = "run_begun";  // {"channel","number","program","at"}
inline constexpr const char* place =
    "place";  // where it is: {"channel","number","file","line","at"}
inline constexpr const char* run_ended = "run_ended";
inline constexpr const char* alarm = "alarm";
inline constexpr const char* action = "action";  // of an operator
// Somebody has seen the alarms of a channel up to this one: {"channel","number"}.
inline constexpr const char* seen = "seen";
}  // namespace journal_kind

// "done", "stopped", ...; nothing: it has not ended.
[[nodiscard]] std::optional<std::string> run_outcome_name(channels::RunOutcome outcome);
[[nodiscard]] channels::RunOutcome run_outcome_named(const std::string& name);

[[nodiscard]] nlohmann::json run_begun_record(const channels::RunReport& run);
[[nodiscard]] nlohmann::json run_ended_record(const channels::RunReport& run);
[[nodiscard]] nlohmann::json alarm_record(const channels::AlarmReport& alarm);
[[nodiscard]] nlohmann::json seen_record(int channel, std::uint64_t number);

class JournalContents {
 public:
  static constexpr std::size_t kept_max = 500;      // runs and alarms of each channel
  static constexpr std::size_t actions_max = 2000;  // of operators

  // What it does not know is passed over: a later stanok may have written it.
  void take(const nlohmann::json& record);
  // As few as say the same.
  [[nodiscard]] std::vector<nlohmann::json> records() const;

  // Of the journal, the same as long as its file is there; empty: it has none yet.
  [[nodiscard]] const std::string& id() const { return id_; }
  [[nodiscard]] const std::deque<nlohmann::json>& actions() const { return actions_; }

  // A run that nobody has ended, as the daemon was killed or had no power any more: it counts as
  // ended when it was last seen, and where.
  struct CutOff {
    channels::RunReport run;
    std::string file;
    int line = 0;  // 0: not known
  };
  [[nodiscard]] std::vector<CutOff> cut_off() const;
  [[nodiscard]] channels::Past past() const;

 private:
  using Key = std::pair<int, std::uint64_t>;  // channel and number
  struct Run {
    nlohmann::json begun;
    nlohmann::json place;  // null: none was told
    nlohmann::json ended;  // null: it runs
  };

  void take_action(const nlohmann::json& action);
  [[nodiscard]] channels::AlarmReport alarm_of(const Key& key, const nlohmann::json& record) const;
  [[nodiscard]] static channels::RunReport report_of(const Key& key, const Run& run);
  [[nodiscard]] static CutOff cut_off(const Key& key, const Run& run);

  std::string id_;
  std::map<Key, Run> runs_;
  std::map<Key, nlohmann::json> alarms_;
  std::map<int, std::uint64_t> seen_;  // by channel, the number of its newest alarm that was seen
  std::deque<nlohmann::json> actions_;
};

}  // namespace stanok::daemon
