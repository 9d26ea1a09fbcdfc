// FeedClamps: S_min and S_max of force control: those of the program, else of the machine file,
// else by the programmed feed.
//
// A value; part of the force control of a channel, in the cycle.
#pragma once

#include <optional>

#include "base/rt_safe.h"
#include "motion/segments/feed_modifier.h"
#include "process/adaptive/force_control_config.h"

namespace stanok::process {

class FeedClamps {
 public:
  struct Limits {  // mm/s
    double min = 0.0;
    double max = 0.0;
  };

  FeedClamps() = default;
  explicit FeedClamps(const motion::ForceCommand& command) RT_SAFE;

  // Nothing: the block has no feed of its own (rapid), and nobody else gives any.
  [[nodiscard]] std::optional<Limits> resolve(const ForceControlConfig& config,
                                              const motion::CutState& cut) const RT_SAFE;

 private:
  double feed_min_ = 0.0;  // mm/s, or mm/rev
  double feed_max_ = 0.0;
  bool per_revolution_ = false;
};

}  // namespace stanok::process
