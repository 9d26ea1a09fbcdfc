#include "channels/cycle/run_book.h"

#include <algorithm>

namespace stanok::channels {

void RunBook::begin(const motion::InterpolatorOutput& path) RT_SAFE {
  ++run_;
  program_ = {};
  result_before_ = result_;
  result_ = RunResult::failed;
  was_reset_ = false;
  start_cycle_ = cycle_;
  path_mm_ = 0.0;
  lookahead_max_ = 0;
  blocks_ = 0;
  reports_.put(record(path));
}

void RunBook::advance(const motion::InterpolatorOutput& path, std::uint32_t lookahead_blocks)
    RT_SAFE {
  lookahead_max_ = std::max(lookahead_max_, lookahead_blocks);
  path_mm_ += path.path_advanced;
  if (path.tag.run == run_) blocks_ = std::max(blocks_, path.tag.block);
}

void RunBook::end(RunResult result, std::uint64_t blocks, const motion::InterpolatorOutput& path)
    RT_SAFE {
  result_ = result;
  end_cycle_ = cycle_;
  RunRecord ended = record(path);
  ended.ended = true;
  ended.ok = result == RunResult::succeeded;
  ended.blocks = blocks;
  reports_.put(ended);
}

bool RunBook::ended_well(std::uint32_t run) const RT_SAFE {
  if (run == run_) return result_ == RunResult::succeeded;
  return run + 1 == run_ && result_before_ == RunResult::succeeded;
}

RunRecord RunBook::record(const motion::InterpolatorOutput& path) const RT_SAFE {
  RunRecord record;
  record.channel = channel_;
  record.run = run_;
  record.start_cycle = start_cycle_;
  record.end_cycle = cycle_;
  record.path_mm = path_mm_;
  record.lookahead_max_blocks = lookahead_max_;
  record.blocks = blocks_;
  record.axis_count = axis_count_;
  for (std::size_t k = 0; k < motion::axes_max; ++k) {
    record.end_W[k] = path.point[k].value;
    record.end_M[k] = path.axes[k].value;
  }
  return record;
}

}  // namespace stanok::channels
