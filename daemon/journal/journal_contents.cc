#include "daemon/journal/journal_contents.h"

#include <algorithm>
#include <iterator>

#include "base/enum_names.h"

namespace stanok::daemon {
namespace {

using channels::AlarmReport;
using channels::RunOutcome;
using channels::RunReport;
using nlohmann::json;

constexpr auto outcomes = enum_names<RunOutcome>({
    {RunOutcome::none, "none"},
    {RunOutcome::done, "done"},
    {RunOutcome::stopped, "stopped"},
    {RunOutcome::alarm, "alarm"},
    {RunOutcome::estop, "estop"},
    {RunOutcome::cut_off, "cut_off"},
});

template <class Value>
Value value_in(const json& record, const char* name, Value otherwise) {
  const auto found = record.find(name);
  if (found == record.end()) return otherwise;
  if constexpr (std::is_same_v<Value, std::string>) {
    return found->is_string() ? found->get<std::string>() : otherwise;
  } else if constexpr (std::is_same_v<Value, bool>) {
    return found->is_boolean() ? found->get<bool>() : otherwise;
  } else {
    return found->is_number() ? found->get<Value>() : otherwise;
  }
}

template <class Value>
void keep_newest_of_channel(std::map<std::pair<int, std::uint64_t>, Value>& all, int channel) {
  const auto begin = all.lower_bound({channel, 0});
  const auto end = all.lower_bound({channel + 1, 0});
  const auto count = std::distance(begin, end);
  constexpr auto kept = static_cast<std::ptrdiff_t>(JournalContents::kept_max);
  if (count > kept) all.erase(begin, std::next(begin, count - kept));
}

}  // namespace

std::optional<std::string> run_outcome_name(RunOutcome outcome) {
  if (outcome == RunOutcome::none) return std::nullopt;
  return std::string(outcomes[outcome]);
}

RunOutcome run_outcome_named(const std::string& name) {
  return outcomes.value(name).value_or(RunOutcome::none);
}

json run_begun_record(const RunReport& run) {
  return {{"kind", journal_kind::run_begun},
          {"channel", run.channel},
          {"number", run.number},
          {"program", run.program},
          {"at", run.begun_at}};
}

json run_ended_record(const RunReport& run) {
  return {{"kind", journal_kind::run_ended},
          {"channel", run.channel},
          {"number", run.number},
          {"program", run.program},
          {"begun_at", run.begun_at},
          {"at", run.ended_at},
          {"end", run_outcome_name(run.end).value_or("stopped")},
          {"blocks", run.blocks},
          {"path_mm", run.path_mm},
          {"lost_periods", run.lost.total},
          {"longest_gap", run.lost.longest}};
}

json alarm_record(const AlarmReport& alarm) {
  return {{"kind", journal_kind::alarm},
          {"channel", alarm.channel},
          {"number", alarm.number},
          {"at", alarm.at},
          {"code", alarm.diagnostic.code},
          {"text", alarm.diagnostic.message},
          {"file", alarm.diagnostic.place.file},
          {"line", alarm.diagnostic.place.line},
          {"column", alarm.diagnostic.place.column},
          {"stands", alarm.cycle == 0 && !alarm.is_over}};
}

json seen_record(int channel, std::uint64_t number) {
  return {{"kind", journal_kind::seen}, {"channel", channel}, {"number", number}};
}

void JournalContents::take(const json& record) {
  const std::string kind = value_in(record, "kind", std::string());
  const Key key{value_in(record, "channel", 0), value_in(record, "number", std::uint64_t{0})};
  if (kind == journal_kind::journal) id_ = value_in(record, "id", std::string());
  if (kind == journal_kind::run_begun) runs_[key].begun = record;
  if (kind == journal_kind::place) runs_[key].place = record;
  if (kind == journal_kind::run_ended) runs_[key].ended = record;
  if (kind == journal_kind::alarm) alarms_[key] = record;
  if (kind == journal_kind::seen) seen_[key.first] = std::max(seen_[key.first], key.second);
  const bool is_action =
      kind == journal_kind::action || kind == journal_kind::start || kind == journal_kind::end;
  if (is_action) take_action(record);
  keep_newest_of_channel(runs_, key.first);
  keep_newest_of_channel(alarms_, key.first);
}

void JournalContents::take_action(const json& action) {
  actions_.push_back(action);
  if (actions_.size() > actions_max) actions_.pop_front();
}

// A standing alarm ends with the daemon; that a run was cut off stands until somebody has seen it.
AlarmReport JournalContents::alarm_of(const Key& key, const json& record) const {
  const auto seen = seen_.find(key.first);
  const bool is_seen = seen != seen_.end() && key.second <= seen->second;
  AlarmReport alarm;
  alarm.channel = key.first;
  alarm.number = key.second;
  alarm.at = value_in(record, "at", 0.0);
  alarm.is_over = is_seen || !value_in(record, "stands", false);
  alarm.diagnostic.code = value_in(record, "code", std::string());
  alarm.diagnostic.message = value_in(record, "text", std::string());
  alarm.diagnostic.place.file = value_in(record, "file", std::string());
  alarm.diagnostic.place.line = value_in(record, "line", 0);
  alarm.diagnostic.place.column = value_in(record, "column", 0);
  return alarm;
}

std::vector<json> JournalContents::records() const {
  std::vector<json> records;
  if (!id_.empty()) records.push_back({{"kind", journal_kind::journal}, {"id", id_}});
  for (const auto& [key, run] : runs_)
    for (const json& record : {run.begun, run.place, run.ended})
      if (!record.is_null()) records.push_back(record);
  records.insert(records.end(), actions_.begin(), actions_.end());
  for (const auto& [key, alarm] : alarms_) records.push_back(alarm);
  for (const auto& [channel, number] : seen_) records.push_back(seen_record(channel, number));
  return records;
}

RunReport JournalContents::report_of(const Key& key, const Run& run) {
  const json& told = run.ended.is_null() ? run.begun : run.ended;
  RunReport report;
  report.channel = key.first;
  report.number = key.second;
  report.program = value_in(told, "program", std::string());
  report.begun_at =
      run.ended.is_null() ? value_in(run.begun, "at", 0.0) : value_in(run.ended, "begun_at", 0.0);
  report.ended = true;
  report.ended_at = value_in(run.ended, "at", 0.0);
  report.end = run_outcome_named(value_in(run.ended, "end", std::string()));
  report.ok = report.end == RunOutcome::done;
  report.blocks = value_in(run.ended, "blocks", std::uint64_t{0});
  report.path_mm = value_in(run.ended, "path_mm", 0.0);
  report.lost = {.total = value_in(run.ended, "lost_periods", std::int64_t{0}),
                 .longest = value_in(run.ended, "longest_gap", std::int64_t{0})};
  return report;
}

std::vector<JournalContents::CutOff> JournalContents::cut_off() const {
  std::vector<CutOff> all;
  for (const auto& [key, run] : runs_)
    if (run.ended.is_null()) all.push_back(cut_off(key, run));
  return all;
}

JournalContents::CutOff JournalContents::cut_off(const Key& key, const Run& run) {
  CutOff cut;
  cut.run = report_of(key, run);
  cut.run.ended_at = value_in(run.place, "at", cut.run.begun_at);
  cut.run.end = RunOutcome::cut_off;
  cut.file = value_in(run.place, "file", cut.run.program);
  cut.line = value_in(run.place, "line", 0);
  return cut;
}

channels::Past JournalContents::past() const {
  channels::Past past;
  for (const auto& [key, run] : runs_)
    past.runs.push_back(run.ended.is_null() ? cut_off(key, run).run : report_of(key, run));
  for (const auto& [key, alarm] : alarms_) past.alarms.push_back(alarm_of(key, alarm));
  past.alarm_numbers = seen_;
  return past;
}

}  // namespace stanok::daemon
