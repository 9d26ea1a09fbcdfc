// What a machine tells people of the runs, alarms, searches and blocks of its channels. Made
// outside of the cycle.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "base/diagnostic.h"
#include "lang/contract/meaning.h"
#include "lang/run/block_search.h"
#include "motion/path/path.h"

namespace stanok::channels {

// How a run ended; none: it has not.
enum class RunOutcome : std::uint8_t { none, done, stopped, alarm, estop, cut_off };

// Periods of the clock in which no cycle ran, during a run: in all, and the most in a row.
struct LostPeriods {
  std::int64_t total = 0;
  std::int64_t longest = 0;
};

// One finished (or running) program run of a channel, for reports.
struct RunReport {
  // The `run` of one that an earlier start of the machine has left behind: it has no cycles.
  static constexpr std::uint32_t recalled = std::numeric_limits<std::uint32_t>::max();

  int channel = 0;
  std::uint64_t number = 0;  // in its channel: 1, 2, ...
  std::uint32_t run = 0;
  std::string program;
  std::vector<std::string> files;  // 0 the program itself, then what it includes and calls
  bool ok = false;
  bool ended = false;
  std::uint64_t blocks = 0;
  RunOutcome end = RunOutcome::none;
  std::int64_t start_cycle = 0;
  std::int64_t end_cycle = 0;
  double begun_at = 0.0;  // Unix time in s, as all times here; 0: not known
  double ended_at = 0.0;
  double path_mm = 0.0;  // feed and rapid
  std::uint32_t lookahead_max_blocks = 0;
  LostPeriods lost{};
  motion::Point end_W{};  // channel axis order
  motion::Point end_M{};
  int axis_count = 0;
};

// An alarm of a channel, with its diagnostic when a program is to blame.
struct AlarmReport {
  int channel = 0;
  std::uint64_t number = 0;  // in its channel: 1, 2, ...
  std::int64_t cycle = 0;    // 0: none, as it was told outside of the cycle
  double at = 0.0;           // Unix time in s; 0: not known
  bool is_over = false;      // of an earlier start of the machine, and no longer active
  Diagnostic diagnostic;
};

// What earlier starts of a machine have left behind, the oldest first; numbers go on behind it.
struct Past {
  std::vector<RunReport> runs;
  std::vector<AlarmReport> alarms;
  // Numbers of alarms that were given and are not given again, by channel, though the alarm is
  // lost.
  std::map<int, std::uint64_t> alarm_numbers{};
};

// When a cycle was, as Unix time in s. Any thread but the cycle's.
using TimeOfCycle = std::function<double(std::int64_t cycle)>;

// How many reports of a channel there have been so far.
template <class Report>
[[nodiscard]] std::uint64_t newest_number(const std::vector<Report>& reports, int channel) {
  std::uint64_t number = 0;
  for (const Report& report : reports) {
    if (report.channel == channel) number = report.number;
  }
  return number;
}

// How many older ones of the channel, or (0) of all channels, are not kept any more.
template <class Report>
[[nodiscard]] std::uint64_t forgotten(const std::vector<Report>& reports, int channel) {
  std::set<int> seen;
  std::uint64_t count = 0;
  for (const Report& oldest : reports) {
    const bool is_asked_for = channel == 0 || oldest.channel == channel;
    if (is_asked_for && seen.insert(oldest.channel).second) count += oldest.number - 1;
  }
  return count;
}

// What a search came to, for people. Positions as words in what the block found is read in, and the
// point, in the order of the words.
struct SearchReport {
  std::string file;
  std::uint32_t line = 0;
  std::vector<std::string> words;
  std::vector<double> position;   // programmed at the target; empty: not calculated
  std::vector<double> point_W;    // likewise, in the workpiece system: radii
  std::vector<double> stands_at;  // the axes now, as words there
  lang::Meaning meaning;          // of the words
  lang::SearchState state;
  // How the tool would come there; a start says which of them it means.
  std::uint32_t number = 0;     // of this search, of all of the channel
  std::uint32_t situation = 0;  // in which it holds
  std::vector<double> axes_M;   // and from where
  struct Leg {
    enum class Kind : std::uint8_t { lift, lateral, plunge };
    Kind kind = Kind::lift;
    std::vector<double> end;  // as words
    double length_mm = 0.0;
  };
  std::vector<Leg> approach;
  double plunge_feed_mm_min = 0.0;
};

// What gives the words of a channel their meaning, and where its current block ends.
struct SituationReport {
  std::uint32_t number = 0;
  lang::Meaning meaning;
  // Of the current block or the latest one before it that moves, in the workpiece system of that
  // block; nothing: none does, or no program runs.
  std::optional<motion::Point> end_W{};
};

}  // namespace stanok::channels
