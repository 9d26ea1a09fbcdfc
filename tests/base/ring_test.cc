#include "base/ring.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <deque>
#include <random>
#include <thread>

#include "base/assert.h"
#include "tests/support/no_allocation.h"

namespace stanok {
namespace {

TEST(Ring, GivesBackWhatWentInInOrder) {
  Ring<int> ring(3);
  EXPECT_TRUE(ring.empty());
  EXPECT_TRUE(ring.push(1) && ring.push(2) && ring.push(3));
  int value = 0;
  for (const int expected : {1, 2, 3}) {
    ASSERT_TRUE(ring.pop(value));
    EXPECT_EQ(value, expected);
  }
  EXPECT_FALSE(ring.pop(value));
  EXPECT_EQ(value, 3) << "an empty ring leaves the value as it was";
}

TEST(Ring, RefusesWhenFullAndLosesNothing) {
  Ring<int> ring(2);
  EXPECT_TRUE(ring.push(1) && ring.push(2));
  EXPECT_FALSE(ring.push(3));
  EXPECT_EQ(ring.size(), 2U);
  EXPECT_EQ(ring.space(), 0U);
  ring.pop_front();
  EXPECT_TRUE(ring.push(3));
  EXPECT_EQ(ring.front(), 2);
  EXPECT_EQ(ring[1], 3);
}

TEST(Ring, TheConsumerReadsAheadWithoutTaking) {
  Ring<int> ring(8);
  for (int i = 0; i < 8; ++i) ASSERT_TRUE(ring.push(10 * i));
  for (std::size_t i = 0; i < ring.size(); ++i) EXPECT_EQ(ring[i], 10 * static_cast<int>(i));
  ring.pop_front(5);
  EXPECT_EQ(ring.front(), 50);
  EXPECT_EQ(ring.size(), 3U);
}

TEST(Ring, CountsAllThatEverWentThrough) {
  Ring<int> ring(2);
  int value = 0;
  for (int i = 0; i < 100; ++i) {
    ASSERT_TRUE(ring.push(i));
    ASSERT_TRUE(ring.pop(value));
  }
  EXPECT_TRUE(ring.push(0));
  EXPECT_EQ(ring.pushed(), 101U);
  EXPECT_EQ(ring.popped(), 100U);
}

TEST(Ring, BehavesLikeABoundedDequeUnderRandomUse) {
  constexpr unsigned seed = 20240117;
  std::mt19937 random(seed);
  Ring<std::uint64_t> ring(7);
  std::deque<std::uint64_t> model;
  for (int step = 0; step < 20000; ++step) {
    const std::uint64_t action = random() % 3;
    if (action == 0) {
      const std::uint64_t value = random();
      const bool fits = model.size() < 7;
      ASSERT_EQ(ring.push(value), fits) << "seed " << seed << " step " << step;
      if (fits) model.push_back(value);
    } else if (action == 1) {
      std::uint64_t value = 0;
      ASSERT_EQ(ring.pop(value), !model.empty()) << "seed " << seed << " step " << step;
      if (!model.empty()) {
        ASSERT_EQ(value, model.front());
        model.pop_front();
      }
    } else {
      ASSERT_EQ(ring.size(), model.size()) << "seed " << seed << " step " << step;
      for (std::size_t i = 0; i < model.size(); ++i) ASSERT_EQ(ring[i], model[i]);
    }
  }
}

// Two words that must never be seen apart.
struct Pair {
  std::uint64_t number = 0;
  std::uint64_t complement = ~std::uint64_t{0};
};

TEST(Ring, CarriesWholeValuesInOrderBetweenTwoThreads) {
  constexpr std::uint64_t count = 200000;
  Ring<Pair> ring(64);
  std::thread producer([&] {
    for (std::uint64_t i = 0; i < count; ++i) {
      while (!ring.push({i, ~i})) std::this_thread::yield();
    }
  });
  std::uint64_t expected = 0;
  std::uint64_t wrong = 0;
  while (expected < count) {
    const std::size_t ready = ring.size();
    if (ready == 0) std::this_thread::yield();
    for (std::size_t i = 0; i < ready; ++i, ++expected) {
      wrong += ring[i].number != expected || ring[i].complement != ~expected ? 1U : 0U;
    }
    ring.pop_front(ready);
  }
  producer.join();
  EXPECT_EQ(wrong, 0U);
  EXPECT_TRUE(ring.empty());
}

TEST(Ring, TakesNoMemoryAfterItsConstruction) {
  Ring<int> ring(16);
  const testing::NoAllocation guard;
  int value = 0;
  bool ok = true;
  for (int i = 0; i < 1000; ++i) ok = ok && ring.push(i) && ring.pop(value);
  EXPECT_TRUE(ok);
}

TEST(Ring, NeedsACapacity) {
  EXPECT_THROW(Ring<int>(0), BrokenClaim);
}

// The consumer acts on what it was shown; more comes meanwhile without its notice.
TEST(Ring, ShowsTheConsumerAsMuchAsItIsTold) {
  Ring<int> ring(8);
  for (const int value : {1, 2, 3}) ASSERT_TRUE(ring.push(value));
  EXPECT_EQ(ring.size(), 3U) << "without being told, all";
  ring.show(2);
  EXPECT_EQ(ring.size(), 2U);
  ASSERT_TRUE(ring.push(4));
  EXPECT_EQ(ring.size(), 2U);
  int value = 0;
  ASSERT_TRUE(ring.pop(value) && ring.pop(value));
  EXPECT_FALSE(ring.pop(value));
  EXPECT_EQ(ring.shown(), 2U);
  EXPECT_EQ(ring.space(), 6U) << "the producer counts what there is";
  ring.show(100);
  EXPECT_EQ(ring.size(), 2U) << "not more than there is";
  EXPECT_EQ(ring.front(), 3);
}

}  // namespace
}  // namespace stanok
