// Operator events into the cycle: in order, without the heap, and with room for stops always.
#include "daemon/cycle/event_queue.h"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>
#include <vector>

#include "tests/support/no_allocation.h"

namespace stanok::daemon {
namespace {

using channels::OperatorAction;
using channels::OperatorEvent;

OperatorEvent event(OperatorAction action, std::uint64_t id = 0) {
  OperatorEvent made;
  made.command = channels::command_of({.action = action}).value();
  made.id = id;
  return made;
}

TEST(EventQueue, KeepsTheOrder) {
  EventQueue queue;
  for (std::uint64_t id = 1; id <= 10; ++id) {
    const auto action = id % 2 == 0 ? OperatorAction::program_hold : OperatorAction::override_feed;
    ASSERT_TRUE(queue.put(event(action, id)));
  }
  const auto taken = queue.take().events;
  ASSERT_EQ(taken.size(), 10U);
  for (std::uint64_t id = 1; id <= 10; ++id) EXPECT_EQ(taken[id - 1].id, id);
  EXPECT_TRUE(queue.take().events.empty());
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

TEST(EventQueue, HandsOnNothingThatWasWithdrawnButStops) {
  EventQueue queue;
  ASSERT_TRUE(queue.put(event(OperatorAction::override_feed, 1)));
  EXPECT_EQ(queue.take().events.size(), 1U);
  ASSERT_TRUE(queue.put(event(OperatorAction::program_start, 2)));
  ASSERT_TRUE(queue.put(event(OperatorAction::program_hold, 3)));
  EXPECT_EQ(queue.withdraw(3), 1U) << "the cycle has seen the first one only";
  ASSERT_TRUE(queue.put(event(OperatorAction::program_start, 4)));
  const auto taken = queue.take();
  ASSERT_EQ(taken.events.size(), 2U);
  EXPECT_EQ(taken.events[0].id, 3U);
  EXPECT_EQ(taken.events[1].id, 4U);
  ASSERT_EQ(taken.overtaken.size(), 1U);
  EXPECT_EQ(taken.overtaken[0].id, 2U);
}

// What is told to be void has no effect, whenever the cycle comes.
TEST(EventQueue, NeverHandsOnWhatIsSaidToBeWithdrawn) {
  constexpr std::uint64_t seeds = 1000;
  for (std::uint64_t seed = 0; seed < seeds; ++seed) {
    EventQueue queue;
    constexpr std::uint64_t events = 8;
    for (std::uint64_t id = 1; id <= events; ++id)
      ASSERT_TRUE(queue.put(event(OperatorAction::program_start, id)));
    std::atomic<bool> begins{false};
    std::vector<std::uint64_t> effects;
    std::jthread cycle([&] {
      while (!begins) std::this_thread::yield();
      for (std::uint64_t n = 0; n < seed % 50; ++n) std::this_thread::yield();
      for (const OperatorEvent& taken : queue.take().events) effects.push_back(taken.id);
    });
    begins = true;
    for (std::uint64_t n = 0; n < seed % 37; ++n) std::this_thread::yield();
    const std::uint64_t newest_taken = queue.withdraw(events);
    cycle.join();
    for (const std::uint64_t id : effects) EXPECT_LE(id, newest_taken) << "seed " << seed;
  }
}

TEST(EventQueue, IsTakenWithoutTheHeap) {
  EventQueue queue;
  for (int k = 0; k < 20; ++k) ASSERT_TRUE(queue.put(event(OperatorAction::program_hold)));
  const testing::NoAllocation guard;
  EXPECT_EQ(queue.take().events.size(), 20U);
}

OperatorEvent of_channel(OperatorAction action, int channel, std::uint64_t stops_before) {
  OperatorEvent made = event(action);
  made.channel = channel;
  made.stops_before = stops_before;
  return made;
}

std::vector<OperatorAction> actions(std::span<const OperatorEvent> events) {
  std::vector<OperatorAction> all;
  for (const OperatorEvent& one : events) all.push_back(one.action());
  return all;
}

using Actions = std::vector<OperatorAction>;

TEST(EventQueue, NothingBeginsBehindAStopThatWasAskedForLater) {
  EventQueue queue;
  ASSERT_TRUE(queue.put(of_channel(OperatorAction::program_run, 1, 0)));
  ASSERT_TRUE(queue.put(of_channel(OperatorAction::override_feed, 1, 0)));
  ASSERT_TRUE(queue.put(of_channel(OperatorAction::program_run, 2, 0)));
  ASSERT_TRUE(queue.put_stop(of_channel(OperatorAction::program_stop, 1, 0)));
  const auto first = queue.take();
  EXPECT_EQ(actions(first.events),
            (Actions{OperatorAction::override_feed, OperatorAction::program_run,
                     OperatorAction::program_stop}));
  EXPECT_EQ(actions(first.overtaken), Actions{OperatorAction::program_run});
  EXPECT_EQ(first.overtaken.front().channel, 1);
  // What comes to the queue late has been overtaken all the same; a stop of all is one of each.
  ASSERT_TRUE(queue.put(of_channel(OperatorAction::jog, 1, 0)));
  EXPECT_EQ(queue.take().overtaken.size(), 1U);
  ASSERT_TRUE(queue.put_stop(of_channel(OperatorAction::machine_estop, 0, 0)));
  ASSERT_TRUE(queue.put(of_channel(OperatorAction::jog, 2, 1)));
  ASSERT_TRUE(queue.put(of_channel(OperatorAction::machine_on, 0, 1)));
  EXPECT_EQ(queue.take().overtaken.size(), 2U);
}

TEST(EventQueue, WhatWasAskedForAfterAStopComesBehindIt) {
  EventQueue queue;
  ASSERT_TRUE(queue.put_stop(of_channel(OperatorAction::program_reset, 1, 0)));
  ASSERT_EQ(queue.stops_put(), 1U);
  ASSERT_TRUE(queue.put(of_channel(OperatorAction::override_feed, 1, 0)));
  ASSERT_TRUE(queue.put(of_channel(OperatorAction::program_run, 1, queue.stops_put())));
  const auto taken = queue.take();
  EXPECT_EQ(actions(taken.events),
            (Actions{OperatorAction::override_feed, OperatorAction::program_reset,
                     OperatorAction::program_run}));
  EXPECT_TRUE(taken.overtaken.empty());
}

TEST(EventQueue, KeepsRoomForAnEmergencyStopAmongStops) {
  EventQueue queue;
  while (queue.put_stop(event(OperatorAction::program_hold))) {
  }
  EXPECT_TRUE(queue.put_stop(event(OperatorAction::machine_estop)));
  EXPECT_TRUE(queue.put_stop(event(OperatorAction::machine_off)));
}

}  // namespace
}  // namespace stanok::daemon
