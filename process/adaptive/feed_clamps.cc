#include "process/adaptive/feed_clamps.h"

#include <algorithm>

#include "base/units.h"

namespace stanok::process {
namespace {

// The smallest feed where neither program nor machine file gives one, part of the programmed one.
constexpr double feed_min_part_default = 0.05;

}  // namespace

FeedClamps::FeedClamps(const motion::ForceCommand& command) RT_SAFE
    : feed_min_(command.feed_min),
      feed_max_(command.feed_max),
      per_revolution_(command.per_revolution) {
  if (per_revolution_) return;
  feed_min_ /= seconds_per_minute;
  feed_max_ /= seconds_per_minute;
}

std::optional<FeedClamps::Limits> FeedClamps::resolve(const ForceControlConfig& config,
                                                      const motion::CutState& cut) const RT_SAFE {
  const double unit = per_revolution_ ? cut.rev_per_min / seconds_per_minute : 1.0;
  double feed_max = unit * feed_max_;
  if (feed_max <= 0.0) feed_max = config.feed_max;
  if (feed_max <= 0.0) feed_max = cut.feed_programmed;
  double feed_min = unit * feed_min_;
  if (feed_min <= 0.0) feed_min = config.feed_min;
  if (feed_min <= 0.0) feed_min = feed_min_part_default * cut.feed_programmed;
  if (feed_max <= 0.0 || feed_min <= 0.0) return std::nullopt;
  return Limits{.min = std::min(feed_min, feed_max), .max = feed_max};
}

}  // namespace stanok::process
