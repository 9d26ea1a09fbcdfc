// ReportBook: what the preparations and the cycle told of runs and alarms, in words, for people and
// programs outside.
//
// The cycle hands over plain records through rings; texts and diagnostics come from the
// preparations. Any thread. Bound of the rings: they are emptied whenever a run is named, which
// the preparation does at the begin of each, so that between two runs of a channel at most two
// records of it wait, and what a fault or a stop adds. Of each channel the newest runs, alarms and
// diagnostics are kept, however long the machine runs.
#pragma once

#include <atomic>
#include <map>
#include <mutex>
#include <optional>
#include <vector>

#include "base/fixed_text.h"
#include "base/ring.h"
#include "channels/contract/reports.h"
#include "channels/stores/channel_history.h"

namespace stanok::channels {

// A run at its start and at its end, as the cycle saw it.
struct RunRecord {
  std::int32_t channel = 0;
  std::uint32_t run = 0;
  bool ended = false;
  bool ok = false;
  std::uint64_t blocks = 0;
  std::int64_t start_cycle = 0;
  std::int64_t end_cycle = 0;
  double path_mm = 0.0;
  std::uint32_t lookahead_max_blocks = 0;
  LostPeriods lost{};
  motion::Point end_W{};
  motion::Point end_M{};
  std::int32_t axis_count = 0;
};

// An alarm as the cycle raised it.
struct AlarmRecord {
  std::int32_t channel = 0;
  std::int64_t cycle = 0;
  motion::BlockTag tag;
  FixedText<8> code;
  FixedText<1024> text;  // lines after the first are notes
  FixedText<96> file;    // of the program; empty: none
};

class ReportBook {
 public:
  static constexpr std::size_t kept_max_default = 500;

  // `kept_max`: of each channel and kind. The diagnostics of the latest load are kept whole.
  explicit ReportBook(std::size_t kept_max = kept_max_default);

  // Before all else: what there was before, and the clock by which reports say when it was.
  void recall(Past past, TimeOfCycle time_of);

  // Preparation side.
  // `files`: by the index in the tags of its blocks.
  void name_run(int channel, std::uint32_t run, const std::string& program,
                std::vector<std::string> files);
  void explain(int channel, std::uint32_t run, const Diagnostic& diagnostic);
  void add_diagnostics(int channel, const Diagnostics& diagnostics);
  // Where the next run begins; nothing: at the first block.
  void tell_search(int channel, const std::optional<SearchReport>& report);

  // Cycle side. What finds no place is lost and counted.
  void put(const RunRecord& record) RT_SAFE;
  void put(const AlarmRecord& record) RT_SAFE;
  // Since construction; any thread.
  [[nodiscard]] std::uint64_t lost() const RT_SAFE { return lost_; }

  // Any thread but the cycle's.
  // An alarm that no cycle has raised; its number.
  std::uint64_t note(AlarmReport alarm);
  [[nodiscard]] std::vector<RunReport> runs();
  [[nodiscard]] std::vector<AlarmReport> alarms();
  [[nodiscard]] std::vector<AlarmReport> load_diagnostics();
  [[nodiscard]] std::optional<SearchReport> search(int channel);

 private:
  using RunKey = std::pair<int, std::uint32_t>;
  struct RunNames {
    std::string program;
    std::vector<std::string> files;
  };

  void drain_runs();
  void drain_alarms();
  [[nodiscard]] RunReport& report_of(const RunRecord& record);
  [[nodiscard]] RunReport* find(int channel, std::uint32_t run);  // nullptr: it is not known
  [[nodiscard]] double time_of(std::int64_t cycle) const;
  [[nodiscard]] RunOutcome end_of(const RunReport& ended);
  void blame(const AlarmReport& alarm);
  [[nodiscard]] RunNames names_of(const RunKey& key) const;

  std::size_t kept_max_;
  TimeOfCycle time_of_;
  std::mutex mutex_;
  Ring<RunRecord> run_records_;
  Ring<AlarmRecord> alarm_records_;
  std::atomic<std::uint64_t> lost_{0};
  std::map<RunKey, RunNames> names_;
  std::map<RunKey, Diagnostic> explanations_;
  ChannelHistory<RunReport> runs_;
  ChannelHistory<AlarmReport> alarms_;
  ChannelHistory<AlarmReport> load_diagnostics_;
  std::map<int, SearchReport> searches_;  // by channel
};

}  // namespace stanok::channels
