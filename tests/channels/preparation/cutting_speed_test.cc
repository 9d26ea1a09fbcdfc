// G95, G96 and G97 through the whole chain: feed per revolution and cutting speed of each cycle
// against v = pi D n / 1000 and S = f n, on the diameters that the setpoints say.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/cycle.h"
#include "tests/support/machine/turning_bench.h"

namespace stanok::channels {
namespace {

using testing::cycle_s;
using ::testing::IsEmpty;
using testing::MachineBench;

constexpr std::size_t x_axis = 0;

struct Turned {
  double revolutions = 0.0;
  double way = 0.0;
  double worst_speed_error = 0.0;  // of the cutting speed, relative
  double slowest = 1e9;            // rev/min
  double fastest = 0.0;
};

// Watches the cycles in which the tool cuts between two radii at feed.
Turned turn(MachineBench& bench, double cutting_speed, double radius_min, double radius_max) {
  Turned turned;
  double x_before = 0.0;
  double z_before = 0.0;
  bench.run_to_end([&](const CycleOutput& output) {
    const ChannelOutput& channel = output.channels[0];
    const double x = channel.point_W[x_axis].value;
    const double z = channel.point_W[1].value;
    const double n = std::abs(channel.process.spindle_rev_per_min);
    if (channel.process.feed_mm_per_min > 0.0 && x > radius_min && x < radius_max) {
      turned.revolutions += n / 60.0 * cycle_s;
      turned.way += std::hypot(x - x_before, z - z_before);
      const double v = std::numbers::pi * 2.0 * x * n / 1000.0;
      if (cutting_speed > 0.0)
        turned.worst_speed_error =
            std::max(turned.worst_speed_error, std::abs(v / cutting_speed - 1.0));
      EXPECT_NEAR(channel.process.cutting_speed_m_per_min, v, 1e-6 * v);
      turned.slowest = std::min(turned.slowest, n);
      turned.fastest = std::max(turned.fastest, n);
    }
    x_before = x;
    z_before = z;
  });
  EXPECT_THAT(bench.alarm_codes(), IsEmpty());
  return turned;
}

TEST(CuttingSpeed, IsHeldInFacingAndTheFeedPerRevolutionWithIt) {
  MachineBench bench(testing::lathe_with_spindle(50.0, 4000.0));
  bench.program("face.nc", "G0 X80 Z0\nG96 S150 M3\nG95 G1 X20 F0.2\nG97 M5\nM30\n");
  bench.run(1, "face.nc");
  const Turned turned = turn(bench, 150.0, 10.5, 39.9);
  EXPECT_LT(turned.worst_speed_error, 0.005);
  EXPECT_NEAR(turned.revolutions, turned.way / 0.2, 0.002 * turned.revolutions);
  EXPECT_NEAR(turned.way, 29.4, 0.05);
  EXPECT_NEAR(turned.slowest, 1000.0 * 150.0 / (std::numbers::pi * 79.8), 5.0);
  EXPECT_NEAR(turned.fastest, 1000.0 * 150.0 / (std::numbers::pi * 21.0), 12.0);
}

TEST(CuttingSpeed, EndsAtTheLimitOfItsBlock) {
  MachineBench bench(testing::lathe_with_spindle(50.0, 4000.0));
  bench.program("face.nc", "G0 X80 Z0\nG96 S150 D1500 M3\nG95 G1 X20 F0.2\nM5\nM30\n");
  bench.run(1, "face.nc");
  const Turned turned = turn(bench, 0.0, 10.5, 39.9);
  EXPECT_EQ(turned.fastest, 1500.0);
  EXPECT_NEAR(turned.revolutions, turned.way / 0.2, 0.002 * turned.revolutions);
}

// A spindle that cannot follow: the cutting speed lags, the feed per revolution does not.
TEST(CuttingSpeed, LagsWithTheSpindleWhileTheFeedPerRevolutionHolds) {
  MachineBench bench(testing::lathe_with_spindle(50.0, 150.0));
  bench.program("face.nc", "G0 X80 Z0\nG96 S150 M3\nG95 G1 X20 F0.2\nM5\nM30\n");
  bench.run(1, "face.nc");
  const Turned turned = turn(bench, 150.0, 10.5, 39.9);
  EXPECT_GT(turned.worst_speed_error, 0.02);
  EXPECT_NEAR(turned.revolutions, turned.way / 0.2, 0.002 * turned.revolutions);
}

TEST(CuttingSpeed, IsHeldAlongAContour) {
  MachineBench bench(testing::lathe_with_spindle(50.0, 4000.0));
  bench.program("contour.nc",
                "G0 X60 Z0\nG96 S120 M3\nG95 G1 X60 Z-10 F0.15\nX40 Z-30\nG2 X50 Z-40 R30\n"
                "G1 X70 Z-45\nM5\nM30\n");
  bench.run(1, "contour.nc");
  const Turned turned = turn(bench, 120.0, 20.2, 34.9);
  EXPECT_LT(turned.worst_speed_error, 0.005);
  EXPECT_NEAR(turned.revolutions, turned.way / 0.15, 0.002 * turned.revolutions);
  EXPECT_GT(turned.way, 40.0);
}

TEST(FeedPerRevolution, FollowsTheSpindleThroughItsOverride) {
  MachineBench bench(testing::lathe_with_spindle(50.0, 300.0));
  bench.program("turn.nc", "G0 X60 Z0\nG97 S600 M3\nG95 G1 Z-40 F0.2\nM5\nM30\n");
  bench.run(1, "turn.nc");
  double angle = 0.0;
  double z_first = 0.0;
  double z_last = 0.0;
  int cycles = 0;
  bench.run_to_end([&](const CycleOutput& output) {
    const ChannelOutput& channel = output.channels[0];
    const double z = channel.point_W[1].value;
    if (channel.process.feed_mm_per_min <= 0.0) return;
    ++cycles;
    if (cycles == 3000) bench.ask(OperatorAction::override_spindle, 1, "", 0.6);
    if (cycles == 8000) bench.ask(OperatorAction::override_spindle, 1, "", 1.3);
    if (cycles == 100) z_first = z;
    if (z < -39.5) return;
    if (cycles > 100) angle += std::abs(channel.process.spindle_rev_per_min) / 60.0 * cycle_s;
    z_last = z;
  });
  ASSERT_THAT(bench.alarm_codes(), IsEmpty());
  EXPECT_NEAR((z_first - z_last) / angle, 0.2, 0.2 * 0.002);
  EXPECT_GT(cycles, 8000);
}

TEST(FeedPerMinute, IsTheSameToTheBitWhateverTheSpindleDoes) {
  std::vector<double> ways[2];
  for (const bool with_speed : {false, true}) {
    MachineBench bench(testing::lathe_with_spindle(50.0, 300.0));
    const std::string speed = with_speed ? "G96 S150 M3\n" : "G97 S200 M3\n";
    bench.program("turn.nc", "G0 X60 Z0\n" + speed + "G94 G1 Z-4 F120\nX70 Z-8\nM30\n");
    bench.run(1, "turn.nc");
    bench.run_to_end([&](const CycleOutput& output) {
      if (output.channels[0].process.feed_mm_per_min > 0.0)
        ways[with_speed ? 1 : 0].push_back(output.channels[0].point_W[1].value);
    });
  }
  EXPECT_EQ(ways[0], ways[1]);
}

}  // namespace
}  // namespace stanok::channels
