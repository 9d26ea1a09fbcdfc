#include "channels/cycle/run_book.h"

#include <algorithm>

namespace stanok::channels {

RunBook::RunBook(std::int32_t channel, int axis_count, ReportBook& reports) : reports_(reports) {
  now_ = {.channel = channel, .ended = true, .axis_count = axis_count};
}

void RunBook::begin(const motion::InterpolatorOutput& path) RT_SAFE {
  now_ = {.channel = now_.channel,
          .run = now_.run + 1,
          .start_cycle = cycle_,
          .axis_count = now_.axis_count};
  program_ = {};
  result_before_ = result_;
  result_ = RunResult::failed;
  was_reset_ = false;
  report(path);
}

void RunBook::advance(const motion::InterpolatorOutput& path, std::uint32_t lookahead_blocks)
    RT_SAFE {
  now_.lookahead_max_blocks = std::max(now_.lookahead_max_blocks, lookahead_blocks);
  now_.path_mm += path.path_advanced;
  if (path.tag.run == now_.run) now_.blocks = std::max(now_.blocks, path.tag.block);
}

void RunBook::end(RunResult result, std::uint64_t blocks, const motion::InterpolatorOutput& path)
    RT_SAFE {
  result_ = result;
  end_cycle_ = cycle_;
  now_.ended = true;
  now_.ok = result == RunResult::succeeded;
  now_.blocks = blocks;
  report(path);
}

void RunBook::note_lost_periods(std::int64_t periods) RT_SAFE {
  if (now_.ended) return;
  now_.lost.total += periods;
  now_.lost.longest = std::max(now_.lost.longest, periods);
}

bool RunBook::ended_well(std::uint32_t run) const RT_SAFE {
  if (run == now_.run) return result_ == RunResult::succeeded;
  return run + 1 == now_.run && result_before_ == RunResult::succeeded;
}

void RunBook::report(const motion::InterpolatorOutput& path) RT_SAFE {
  now_.end_cycle = cycle_;
  for (std::size_t k = 0; k < motion::axes_max; ++k) {
    now_.end_W[k] = path.point[k].value;
    now_.end_M[k] = path.axes[k].value;
  }
  reports_.put(now_);
}

}  // namespace stanok::channels
