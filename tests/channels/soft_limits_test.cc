// A path that would pass a soft limit: told with its line and axis before anything moves there, and
// the axes stand on the path before it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/machine/machine_bench.h"

namespace stanok::channels {
namespace {

using testing::MachineBench;

constexpr double limit = 50.0;

MachineConfig mill_with_soft_limit() {
  MachineConfig config = testing::two_channel_machine();
  config.axes[0].limits.position_max = limit;
  return config;
}

struct Reached {
  double x = -1e9;
  Diagnostic alarm;
};

Reached run(const std::string& program) {
  MachineBench bench(mill_with_soft_limit());
  bench.program("p.nc", program);
  bench.run(1, "p.nc");
  Reached reached;
  bench.run_to_end([&](const CycleOutput& output) {
    reached.x = std::max(reached.x, output.channels[0].axes[0].position);
  });
  const auto alarms = bench.machine().alarms();
  if (alarms.size() == 1) reached.alarm = alarms[0].diagnostic;
  return reached;
}

// The arc around (45, 10) with radius 10 has its crest at X 55, between two ends at X 45; its joins
// are blended within 2 mm.
TEST(SoftLimits, InTheMiddleOfABlendedArcStopTheProgramBeforeIt) {
  const Reached reached = run("G64 P2\nG1 X30 Y0 F6000\nX45\nG3 X45 Y20 I0 J10\nG1 X0 Y20\nM30\n");
  EXPECT_EQ(reached.alarm.code, "E5101");
  EXPECT_EQ(reached.alarm.place.line, 4);
  EXPECT_THAT(reached.alarm.message, ::testing::HasSubstr("X"));
  EXPECT_LE(reached.x, limit);
}

// Crest at X 50 - 1e-6: the same program runs to its end, and reaches that crest.
TEST(SoftLimits, AreTouchedFreely) {
  const Reached reached =
      run("G64 P2\nG1 X30 Y0 F6000\nX39.999999\nG3 X39.999999 Y20 I0 J10\nG1 X0 Y20\nM30\n");
  EXPECT_EQ(reached.alarm.code, "");
  EXPECT_LE(reached.x, limit);
  EXPECT_GT(reached.x, limit - 2.0);
}

}  // namespace
}  // namespace stanok::channels
