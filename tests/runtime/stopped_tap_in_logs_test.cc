// Taps that are stopped at random and taken out of their holes: the log repeats them bit for bit.
#include <gtest/gtest.h>

#include <string>

#include "runtime/replay.h"
#include "tests/runtime/recorded_by_chance.h"
#include "tests/support/sanitized.h"

namespace stanok::runtime {
namespace {

using channels::OperatorAction;

TEST(StoppedTapsInLogs, RepeatBitForBit) {
  int taken_out = 0;
  for (std::uint64_t seed = 1; seed <= testing::cases(10U); ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    const auto pick = [&](int low, int high) {
      return std::uniform_int_distribution<int>(low, high)(random);
    };
    RecordedByChance run("e7106mf4.toml", DriveChoice::ideal, seed);
    bool was_in = false;
    run.watch(
        [&](const channels::CycleOutput& output) {
          const bool is_in = output.channels[0].tap_in_hole;
          if (was_in && !is_in) ++taken_out;
          was_in = is_in;
        },
        [](const channels::Event&) {});
    run.program("tap.nc", "G90 G94 G17\nS300 M3\nG0 Z5\nG33.1 Z-15 K1.5\nM30\n");
    run.run(300);
    for (int n = 0; n < 4; ++n) {
      run.ask(OperatorAction::program_run, 1, "tap.nc");
      run.run(pick(300, 6000));
      run.ask(pick(0, 1) == 0 ? OperatorAction::program_stop : OperatorAction::program_reset, 1);
      run.run(2000);
      run.ask(OperatorAction::program_reset, 1);
      run.run(100);
      run.ask(OperatorAction::mdi, 1, "G30 P99");
      run.run(pick(100, 6000));
      run.ask(OperatorAction::program_reset, 1);
      run.run(2000);
    }
    run.close();
    EXPECT_TRUE(replay(run.path(), {}).is_same());
  }
  EXPECT_GE(taken_out, 1);
}

}  // namespace
}  // namespace stanok::runtime
