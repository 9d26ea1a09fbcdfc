// The real-time loop on a clock of its own: absolute wake-ups, overruns counted and never chased.
#include "daemon/cycle/real_time_loop.h"

#include <gtest/gtest.h>

#include <functional>
#include <vector>

namespace stanok::daemon {
namespace {

constexpr std::int64_t period = 1'000'000;
constexpr std::int64_t start = 5'000'000'000;

// Time passes only by sleeping, late as the test says, and by working.
class InjectedClock final : public CycleClock {
 public:
  std::function<std::int64_t(std::size_t wake_up)> lateness = [](std::size_t) { return 0; };

  [[nodiscard]] std::int64_t now_ns() override { return now; }
  void sleep_until(std::int64_t time_ns) override {
    asked.push_back(time_ns);
    now = std::max(now, time_ns) + lateness(asked.size() - 1);
  }

  std::int64_t now = start;
  std::vector<std::int64_t> asked;
};

class InjectedWork final : public CyclicWork {
 public:
  InjectedWork(InjectedClock& clock, std::vector<std::int64_t> durations)
      : told(durations.size()), clock_(clock), durations_(std::move(durations)) {}

  void cycle(std::int64_t lost) RT_SAFE override {
    told[done] = lost;
    clock_.now += durations_[done++];
    if (done == durations_.size()) loop->stop();
  }

  RealTimeLoop* loop = nullptr;
  std::size_t done = 0;
  std::vector<std::int64_t> told;  // of each cycle

 private:
  InjectedClock& clock_;
  std::vector<std::int64_t> durations_;
};

struct LoopRun {
  std::vector<std::int64_t> asked;  // wake-up times in periods after the start
  LoopStatistics statistics;
  std::vector<std::int64_t> told;  // of each cycle: the periods lost before it
};

LoopRun run(
    std::vector<std::int64_t> durations,
    std::function<std::int64_t(std::size_t)> lateness = [](std::size_t) { return 0; }) {
  InjectedClock clock;
  clock.lateness = std::move(lateness);
  InjectedWork work(clock, std::move(durations));
  RealTimeLoop loop(work, clock, period);
  work.loop = &loop;
  loop.run();
  LoopRun result{.asked = {}, .statistics = loop.statistics(), .told = work.told};
  for (const std::int64_t time : clock.asked) result.asked.push_back((time - start) / period);
  return result;
}

TEST(RealTimeLoop, WakesAtMultiplesOfThePeriodFromItsStart) {
  const LoopRun result = run({100, 200, 300, 400});
  EXPECT_EQ(result.asked, (std::vector<std::int64_t>{1, 2, 3, 4}));
  EXPECT_EQ(result.statistics.cycles, 4);
  EXPECT_EQ(result.statistics.overruns, 0);
}

TEST(RealTimeLoop, DoesNotAddUpLateness) {
  const LoopRun result =
      run(std::vector<std::int64_t>(100, 1000), [](std::size_t k) { return 7919 * (k % 5); });
  for (std::size_t k = 0; k < result.asked.size(); ++k) {
    EXPECT_EQ(result.asked[k], static_cast<std::int64_t>(k + 1));
  }
  EXPECT_EQ(result.statistics.latency.max(), 4 * 7919);
  EXPECT_EQ(result.statistics.overruns, 0);
}

TEST(RealTimeLoop, CountsAnOverrunAndLeavesOutThePeriodsThatHavePassed) {
  // The second cycle begins at 2 and ends at 5.5: the third begins then, for 5; 3 and 4 are lost.
  const LoopRun result = run({0, 3 * period + period / 2, 0, 0});
  EXPECT_EQ(result.asked, (std::vector<std::int64_t>{1, 2, 3, 6}));
  EXPECT_EQ(result.told, (std::vector<std::int64_t>{0, 0, 2, 0}));
  EXPECT_EQ(result.statistics.overruns, 1);
  EXPECT_EQ(result.statistics.periods_skipped, 2);
}

// The clock wakes it 3.2 periods late: what it computes then is for now, not for what was due.
TEST(RealTimeLoop, TellsTheCycleHowManyPeriodsTheClockCameLate) {
  const LoopRun result = run(std::vector<std::int64_t>(4, 1000),
                             [](std::size_t k) { return k == 1 ? 3 * period + period / 5 : 0; });
  EXPECT_EQ(result.asked, (std::vector<std::int64_t>{1, 2, 6, 7}));
  EXPECT_EQ(result.told, (std::vector<std::int64_t>{0, 3, 0, 0}));
  EXPECT_EQ(result.statistics.latency.max(), 3 * period + period / 5);
}

TEST(RealTimeLoop, IsNotOverrunByACycleThatTakesExactlyThePeriod) {
  const LoopRun result = run({period, period, period});
  EXPECT_EQ(result.asked, (std::vector<std::int64_t>{1, 2, 3}));
  EXPECT_EQ(result.statistics.overruns, 0);
}

// SIGSTOP and SIGCONT, or half a second stolen: one late cycle, no burst behind it.
TEST(RealTimeLoop, ChasesNothingAfterALongStop) {
  const LoopRun result = run(std::vector<std::int64_t>(4, 1000),
                             [](std::size_t k) { return k == 1 ? 500 * period : 0; });
  EXPECT_EQ(result.asked, (std::vector<std::int64_t>{1, 2, 503, 504}));
  EXPECT_EQ(result.told, (std::vector<std::int64_t>{0, 500, 0, 0}));
  EXPECT_EQ(result.statistics.overruns, 1);
  EXPECT_EQ(result.statistics.periods_skipped, 500);
}

TEST(RealTimeLoop, MeasuresEveryCycle) {
  const LoopRun result = run(std::vector<std::int64_t>(1000, 12'345));
  EXPECT_EQ(result.statistics.cycle_time.count(), 1000U);
  EXPECT_EQ(result.statistics.cycle_time.max(), 12'345);
}

TEST(MonotonicClock, SleepsUntilTheTimeAndNotAtAllForOneThatHasPassed) {
  MonotonicClock clock;
  const std::int64_t due = clock.now_ns() + 2'000'000;
  clock.sleep_until(due);
  EXPECT_GE(clock.now_ns(), due);
  clock.sleep_until(due - 1'000'000'000);
}

}  // namespace
}  // namespace stanok::daemon
