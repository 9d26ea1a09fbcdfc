#include "programs/generators/workload.h"

namespace stanok::programs {

ProgramWriter fitted(const LayOut& lay_out, int blocks, double time_s, double feed_ratio,
                     const WorkloadOptions& options) {
  constexpr double trial_feed = 1000.0;
  const auto fixed_blocks = lay_out({0, trial_feed, trial_feed}).blocks();
  const int row_blocks = blocks - static_cast<int>(fixed_blocks);
  const ProgramWriter trial = lay_out({row_blocks, feed_ratio * trial_feed, trial_feed});
  const double feed_high = options.feed_high.value_or(trial_feed * trial.feed_time_s() / time_s);
  const double feed_low = options.feed_low.value_or(feed_ratio * feed_high);
  return lay_out({row_blocks, feed_low, feed_high});
}

}  // namespace stanok::programs
