// The way of results into the rings, without a feed before it and a cycle behind it.
#include "channels/preparation/queue_sink.h"

#include <gtest/gtest.h>

#include "channels/contract/motion_config.h"
#include "tests/channels/preparation/preparation_bench.h"

namespace stanok::channels {
namespace {

class QueueSinkTest : public ::testing::Test {
 protected:
  static Item dwell() {
    return {.tag = {.run = 1, .block = 5, .line = 9}, .content = lang::Dwell{}};
  }

  PreparationBench bench_;
  motion::MotionConfig motion_ = motion_config(bench_.machine, bench_.channel);
  QueueSink sink_{motion_, bench_.link, bench_.shared, bench_.blocks};
};

TEST_F(QueueSinkTest, AnItemKnowsTheRidersBeforeIt) {
  sink_.take_rider({});
  sink_.take_rider({});
  sink_.take_item(dwell());
  EXPECT_TRUE(sink_.holds_items());
  EXPECT_TRUE(sink_.flush());
  EXPECT_FALSE(sink_.holds_items());
  const auto items = bench_.items();
  ASSERT_EQ(items.size(), 1U);
  EXPECT_EQ(items[0].after_rider, 2U);
  EXPECT_EQ(items[0].after_chunk, 0U);
  EXPECT_EQ(bench_.link.riders.pushed(), 2U);
}

TEST_F(QueueSinkTest, WhatHasNoRoomWaitsAndNothingIsLost) {
  const std::size_t room = bench_.link.items.capacity();
  for (std::size_t k = 0; k < room + 3; ++k) sink_.take_item(dwell());
  EXPECT_FALSE(sink_.flush());
  EXPECT_TRUE(sink_.holds_items());
  EXPECT_EQ(bench_.items().size(), room);
  EXPECT_TRUE(sink_.flush());
  EXPECT_EQ(bench_.items().size(), 3U);
}

TEST_F(QueueSinkTest, WhatIsForgottenNeverArrives) {
  sink_.take_item(dwell());
  sink_.take_rider({});
  sink_.take_remark({});
  sink_.forget();
  EXPECT_TRUE(sink_.flush());
  EXPECT_TRUE(bench_.items().empty());
  EXPECT_EQ(bench_.link.riders.pushed(), 0U);
  EXPECT_EQ(bench_.link.remarks.pushed(), 0U);
}

}  // namespace
}  // namespace stanok::channels
