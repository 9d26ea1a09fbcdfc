#include "jobs/cutting/feed_plan.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace stanok::jobs {
namespace {

// A stretch may go on while its feed is at most this much below what is permitted.
constexpr double same_feed = 0.012;

double floored(double feed, const FeedLimits& limits) {
  const double steps = std::floor(feed / limits.step + 1e-9);
  return std::clamp(steps * limits.step, limits.min, limits.max);
}

}  // namespace

double ForceModel::force_n(double depth_mm, double factor, double feed_per_rev) const {
  return coefficient_n * depth_mm * factor * std::pow(feed_per_rev, exponent);
}

double ForceModel::feed_per_rev(double depth_mm, double factor, double force_n) const {
  const double unit = coefficient_n * depth_mm * factor;
  if (unit <= 0.0) return std::numeric_limits<double>::infinity();
  return std::pow(force_n / unit, 1.0 / exponent);
}

std::vector<FeedStretch> plan_feeds(const std::vector<CutPlace>& places, const ForceModel& model,
                                    double force_n, const FeedLimits& limits) {
  std::vector<double> permitted;
  permitted.reserve(places.size());
  for (const CutPlace& place : places) {
    permitted.push_back(floored(model.feed_per_rev(place.depth_mm, place.factor, force_n), limits));
  }
  // One turn ahead, which is as long as the feed there.
  std::vector<double> allowed = permitted;
  for (std::size_t k = 0; k < places.size(); ++k) {
    const double from = places[k].distance_mm - permitted[k];
    for (std::size_t reached = k; reached > 0 && places[reached].distance_mm > from; --reached)
      allowed[reached - 1] = std::min(allowed[reached - 1], permitted[k]);
  }
  std::vector<FeedStretch> stretches;
  for (std::size_t k = 0; k < places.size(); ++k) {
    const double feed = allowed[k];
    const bool goes_on = !stretches.empty() && feed >= stretches.back().feed_per_rev &&
                         feed <= stretches.back().feed_per_rev * (1.0 + same_feed);
    if (goes_on) continue;
    stretches.push_back({places[k].distance_mm, feed});
  }
  return stretches;
}

}  // namespace stanok::jobs
