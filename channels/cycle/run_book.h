// RunBook: the run of a channel: which one it is, what it has done, how it and the one before
// ended.
//
// Records of its begin and its end go to the reports of the machine. Thread: the real-time cycle.
// Owner: the channel; RunControl begins and ends runs.
#pragma once

#include <cstdint>

#include "base/rt_safe.h"
#include "channels/messages/item.h"
#include "channels/stores/report_book.h"
#include "motion/interpolation/interpolator.h"

namespace stanok::channels {

enum class RunResult : std::uint8_t { succeeded, failed };

class RunBook {
 public:
  // `reports` outlives the book.
  RunBook(std::int32_t channel, int axis_count, ReportBook& reports);

  // A new cycle.
  void begin_cycle(std::int64_t cycle) RT_SAFE { cycle_ = cycle; }
  void begin(const motion::InterpolatorOutput& path) RT_SAFE;
  // What the path did in this cycle; blocks that the look-ahead saw of the chunk at its front.
  void advance(const motion::InterpolatorOutput& path, std::uint32_t lookahead_blocks) RT_SAFE;
  void end(RunResult result, std::uint64_t blocks, const motion::InterpolatorOutput& path) RT_SAFE;
  // An alarm: whatever comes, the run has not ended well.
  void spoil() RT_SAFE { result_ = RunResult::failed; }
  // Periods of the clock that passed without a cycle; only a run under way counts them.
  void note_lost_periods(std::int64_t periods) RT_SAFE;
  void note_reset() RT_SAFE { was_reset_ = true; }
  void name_program(const FileName& name) RT_SAFE { program_ = name; }

  [[nodiscard]] std::int64_t cycle() const RT_SAFE { return cycle_; }
  [[nodiscard]] std::uint32_t run() const RT_SAFE { return now_.run; }
  // How this run, or the one before it, ended.
  [[nodiscard]] bool ended_well(std::uint32_t run) const RT_SAFE;
  [[nodiscard]] bool was_reset() const RT_SAFE { return was_reset_; }  // since the latest run
  [[nodiscard]] std::int64_t start_cycle() const RT_SAFE { return now_.start_cycle; }
  [[nodiscard]] std::int64_t end_cycle() const RT_SAFE { return end_cycle_; }
  [[nodiscard]] std::uint64_t blocks() const RT_SAFE { return now_.blocks; }
  // Empty until its first block is executed.
  [[nodiscard]] const FileName& program() const RT_SAFE { return program_; }

 private:
  void report(const motion::InterpolatorOutput& path) RT_SAFE;

  ReportBook& reports_;
  std::int64_t cycle_ = 0;
  RunRecord now_;  // of this run, or of the latest; run 0: there was none
  RunResult result_ = RunResult::succeeded;
  RunResult result_before_ = RunResult::succeeded;
  bool was_reset_ = false;
  std::int64_t end_cycle_ = 0;
  FileName program_;
};

}  // namespace stanok::channels
