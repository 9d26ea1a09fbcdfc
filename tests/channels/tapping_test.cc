// Taps and threads as programs write them, G84, G74, G33.1, G78 and tapered threads of several
// starts, on the machine: the helix by the turns of the spindle, and what must not disturb it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "tests/support/cycle.h"
#include "tests/support/helix.h"
#include "tests/support/machine/turning_bench.h"

namespace stanok::channels {
namespace {

using testing::cycle_s;
using ::testing::ElementsAre;
using testing::increment_mm;
using ::testing::IsEmpty;
using testing::MachineBench;

// A mill whose spindle 1 has an encoder and an acceleration.
MachineConfig mill_with_encoder() {
  MachineConfig config = testing::two_channel_machine();
  config.spindles[0].encoder_pulses = 1024;
  config.spindles[0].acceleration = 2000.0;
  config.spindles[0].speed_max = 3000.0;
  return config;
}

// What the spindle has turned: its speed changes evenly within a cycle.
class Turns {
 public:
  double after(const ChannelOutput& channel) {
    const double speed = channel.process.spindle_rev_per_min;
    turns_ += 0.5 * (speed_ + speed) / 60.0 * cycle_s;
    speed_ = speed;
    return turns_;
  }

 private:
  double turns_ = 0.0;
  double speed_ = 0.0;
};

struct TapCase {
  const char* name;
  const char* program;  // the tap in line 4, at X0, from Z5 down to Z-20
  double z_start;       // of the tap
  double lead;
  double speed_in, speed_back;  // rev/min, signed
};

class RigidTap : public ::testing::TestWithParam<TapCase> {};

TEST_P(RigidTap, KeepsItsHelixInAndOutAndThroughItsReversal) {
  const TapCase& c = GetParam();
  MachineBench bench(mill_with_encoder());
  bench.program("p.nc", c.program);
  bench.run(1, "p.nc");
  Turns spindle;
  double bottom = 5.0;
  double error = 0.0;
  double fastest_in = 0.0;
  double fastest_back = 0.0;
  int samples = 0;
  bench.run_to_end([&](const CycleOutput& output) {
    const ChannelOutput& channel = output.channels[0];
    const double turns = spindle.after(channel);
    const double z = channel.point_W[2].value;
    const double speed = channel.process.spindle_rev_per_min;
    const double forward = speed * std::copysign(1.0, c.speed_in);
    bottom = std::min(bottom, z);
    if (channel.tag.line != 4 || z > c.z_start - 1.5 || z > 1.0) return;
    fastest_in = std::max(fastest_in, forward);
    fastest_back = std::min(fastest_back, forward);
    error = std::max(
        error, testing::off_helix(std::copysign(1.0, c.speed_in) * turns, z - c.z_start, -c.lead));
    ++samples;
  });
  EXPECT_THAT(bench.alarm_codes(), IsEmpty());
  EXPECT_NEAR(bottom, -20.0, increment_mm);
  EXPECT_GT(samples, 1000);
  EXPECT_LE(error, 2.0 * increment_mm);
  EXPECT_EQ(fastest_in, std::abs(c.speed_in));
  EXPECT_EQ(fastest_back, -std::abs(c.speed_back));
}

INSTANTIATE_TEST_SUITE_P(
    Programs, RigidTap,
    ::testing::Values(
        TapCase{"g84", "G94 G17\nS600 M3\nG0 X0 Z5\nG84 Z-20 R2 K1.5\nG80\nM30\n", 2.0, 1.5, 600,
                -600},
        TapCase{"g84_with_lead_from_feed",
                "G94 G17\nS500 M3\nG0 X0 Z5\nG84 Z-20 R2 F625\nG80\nM30\n", 2.0, 1.25, 500, -500},
        TapCase{"g84_per_revolution", "G95 G17\nS500 M3\nG0 X0 Z5\nG84 Z-20 R2 F1.25\nG80\nM30\n",
                2.0, 1.25, 500, -500},
        TapCase{"g84_with_dwell", "G94 G17\nS600 M3\nG0 X0 Z5\nG84 Z-20 R2 K1 P0.3\nG80\nM30\n",
                2.0, 1.0, 600, -600},
        TapCase{"g74", "G94 G17\nS600 M4\nG0 X0 Z5\nG74 Z-20 R2 K1.5\nG80\nM30\n", 2.0, 1.5, -600,
                600},
        TapCase{"g74_turns_the_spindle", "G94 G17\nS450\nG0 X0 Z5\nG74 Z-20 R2 K2\nG80\nM30\n", 2.0,
                2.0, -450, 450},
        TapCase{"g33_1", "G94 G17\nS600 M3\nG0 X0 Z5\nG33.1 Z-20 K1.5\nM30\n", 5.0, 1.5, 600, -600},
        TapCase{"g33_1_left_hand", "G94 G17\nS600 M4\nG0 X0 Z5\nG33.1 Z-20 K1.5\nM30\n", 5.0, 1.5,
                -600, 600},
        TapCase{"g33_1_faster_back", "G94 G17\nS400 M3\nG0 X0 Z5\nG33.1 Z-20 K1.5 I2\nM30\n", 5.0,
                1.5, 400, -800}),
    [](const auto& with) { return std::string(with.param.name); });

// Two starts of a tapered thread; F is the lead along Z, which travels farther.
TEST(ProgrammedThread, CutsATaperOfTwoStarts) {
  MachineBench bench(testing::turning_machine());
  bench.program("p.nc",
                "G8 G18 G95\nS300 M3\nnum start = 0;\n"
                "for (start = 0; start < 2; start = start + 1)\n{\n"
                "G0 X20 Z3\nG0 X10\nG33 X13 Z-27 F4 Q=start*180\nG0 X20\n}\nM30\n");
  bench.run(1, "p.nc");
  Turns spindle;
  double error = 0.0;
  int samples = 0;
  int pass = 0;
  bool cuts = false;
  bench.run_to_end([&](const CycleOutput& output) {
    const ChannelOutput& channel = output.channels[0];
    const double turns = spindle.after(channel);
    const double z = channel.point_W[1].value;
    const bool in_thread = channel.tag.line == 8 && z < 0.0 && z > -24.0;
    if (cuts && !in_thread) ++pass;
    cuts = in_thread;
    if (!in_thread) return;
    error = std::max(error, testing::off_helix(turns - 0.5 * pass, z - 3.0, -4.0));
    EXPECT_NEAR(channel.point_W[0].value, 10.0 + 3.0 * (3.0 - z) / 30.0, 1e-9);
    ++samples;
  });
  EXPECT_THAT(bench.alarm_codes(), IsEmpty());
  EXPECT_EQ(pass, 2);
  EXPECT_GT(samples, 2 * 1100);  // 24 mm at 20 mm/s
  EXPECT_LE(error, increment_mm);
}

// G78 repeats its pass at each depth, always on the same helix.
TEST(ProgrammedThread, PassesOfG78FollowOneHelix) {
  MachineBench bench(testing::turning_machine());
  bench.program("p.nc", "G7 G18 G95\nS300 M3\nG0 X32 Z4\nG78 X29 Z-20 F3\nX28\nX27.5\nM30\n");
  bench.run(1, "p.nc");
  Turns spindle;
  double error = 0.0;
  testing::PassDepths depths(-10.0);
  bench.run_to_end([&](const CycleOutput& output) {
    const ChannelOutput& channel = output.channels[0];
    const double turns = spindle.after(channel);
    const double x = channel.point_W[0].value;
    const double z = channel.point_W[1].value;
    depths.see(z, x);
    const bool in_thread = x > 13.0 && x < 14.6 && z < 1.0 && z > -18.0;
    if (in_thread) error = std::max(error, testing::off_helix(turns, z - 4.0, -3.0));
  });
  EXPECT_THAT(bench.alarm_codes(), IsEmpty());
  EXPECT_THAT(depths.all(), ElementsAre(14.5, 14.0, 13.75));
  EXPECT_LE(error, increment_mm);
}

// The two blocks of G76: fed in along a flank of 30 degrees, so that each pass begins so much
// farther back, always at the same angle of the spindle.
TEST(ProgrammedThread, PassesOfG76InTwoBlocksLieOnTheirFlank) {
  MachineBench bench(testing::turning_machine());
  bench.program("p.nc",
                "G8 G18 G95\nS300 M3\nG0 X20 Z5\nG76 P010060 Q0.05 R0.1\n"
                "G76 X18 Z-20 P1 Q0.5 F2\nM30\n");
  bench.run(1, "p.nc");
  Turns spindle;
  double error = 0.0;
  testing::PassDepths depths(-10.0);
  bench.run_to_end([&](const CycleOutput& output) {
    const ChannelOutput& channel = output.channels[0];
    const double turns = spindle.after(channel);
    const double x = channel.point_W[0].value;
    const double z = channel.point_W[1].value;
    const double depth = 19.0 - x;  // below the crest
    depths.see(z, depth);
    if (channel.tag.line != 5 || depth < 0.4 || z > 2.0 || z < -18.0) return;
    const double z_start = 5.0 + (1.0 - depth) * std::tan(std::numbers::pi / 6.0);
    error = std::max(error, testing::off_helix(turns, z - z_start, -2.0));
  });
  EXPECT_THAT(bench.alarm_codes(), IsEmpty());
  ASSERT_EQ(depths.all().size(), 5U);  // up to 0.9, and the last cut
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_NEAR(depths.all()[k], 0.5 * std::sqrt(static_cast<double>(k) + 1.0), 1e-9);
  EXPECT_NEAR(depths.all()[3], 0.9, 1e-9);
  EXPECT_NEAR(depths.all()[4], 1.0, 1e-9);
  EXPECT_LE(error, increment_mm);
}

// The spindle slows down as the diameter grows, and the thread with it.
TEST(ProgrammedThread, FollowsASpindleThatHoldsItsCuttingSpeed) {
  MachineBench bench(testing::turning_machine());
  bench.program("p.nc", "G8 G18 G95\nG0 X10 Z3\nG96 S60 M3\nG33 X16 Z-57 F2\nG0 X30\nM30\n");
  bench.run(1, "p.nc");
  Turns spindle;
  double error = 0.0;
  double fastest = 0.0;
  double slowest = 1e9;
  bench.run_to_end([&](const CycleOutput& output) {
    const ChannelOutput& channel = output.channels[0];
    const double turns = spindle.after(channel);
    const double z = channel.point_W[1].value;
    if (channel.tag.line != 4 || z > 1.0 || z < -55.0) return;
    error = std::max(error, testing::off_helix(turns, z - 3.0, -2.0));
    fastest = std::max(fastest, channel.process.spindle_rev_per_min);
    slowest = std::min(slowest, channel.process.spindle_rev_per_min);
  });
  EXPECT_THAT(bench.alarm_codes(), IsEmpty());
  EXPECT_LE(error, increment_mm);
  // 60 m/min at the diameters 20.4 and 31.6.
  EXPECT_NEAR(fastest, 60000.0 / (std::numbers::pi * 20.4), 2.0);
  EXPECT_NEAR(slowest, 60000.0 / (std::numbers::pi * 31.6), 2.0);
}

// A thread has the feed of its lead, and the path of a law does not count it.
TEST(FeedLawBesideAThread, DoesNotCountAThread) {
  MachineBench bench(testing::turning_machine());
  bench.program("p.nc",
                "G8 G18 G94\nS300 M3\nG0 X20 Z5\nS_n=60 dS=1 dl=1\nG33 Z-20 K2\nG1 X17.5\nM30\n");
  bench.run(1, "p.nc");
  double least = 1e9;
  double most = 0.0;
  bench.run_to_end([&](const CycleOutput& output) {
    const ChannelOutput& channel = output.channels[0];
    if (channel.tag.line != 6 || !channel.moving) return;
    least = std::min(least, channel.process.feed_mm_per_min);
    most = std::max(most, channel.process.feed_mm_per_min);
  });
  EXPECT_THAT(bench.alarm_codes(), IsEmpty());
  EXPECT_NEAR(least, 60.0, 1e-9);
  EXPECT_NEAR(most, 62.0, 1e-9);
}

// In a floating chuck the tap breaks when its feed is not that of lead and spindle.
TEST(FloatingTap, KeepsItsFeedUnderALaw) {
  MachineBench bench;
  bench.program("p.nc",
                "G94 G17 G61\nS500 M3\nG0 X0 Z5\nS_n=60 dS=1 dl=1\nG1 Z2.5\nG84 Z-10 R2 K1.5\n"
                "G80\nG1 X1.4\nM30\n");
  bench.run(1, "p.nc");
  int cycles = 0;
  double law_feed = 0.0;
  bench.run_to_end([&](const CycleOutput& output) {
    const ChannelOutput& channel = output.channels[0];
    if (channel.tag.line == 8 && channel.moving)
      law_feed = std::max(law_feed, channel.process.feed_mm_per_min);
    if (channel.tag.line != 6 || channel.process.feed_mm_per_min == 0.0) return;
    EXPECT_EQ(channel.process.feed_mm_per_min, 750.0);
    ++cycles;
  });
  EXPECT_THAT(bench.alarm_codes(), IsEmpty());
  EXPECT_GT(cycles, 2 * 950);         // 12 mm each way at 12.5 mm/s
  EXPECT_NEAR(law_feed, 63.0, 1e-9);  // 2.5 mm before the tap, 1.4 behind it
}

// 24 m/min, which no axis has: the spindle would turn on and the chuck be torn out.
TEST(FloatingTap, IsRefusedWhereTheAxisIsTooSlow) {
  MachineBench bench;
  bench.program("p.nc", "G94 G17\nS12000 M3\nG0 X0 Z5\nG84 Z-10 R2 K2\nG80\nM30\n");
  bench.run(1, "p.nc");
  bench.run_to_end();
  EXPECT_THAT(bench.alarm_codes(), ElementsAre("E5302"));
  const auto alarms = bench.machine().alarms();
  ASSERT_EQ(alarms.size(), 1U);
  EXPECT_EQ(alarms[0].diagnostic.message,
            "the tap would need 24000 mm/min, but the limit of the axes is 15000");
  EXPECT_EQ(alarms[0].diagnostic.place.line, 4);
  EXPECT_EQ(bench.channel(1).point_W[2].value, 2.0);
}

// 250 mm/s are 15000 mm/min; at 45 degrees both axes together reach more.
TEST(Feed, AboveWhatTheAxesCanDoIsWarnedOfOnceARun) {
  MachineBench bench;
  bench.program("p.nc", "G94 G17\nG1 X10 F15000\nX20 Y10 F21000\nX30 F15001\nX40 F20000\nM30\n");
  bench.run(1, "p.nc");
  bench.run_to_end();
  EXPECT_THAT(bench.alarm_codes(), IsEmpty());
  EXPECT_THAT(bench.event_codes(), ::testing::Contains("W810").Times(1));
}

}  // namespace
}  // namespace stanok::channels
