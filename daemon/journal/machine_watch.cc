#include "daemon/journal/machine_watch.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "daemon/journal/journal_contents.h"

namespace stanok::daemon {
namespace {

using channels::RunReport;
using nlohmann::json;

constexpr double look_period_s = 1.0;  // where nothing seems to be new

}  // namespace

void MachineWatch::pass_over(const channels::Past& past) {
  for (const RunReport& run : past.runs) {
    Known& known = known_[run.channel];
    known.begun = known.ended = run.number;
  }
  for (const channels::AlarmReport& alarm : past.alarms)
    known_[alarm.channel].alarms = alarm.number;
}

std::vector<json> MachineWatch::look(double now) {
  Records records;
  if (!has_news(now)) return records;
  const std::vector<RunReport> runs = machine_.runs();
  look_at_runs(runs, records);
  look_at_alarms(records);
  look_at_places(runs, now, records);
  return records;
}

// A run that began and ended between two looks has another number.
bool MachineWatch::has_news(double now) {
  const channels::CycleOutput output = machine_.newest_output();
  std::vector<std::uint64_t> standing;
  for (const channels::ChannelOutput& channel : output.of_channels()) {
    standing.push_back(channel.run);
    standing.push_back(channel.running ? 1 : 0);
    standing.push_back(static_cast<std::uint64_t>(channel.state));
  }
  const bool is_time = std::abs(now - looked_at_) >= look_period_s;
  if (!is_time && !std::exchange(looks_again_, false) && standing == standing_) return false;
  standing_ = std::move(standing);
  looked_at_ = now;
  return true;
}

// The cycle begins a run, and the preparation names it behind that: its begin is told again then,
// the newer record counts. The alarm that ended a run may be told right behind its end: what ended
// is looked at once more.
void MachineWatch::look_at_runs(const std::vector<RunReport>& runs, Records& records) {
  for (const RunReport& run : runs) {
    Known& known = known_[run.channel];
    if (run.number > known.begun) {
      known.begun = run.number;
      known.place = {};
      records.push_back(run_begun_record(run));
    } else if (run.number == known.begun && known.named < run.number && !run.program.empty()) {
      records.push_back(run_begun_record(run));
    }
    if (!run.program.empty()) known.named = std::max(known.named, run.number);
    if (known.named < known.begun && !run.ended) looks_again_ = true;
    if (!run.ended || run.number <= known.ended) continue;
    if (std::exchange(known.seen_ended, run.number) != run.number) {
      looks_again_ = true;
      continue;
    }
    known.ended = run.number;
    records.push_back(run_ended_record(run));
  }
}

void MachineWatch::look_at_alarms(Records& records) {
  for (const channels::AlarmReport& alarm : machine_.alarms()) {
    std::uint64_t& known = known_[alarm.channel].alarms;
    if (alarm.number <= known) continue;
    known = alarm.number;
    records.push_back(alarm_record(alarm));
  }
}

void MachineWatch::look_at_places(const std::vector<RunReport>& runs, double now,
                                  Records& records) {
  const channels::CycleOutput output = machine_.newest_output();
  for (const RunReport& run : runs) {
    const channels::ChannelOutput* const channel = output.of_channel(run.channel);
    const bool is_under_way =
        !run.ended && channel != nullptr && channel->run == run.run && channel->tag.line > 0;
    if (!is_under_way) continue;
    const bool is_named = channel->tag.file < run.files.size();
    std::pair place(is_named ? run.files[channel->tag.file] : run.program, channel->tag.line);
    Known& known = known_[run.channel];
    if (place == known.place) continue;
    records.push_back({{"kind", journal_kind::place},
                       {"channel", run.channel},
                       {"number", run.number},
                       {"file", place.first},
                       {"line", place.second},
                       {"at", now}});
    known.place = std::move(place);
  }
}

}  // namespace stanok::daemon
