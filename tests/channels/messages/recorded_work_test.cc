// Where the preparation of a recorded run took over writes of the tables.
#include "channels/messages/recorded_work.h"

#include <gtest/gtest.h>

namespace stanok::channels {
namespace {

TEST(RecordedWorkTest, GivesATakingAtItsCommandOnly) {
  RecordedWork work;
  work.takings = {{.run = 2, .command = 5, .version = 10}, {.run = 2, .command = 5, .version = 11}};
  EXPECT_EQ(work.at(1, 9), nullptr);
  EXPECT_EQ(work.at(2, 4), nullptr);
  ASSERT_NE(work.at(2, 5), nullptr);
  EXPECT_EQ(work.at(2, 5)->version, 10U);
  work.takings.pop_front();
  EXPECT_EQ(work.at(2, 5)->version, 11U);
}

// The recorded run came farther than the repetition has to.
TEST(RecordedWorkTest, ForgetsWhatIsNeverReached) {
  RecordedWork work;
  work.takings = {{.run = 2, .command = 5, .version = 10}, {.run = 4, .command = 1, .version = 12}};
  EXPECT_EQ(work.at(3, 0), nullptr);
  ASSERT_EQ(work.takings.size(), 1U);
  EXPECT_EQ(work.at(4, 1)->version, 12U);
  EXPECT_EQ(work.at(4, 2), nullptr);
  EXPECT_TRUE(work.takings.empty());
}

}  // namespace
}  // namespace stanok::channels
