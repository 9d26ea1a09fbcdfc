// Events of which a broker is trusted to have them, and since when.
#include "gateway/broker/settled_position.h"

#include <gtest/gtest.h>

#include <random>

namespace stanok::testing {
namespace {

using namespace std::chrono_literals;
using gateway::SettledPosition;

const SettledPosition::Clock::time_point then{};

TEST(SettledPosition, IsBehindWhatWasAcknowledgedLongAgo) {
  SettledPosition position(10s);
  EXPECT_EQ(position.take(then), std::nullopt);
  position.acknowledge(4, then);
  position.acknowledge(7, then + 5s);
  EXPECT_EQ(position.take(then + 9s), std::nullopt);
  EXPECT_EQ(position.take(then + 10s), 4);
  EXPECT_EQ(position.take(then + 10s), std::nullopt);
  EXPECT_EQ(position.take(then + 20s), 7);
}

TEST(SettledPosition, TrustsABrokerAtOnceThatIsNotToBeWaitedFor) {
  SettledPosition position(0s);
  position.acknowledge(4, then);
  EXPECT_EQ(position.take(then), 4);
}

TEST(SettledPosition, ForgetsWhatAConnectionThatEndedHadAcknowledged) {
  SettledPosition position(10s);
  position.acknowledge(4, then);
  position.clear();
  EXPECT_EQ(position.take(then + 60s), std::nullopt);
}

// Never one that is younger, and none that is half a second older is held back.
TEST(SettledPosition, IsNeverTooEarlyAndHardlyLate) {
  std::mt19937 random(7);
  std::uniform_int_distribution<int> pause_ms(0, 700);
  SettledPosition position(10s);
  std::vector<SettledPosition::Clock::time_point> acknowledged{then};
  std::int64_t settled = 0;
  auto now = then;
  for (int k = 0; k < 3000; ++k) {
    now += std::chrono::milliseconds(pause_ms(random) / (k % 500 < 250 ? 50 : 1));
    acknowledged.push_back(now);
    position.acknowledge(static_cast<std::int64_t>(acknowledged.size()) - 1, now);
    settled = position.take(now).value_or(settled);
    if (settled > 0) {
      EXPECT_GE(now - acknowledged[static_cast<std::size_t>(settled)], 10s);
    }
    const auto next = static_cast<std::size_t>(settled + 1);
    if (next < acknowledged.size()) {
      EXPECT_LE(now - acknowledged[next], 10s + 500ms);
    }
  }
  EXPECT_GT(settled, 2500);
}

}  // namespace
}  // namespace stanok::testing
