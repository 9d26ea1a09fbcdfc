// FeedPlan: the feed along a block that keeps the cutting force at its set value, from what the
// block will meet.
//
//   F = C t h^y k,  k = (HB / HB_0)^e
// h is the distance over the last turn: where the cut becomes heavier the feed has to be lower one
// turn ahead, where it becomes lighter it may rise there. A pure function of its inputs.
#pragma once

#include <vector>

namespace stanok::jobs {

struct ForceModel {
  double coefficient_n = 1600.0;  // C
  double exponent = 0.75;         // y

  [[nodiscard]] double force_n(double depth_mm, double factor, double feed_per_rev) const;
  // The feed of a force; without a cut none limits it: infinity.
  [[nodiscard]] double feed_per_rev(double depth_mm, double factor, double force_n) const;
};

// What the tool meets at a place of its block.
struct CutPlace {
  double distance_mm = 0.0;  // along the block
  double depth_mm = 0.0;
  double factor = 1.0;  // k
};

struct FeedLimits {  // mm per turn
  double min = 0.0;
  double max = 0.0;
  double step = 0.001;  // feeds are multiples of it
};

// From this distance on, this feed.
struct FeedStretch {
  double begin_mm = 0.0;
  double feed_per_rev = 0.0;
};

// `places`: of a block, ascending, from distance 0 on. Stretches are as few as keep the force
// within a hundredth below its set value.
[[nodiscard]] std::vector<FeedStretch> plan_feeds(const std::vector<CutPlace>& places,
                                                  const ForceModel& model, double force_n,
                                                  const FeedLimits& limits);

}  // namespace stanok::jobs
