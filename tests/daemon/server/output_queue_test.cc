// Lines on their way to one client: the bound, and the last word.
#include "daemon/server/output_queue.h"

#include <gtest/gtest.h>

namespace stanok::daemon {
namespace {

TEST(OutputQueue, TakesLinesUpToItsBound) {
  OutputQueue queue;
  const std::string line(OutputQueue::bytes_max / 4, 'x');
  for (int k = 0; k < 4; ++k) EXPECT_TRUE(queue.push(line));
  EXPECT_FALSE(queue.push("y"));
  EXPECT_EQ(queue.bytes(), OutputQueue::bytes_max);
  queue.pop_front();
  EXPECT_TRUE(queue.push("y"));
}

TEST(OutputQueue, TakesOneLongLineWhenNothingElseWaits) {
  OutputQueue queue;
  EXPECT_TRUE(queue.push(std::string(4 * OutputQueue::bytes_max, 'x')));
  EXPECT_FALSE(queue.push("y"));
}

TEST(OutputQueue, StatusWaitsWhileMuchIsOnItsWay) {
  OutputQueue queue;
  EXPECT_TRUE(queue.has_room_for_status());
  ASSERT_TRUE(queue.push(std::string(OutputQueue::status_bytes_max + 1, 'x')));
  EXPECT_FALSE(queue.has_room_for_status());
}

TEST(OutputQueue, TheLastWordComesAfterWhatIsBeingWritten) {
  OutputQueue queue;
  ASSERT_TRUE(queue.push("begun"));
  ASSERT_TRUE(queue.push("waiting"));
  queue.end_with("last");
  EXPECT_EQ(queue.bytes(), 9U);
  EXPECT_EQ(queue.front(), "begun");
  queue.pop_front();
  EXPECT_EQ(queue.front(), "last");
  queue.pop_front();
  EXPECT_TRUE(queue.empty());
  EXPECT_EQ(queue.bytes(), 0U);
}

}  // namespace
}  // namespace stanok::daemon
