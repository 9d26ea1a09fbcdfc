#include "base/latest.h"

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <cstdint>
#include <thread>

#include "tests/support/no_allocation.h"

namespace stanok {
namespace {

TEST(Latest, HoldsADefaultValueBeforeTheFirstWrite) {
  Latest<int> box;
  EXPECT_EQ(box.read(), 0);
}

TEST(Latest, KeepsTheNewestAndForgetsTheRest) {
  Latest<int> box;
  for (int i = 1; i <= 5; ++i) box.write(i);
  EXPECT_EQ(box.read(), 5);
  EXPECT_EQ(box.read(), 5) << "reading again gives the same value";
  box.write(6);
  EXPECT_EQ(box.read(), 6);
}

TEST(Latest, AReadValueStaysWhileTheWriterGoesOn) {
  Latest<int> box;
  box.write(1);
  const int& value = box.read();
  for (int i = 2; i < 100; ++i) box.write(i);
  EXPECT_EQ(value, 1);
  EXPECT_EQ(box.read(), 99);
}

// A value of many words: a torn one has words that differ.
using Wide = std::array<std::uint64_t, 32>;

TEST(Latest, NeverShowsATornOrOlderValueToAnotherThread) {
  constexpr std::uint64_t count = 200000;
  Latest<Wide> box;
  std::atomic<bool> done{false};
  std::thread writer([&] {
    Wide value{};
    for (std::uint64_t i = 1; i <= count; ++i) {
      value.fill(i);
      box.write(value);
    }
    done.store(true);
  });
  std::uint64_t last = 0;
  std::uint64_t torn = 0;
  std::uint64_t older = 0;
  while (!done.load()) {
    const Wide& value = box.read();
    for (const std::uint64_t word : value) torn += word != value[0] ? 1U : 0U;
    older += value[0] < last ? 1U : 0U;
    last = value[0];
  }
  writer.join();
  EXPECT_EQ(torn, 0U);
  EXPECT_EQ(older, 0U);
  EXPECT_EQ(box.read()[0], count);
}

TEST(Latest, TakesNoMemory) {
  Latest<Wide> box;
  const testing::NoAllocation guard;
  for (int i = 0; i < 100; ++i) box.write(Wide{});
  EXPECT_EQ(box.read()[0], 0U);
}

}  // namespace
}  // namespace stanok
