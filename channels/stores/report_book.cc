#include "channels/stores/report_book.h"

#include <algorithm>

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

}  // namespace

ReportBook::ReportBook() : run_records_(256), alarm_records_(256) {}

void ReportBook::name_run(int channel, std::uint32_t run, const std::string& program,
                          std::vector<std::string> files) {
  const std::lock_guard lock(mutex_);
  drain_runs();
  drain_alarms();
  const RunKey key{channel, run};
  names_[key] = {program, std::move(files)};
  const auto known = runs_.find(key);
  if (known == runs_.end()) return;
  known->second.program = names_[key].program;
  known->second.files = names_[key].files;
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
}

void ReportBook::add_diagnostics(int channel, const Diagnostics& diagnostics) {
  const std::lock_guard lock(mutex_);
  for (const Diagnostic& diagnostic : diagnostics)
    load_diagnostics_.push_back({channel, 0, diagnostic});
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
  std::vector<RunReport> reports;
  reports.reserve(order_.size());
  for (const RunKey& key : order_) reports.push_back(runs_.at(key));
  return reports;
}

std::vector<AlarmReport> ReportBook::alarms() {
  const std::lock_guard lock(mutex_);
  drain_alarms();
  return alarms_;
}

std::vector<AlarmReport> ReportBook::load_diagnostics() {
  const std::lock_guard lock(mutex_);
  return load_diagnostics_;
}

void ReportBook::drain_runs() {
  RunRecord record;
  while (run_records_.pop(record)) {
    const RunKey key{record.channel, record.run};
    if (!runs_.contains(key)) order_.push_back(key);
    RunReport& report = runs_[key];
    report.channel = record.channel;
    report.run = record.run;
    report.program = names_[key].program;
    report.files = names_[key].files;
    report.ok = record.ok;
    report.ended = record.ended;
    report.blocks = record.blocks;
    report.start_cycle = record.start_cycle;
    report.end_cycle = record.end_cycle;
    report.path_mm = record.path_mm;
    report.lookahead_max_blocks = record.lookahead_max_blocks;
    report.end_W = record.end_W;
    report.end_M = record.end_M;
    report.axis_count = record.axis_count;
  }
}

void ReportBook::drain_alarms() {
  AlarmRecord record;
  while (alarm_records_.pop(record)) {
    AlarmReport report;
    report.channel = record.channel;
    report.cycle = record.cycle;
    const auto explanation = explanations_.find({record.channel, record.tag.run});
    const std::string code(record.code.view());
    if (explanation != explanations_.end() && explanation->second.code == code) {
      report.diagnostic = explanation->second;
    } else {
      report.diagnostic.code = code;
      set_text(report.diagnostic, record.text.view());
      report.diagnostic.place.file = std::string(record.file.view());
      if (record.file.empty())
        report.diagnostic.place.file = names_[{record.channel, record.tag.run}].program;
      report.diagnostic.place.line = static_cast<int>(record.tag.line);
    }
    alarms_.push_back(std::move(report));
  }
}

}  // namespace stanok::channels
