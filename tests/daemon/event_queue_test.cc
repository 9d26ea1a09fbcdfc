// Operator events into the cycle: in order, without the heap, and with room for stops always.
#include "daemon/event_queue.h"

#include <gtest/gtest.h>

#include "tests/support/no_allocation.h"

namespace stanok::daemon {
namespace {

using channels::OperatorAction;
using channels::OperatorEvent;

OperatorEvent event(OperatorAction action, std::uint64_t id = 0) {
  OperatorEvent made;
  made.action = action;
  made.id = id;
  return made;
}

TEST(EventQueue, KeepsTheOrder) {
  EventQueue queue;
  for (std::uint64_t id = 1; id <= 10; ++id) {
    const auto action = id % 2 == 0 ? OperatorAction::program_hold : OperatorAction::override_feed;
    ASSERT_TRUE(queue.put(event(action, id)));
  }
  const auto taken = queue.take();
  ASSERT_EQ(taken.size(), 10U);
  for (std::uint64_t id = 1; id <= 10; ++id) EXPECT_EQ(taken[id - 1].id, id);
  EXPECT_TRUE(queue.take().empty());
}

TEST(EventQueue, TakesStopsWhenItIsFullOfOtherThings) {
  EventQueue queue;
  std::size_t ordinary = 0;
  while (queue.put(event(OperatorAction::override_feed))) ++ordinary;
  EXPECT_EQ(ordinary, EventQueue::capacity - EventQueue::kept_for_stops);
  for (const auto stop :
       {OperatorAction::machine_estop, OperatorAction::machine_off, OperatorAction::program_hold,
        OperatorAction::program_stop, OperatorAction::program_reset}) {
    EXPECT_TRUE(queue.put(event(stop)));
  }
  EXPECT_FALSE(queue.put(event(OperatorAction::program_start)))
      << "nothing starts from the places of stops";
}

TEST(EventQueue, IsTakenWithoutTheHeap) {
  EventQueue queue;
  for (int k = 0; k < 20; ++k) ASSERT_TRUE(queue.put(event(OperatorAction::program_hold)));
  const testing::NoAllocation guard;
  EXPECT_EQ(queue.take().size(), 20U);
}

}  // namespace
}  // namespace stanok::daemon
