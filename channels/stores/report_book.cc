#include "channels/stores/report_book.h"

#include <algorithm>
#include <utility>

namespace stanok::channels {
namespace {

void set_text(Diagnostic& diagnostic, std::string_view text) {
  std::size_t end = std::min(text.find('\n'), text.size());
  diagnostic.message = std::string(text.substr(0, end));
  while (end < text.size()) {
    const std::size_t begin = end + 1;
    end = std::min(text.find('\n', begin), text.size());
    diagnostic.notes.push_back({std::string(text.substr(begin, end - begin)), {}});
  }
}

// Takes from what is kept of the runs of a channel what belongs to the oldest. A program that is
// named or explained need not come to run.
template <class Value>
void keep_newest(std::map<std::pair<int, std::uint32_t>, Value>& by_run, int channel,
                 std::size_t kept_max) {
  const auto begin = by_run.lower_bound({channel, 0});
  const auto end = by_run.lower_bound({channel + 1, 0});
  const auto count = std::distance(begin, end);
  if (std::cmp_greater(count, kept_max))
    by_run.erase(begin, std::next(begin, count - static_cast<std::ptrdiff_t>(kept_max)));
}

}  // namespace

ReportBook::ReportBook(std::size_t kept_max)
    : kept_max_(kept_max),
      run_records_(256),
      alarm_records_(256),
      runs_(kept_max),
      alarms_(kept_max),
      load_diagnostics_(kept_max) {}

void ReportBook::recall(Past past, TimeOfCycle time_of) {
  const std::lock_guard lock(mutex_);
  time_of_ = std::move(time_of);
  for (RunReport& run : past.runs) {
    run.run = RunReport::recalled;
    runs_.make_room(run.channel, 1);
    runs_.recall(std::move(run));
  }
  for (AlarmReport& alarm : past.alarms) {
    alarms_.make_room(alarm.channel, 1);
    alarms_.recall(std::move(alarm));
  }
  for (const auto& [channel, number] : past.alarm_numbers) alarms_.go_on_behind(channel, number);
}

std::uint64_t ReportBook::note(AlarmReport alarm) {
  const std::lock_guard lock(mutex_);
  drain_alarms();
  alarms_.make_room(alarm.channel, 1);
  return alarms_.add(std::move(alarm)).number;
}

double ReportBook::time_of(std::int64_t cycle) const {
  return time_of_ ? time_of_(cycle) : 0.0;
}

void ReportBook::name_run(int channel, std::uint32_t run, const std::string& program,
                          std::vector<std::string> files) {
  const std::lock_guard lock(mutex_);
  drain_runs();
  drain_alarms();
  if (RunReport* const known = find(channel, run)) {
    known->program = program;
    known->files = files;
  }
  names_[{channel, run}] = {program, std::move(files)};
  keep_newest(names_, channel, kept_max_);
}

void ReportBook::put(const RunRecord& record) RT_SAFE {
  if (!run_records_.push(record)) lost_.fetch_add(1, std::memory_order_relaxed);
}

void ReportBook::put(const AlarmRecord& record) RT_SAFE {
  if (!alarm_records_.push(record)) lost_.fetch_add(1, std::memory_order_relaxed);
}

void ReportBook::explain(int channel, std::uint32_t run, const Diagnostic& diagnostic) {
  const std::lock_guard lock(mutex_);
  explanations_[{channel, run}] = diagnostic;
  keep_newest(explanations_, channel, kept_max_);
}

void ReportBook::add_diagnostics(int channel, const Diagnostics& diagnostics) {
  const std::lock_guard lock(mutex_);
  load_diagnostics_.make_room(channel, diagnostics.size());
  for (const Diagnostic& diagnostic : diagnostics)
    load_diagnostics_.add({.channel = channel, .diagnostic = diagnostic});
}

void ReportBook::tell_search(int channel, const std::optional<SearchReport>& report) {
  const std::lock_guard lock(mutex_);
  searches_.erase(channel);
  if (report) searches_.emplace(channel, *report);
}

std::optional<SearchReport> ReportBook::search(int channel) {
  const std::lock_guard lock(mutex_);
  const auto found = searches_.find(channel);
  return found == searches_.end() ? std::nullopt : std::optional(found->second);
}

std::vector<RunReport> ReportBook::runs() {
  const std::lock_guard lock(mutex_);
  drain_runs();
  return runs_.all();
}

std::vector<AlarmReport> ReportBook::alarms() {
  const std::lock_guard lock(mutex_);
  drain_alarms();
  return alarms_.all();
}

std::vector<AlarmReport> ReportBook::load_diagnostics() {
  const std::lock_guard lock(mutex_);
  return load_diagnostics_.all();
}

// Empty while the preparation has not named the run.
ReportBook::RunNames ReportBook::names_of(const RunKey& key) const {
  const auto named = names_.find(key);
  return named == names_.end() ? RunNames{} : named->second;
}

// The cycle tells of an alarm before the end that it leads to.
void ReportBook::drain_runs() {
  RunRecord record;
  while (run_records_.pop(record)) {
    drain_alarms();
    RunReport& report = report_of(record);
    report.ok = record.ok;
    report.ended = record.ended;
    report.blocks = record.blocks;
    report.start_cycle = record.start_cycle;
    report.end_cycle = record.end_cycle;
    report.path_mm = record.path_mm;
    report.lookahead_max_blocks = record.lookahead_max_blocks;
    report.lost = record.lost;
    report.end_W = record.end_W;
    report.end_M = record.end_M;
    report.axis_count = record.axis_count;
    if (record.ended) {
      report.end = end_of(report);
      report.ended_at = time_of(record.end_cycle);
    }
  }
}

RunOutcome ReportBook::end_of(const RunReport& ended) {
  if (ended.ok) return RunOutcome::done;
  const AlarmReport* const alarm = alarms_.newest([&](const AlarmReport& report) {
    return report.channel == ended.channel && report.cycle >= ended.start_cycle &&
           report.cycle <= ended.end_cycle && report.cycle > 0;
  });
  if (alarm == nullptr) return RunOutcome::stopped;
  return alarm->diagnostic.code == "A1001" ? RunOutcome::estop : RunOutcome::alarm;
}

// That of its beginning, or a new one with the names that it has so far.
RunReport& ReportBook::report_of(const RunRecord& record) {
  RunReport* const known = find(record.channel, record.run);
  if (known != nullptr) return *known;
  RunReport begun;
  begun.channel = record.channel;
  begun.run = record.run;
  begun.begun_at = time_of(record.start_cycle);
  RunNames names = names_of({record.channel, record.run});
  begun.program = std::move(names.program);
  begun.files = std::move(names.files);
  runs_.make_room(record.channel, 1);
  return runs_.add(std::move(begun));
}

RunReport* ReportBook::find(int channel, std::uint32_t run) {
  return runs_.newest(
      [&](const RunReport& report) { return report.channel == channel && report.run == run; });
}

void ReportBook::drain_alarms() {
  AlarmRecord record;
  while (alarm_records_.pop(record)) {
    AlarmReport report;
    report.channel = record.channel;
    report.cycle = record.cycle;
    report.at = time_of(record.cycle);
    const auto explanation = explanations_.find({record.channel, record.tag.run});
    const std::string code(record.code.view());
    if (explanation != explanations_.end() && explanation->second.code == code) {
      report.diagnostic = explanation->second;
    } else {
      report.diagnostic.code = code;
      set_text(report.diagnostic, record.text.view());
      report.diagnostic.place.file = std::string(record.file.view());
      if (record.file.empty())
        report.diagnostic.place.file = names_of({record.channel, record.tag.run}).program;
      report.diagnostic.place.line = static_cast<int>(record.tag.line);
    }
    alarms_.make_room(report.channel, 1);
    blame(alarms_.add(std::move(report)));
  }
}

// The end of a run may be told before its alarm.
void ReportBook::blame(const AlarmReport& alarm) {
  RunReport* const run = runs_.newest([&](const RunReport& report) {
    return report.channel == alarm.channel && report.run != RunReport::recalled;
  });
  if (run != nullptr && run->end == RunOutcome::stopped && alarm.cycle <= run->end_cycle)
    run->end = end_of(*run);
}

}  // namespace stanok::channels
