// A feed that fell to S_min at once: a power that answers, and one that stays.
#include "process/adaptive/fallen_feed.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace stanok::process {
namespace {

constexpr double cycle_s = 0.001;
constexpr double feed_min = 0.05;

// The feed falls from 0.3 mm evenly in its logarithm; the force is what `force_of` makes of it.
template <class Force>
bool is_found(double fall_s, const Force& force_of) {
  FallenFeed fallen;
  bool found = false;
  for (double time_s = -2.0; time_s < fall_s + 3.0; time_s += cycle_s) {
    const double part = std::clamp(time_s / fall_s, 0.0, 1.0);
    const double feed = 0.3 * std::pow(feed_min / 0.3, part);
    found = fallen.look({.cycle_s = cycle_s,
                         .force_n = force_of(time_s, feed),
                         .feed = feed,
                         .is_at_minimum = part >= 1.0}) ||
            found;
  }
  return found;
}

TEST(FallenFeed, APowerThatStaysIsFound) {
  EXPECT_TRUE(is_found(1.0, [](double, double) { return 1800.0; }));
}

// Three times as deep from the moment on in which the feed begins to fall.
TEST(FallenFeed, AHeavierCutHasAnswered) {
  EXPECT_FALSE(is_found(1.0, [](double time_s, double feed) {
    return (time_s < 0.0 ? 3000.0 : 9000.0) * std::pow(feed, 0.75);
  }));
}

// The controller holds the force while the cut becomes heavier by and by.
TEST(FallenFeed, ASlowFallIsNotJudged) {
  EXPECT_FALSE(is_found(30.0, [](double, double) { return 1200.0; }));
}

}  // namespace
}  // namespace stanok::process
