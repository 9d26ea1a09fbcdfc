// The stretches of the alternating law, by its definition: every other dl at the other feed.
#include "motion/feed_laws/alternating_law.h"

#include <gtest/gtest.h>

namespace stanok::motion {
namespace {

TEST(AlternatingLaw, ChangesItsFeedAfterEachStep) {
  const AlternatingLaw law({}, {.feed_min = 60.0, .feed_max = 240.0, .path_step_mm = 0.5});
  for (std::uint64_t k = 0; k < 10; ++k) {
    EXPECT_EQ(law.stretch(k).feed, k % 2 == 0 ? 60.0 : 240.0);
    EXPECT_EQ(law.stretch(k).end_mm, 0.5 * static_cast<double>(k + 1));
  }
  EXPECT_EQ(law.increments_at(0.4), 0U);
  EXPECT_EQ(law.increments_at(1.7), 3U);
  EXPECT_EQ(law.highest_feed(0.4), 60.0);
  EXPECT_EQ(law.highest_feed(1.7), 240.0);
}

}  // namespace
}  // namespace stanok::motion
