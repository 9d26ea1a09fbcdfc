#include "gateway/cell/event_source.h"

#include <chrono>
#include <fstream>
#include <utility>

#include "gateway/cell/topics.h"
#include "gateway/outbox/wall_clock.h"

namespace stanok::gateway {
namespace {

using nlohmann::json;

// Lines of manual input are runs, too, and make no parts.
constexpr std::string_view manual_input = "MDI";

std::string key_of(const json& row) {
  return std::to_string(row.value("channel", 0));
}

json& counts_of(json& mark, const json& row) {
  json& counts = mark["channels"][key_of(row)];
  if (counts.is_null()) counts = {{"begun", 0}, {"ended", 0}, {"alarms", 0}, {"measurements", 0}};
  return counts;
}

std::int64_t count_of(const json& mark, const json& row, const char* name) {
  const auto channel = mark.at("channels").find(key_of(row));
  return channel == mark.at("channels").end() ? 0 : channel->value(name, std::int64_t{0});
}

std::int64_t number_in(const json& row) {
  return row.value("number", std::int64_t{0});
}

json members(const json& row, std::initializer_list<const char*> names) {
  json some = json::object();
  for (const char* name : names) some[name] = row.value(name, json());
  return some;
}

}  // namespace

DaemonStart daemon_start(int process, double uptime_s,
                         std::chrono::steady_clock::time_point asked) {
  using Seconds = std::chrono::duration<double>;
  DaemonStart start{.boot = "", .process = process, .started_s = 0.0, .uncertain_s = 0.0};
  std::ifstream("/proc/sys/kernel/random/boot_id") >> start.boot;
  start.started_s = Seconds(asked.time_since_epoch()).count() - uptime_s;
  start.uncertain_s = Seconds(std::chrono::steady_clock::now() - asked).count();
  return start;
}

EventSource::EventSource(std::string machine, Outbox& outbox)
    : machine_(std::move(machine)), outbox_(outbox), mark_(outbox.mark(machine_)) {
  if (!mark_.is_object())
    mark_ = {{"channels", json::object()}, {"parts", json::object()}, {"tools", json::object()}};
}

void EventSource::meet(const DaemonStart& start) {
  constexpr double same_within_s = 2.0;  // clocks and their steps
  const double known_s = mark_.value("started_s", 0.0);
  const double known_end_s = known_s + mark_.value("uncertain_s", 0.0);
  const bool is_same = mark_.value("boot", "") == start.boot &&
                       mark_.value("process", 0) == start.process &&
                       start.started_s < known_end_s + same_within_s &&
                       known_s < start.started_s + start.uncertain_s + same_within_s;
  if (is_same) return;
  mark_["boot"] = start.boot;
  mark_["process"] = start.process;
  mark_["started_s"] = start.started_s;
  mark_["uncertain_s"] = start.uncertain_s;
  const bool goes_on = !start.history.empty() && mark_.value("history", "") == start.history;
  mark_["history"] = start.history;
  if (!goes_on) mark_["channels"] = json::object();
  for (json& counts : mark_["channels"]) counts["measurements"] = 0;
}

void EventSource::set_clock(double zero_s, double cycle_s) {
  zero_s_ = zero_s;
  cycle_s_ = cycle_s;
}

std::set<std::string> EventSource::new_programs(const json& runs) const {
  std::set<std::string> programs;
  for (const json& run : runs.at("runs"))
    if (number_in(run) > count_of(mark_, run, "begun")) programs.insert(run.value("program", ""));
  return programs;
}

void EventSource::take_runs(const json& runs, const std::map<std::string, std::string>& versions) {
  json mark = mark_;
  std::vector<Event> events;
  for (const json& run : runs.at("runs")) {
    const auto known = versions.find(run.value("program", ""));
    append_run(run, known == versions.end() ? "" : known->second, mark, events);
  }
  if (!events.empty()) write(events, std::move(mark));
}

void EventSource::append_run(const json& run, const std::string& version, json& mark,
                             std::vector<Event>& events) const {
  json& counts = counts_of(mark, run);
  json content = members(run, {"channel", "number", "program"});
  if (number_in(run) > counts["begun"]) {
    append_forgotten(run, counts["begun"], "runs", events);
    counts["begun"] = number_in(run);
    counts["version"] = version;
    content["version"] = version;
    events.push_back(event(event::run_begun, time_of(run, "begun_at", "begun_cycle"), content));
  }
  if (!run.value("ended", false) || number_in(run) <= counts["ended"]) return;
  counts["ended"] = number_in(run);
  content.update(members(run, {"time_s", "path_mm", "blocks", "ok", "end"}));
  content["version"] = counts.value("version", "");
  content["begun_s"] = time_of(run, "begun_at", "begun_cycle");
  const double ended_s = time_of(run, "ended_at", "ended_cycle");
  content["ended_s"] = ended_s;
  const std::string program = run.value("program", "");
  json& parts = mark["parts"][program];
  if (parts.is_null()) parts = 0;
  if (run.value("ok", false) && program != manual_input) parts = parts.get<std::int64_t>() + 1;
  content["parts"] = parts;
  events.push_back(event(event::run_ended, ended_s, std::move(content)));
  append_tool_use(mark, events);
}

void EventSource::append_tool_use(json& mark, std::vector<Event>& events) const {
  for (const auto& [tool, seconds] : tool_time_s_) {
    json& total_s = mark["tools"][std::to_string(tool)];
    const double before_s = total_s.is_null() ? 0.0 : total_s.get<double>();
    const double use_s =
        seconds - mark.value(json::json_pointer("/used/" + std::to_string(tool)), 0.0);
    if (use_s <= 0.0) continue;
    mark["used"][std::to_string(tool)] = seconds;
    total_s = before_s + use_s;
    events.push_back(event(event::tool_use, wall_clock_s(),
                           {{"tool", tool}, {"use_s", use_s}, {"total_s", total_s}}));
  }
}

void EventSource::append_forgotten(const json& row, std::int64_t known, std::string_view what,
                                   std::vector<Event>& events) const {
  const std::int64_t count = number_in(row) - known - 1;
  if (count <= 0) return;
  events.push_back(event(event::lost, wall_clock_s(),
                         {{"channel", row.value("channel", 0)}, {"what", what}, {"count", count}}));
}

void EventSource::take_alarms(const json& alarms) {
  take_rows(alarms.at("alarms"), {event::alarm, "alarms"},
            {"channel", "number", "code", "text", "file", "line", "reaction"});
}

void EventSource::take_measurements(const json& measurements) {
  take_rows(measurements.at("measurements"), {event::measurement, "measurements"},
            {"channel", "number", "cycle", "text"});
}

void EventSource::take_rows(const json& rows, const RowKind& kind,
                            std::initializer_list<const char*> names) {
  json mark = mark_;
  std::vector<Event> events;
  for (const json& row : rows) {
    json& known = counts_of(mark, row)[kind.counted];
    if (known.is_null()) known = 0;  // a mark of an older gateway
    if (number_in(row) <= known) continue;
    append_forgotten(row, known, kind.counted, events);
    known = number_in(row);
    events.push_back(event(kind.event, time_of(row, "at", "cycle"), members(row, names)));
  }
  if (!events.empty()) write(events, std::move(mark));
}

void EventSource::add_tool_time(int tool, double seconds) {
  tool_time_s_[tool] += seconds;
}

double EventSource::time_of(const json& row, const char* at, const char* of_cycle) const {
  const json told = row.value(at, json());
  if (told.is_number()) return told.get<double>();
  const json cycle = row.value(of_cycle, json());
  return cycle.is_number() ? zero_s_ + cycle.get<double>() * cycle_s_ : wall_clock_s();
}

Event EventSource::event(std::string_view kind, double time_s, json content) const {
  return {machine_, std::string(kind), time_s, std::move(content)};
}

void EventSource::write(const std::vector<Event>& events, json mark) {
  json kept = mark;
  kept.erase("used");
  outbox_.append(events, machine_, kept);
  mark_ = std::move(mark);
}

}  // namespace stanok::gateway
