// Touching off in the cycle: the value is made where the axis stands, and only where that is known.
#include <gtest/gtest.h>

#include "tests/support/machine/machine_bench.h"

namespace stanok::channels {
namespace {

using testing::MachineBench;

// The code of the refusal; empty: accepted.
std::string touch(MachineBench& bench, double point_W) {
  OperatorEvent event;
  event.channel = 1;
  event.command = commands::OffsetTouch{.place = ShortText("G55 X"), .point_W = point_W};
  bench.ask(event);
  bench.cycle();
  return std::string(bench.replies().back().code.view());
}

// G54 is active with 3: p = 12 - 3; in G55 the axis is to stand at 2.5, so its offset is 9.5.
TEST(TouchOff, GivesTheOffsetWithWhichTheAxisStandsThere) {
  MachineConfig config = testing::two_channel_machine();
  config.axes[0].start = 12.0;
  config.tables.offsets["G54"]["X"] = 3.0;
  MachineBench bench(config);
  bench.run_to_end();
  EXPECT_EQ(touch(bench, 2.5), "");
  EXPECT_DOUBLE_EQ(bench.machine().tables().offsets["G55"]["X"], 9.5);
}

TEST(TouchOff, NeedsAnAxisThatIsHomed) {
  MachineConfig config = testing::two_channel_machine();
  config.axes[0].homing.order = 1;
  MachineBench bench(config, {.on_at_start = false});
  bench.cycle();
  bench.cycle();
  EXPECT_EQ(touch(bench, 2.5), "E5208");
  EXPECT_EQ(bench.machine().tables().offsets["G55"]["X"], 0.0);
}

}  // namespace
}  // namespace stanok::channels
