// Threads through the whole chain: program text to setpoints, the spindle as the machine turns it.
//
// The law is s = lead * (angle - start angle) / 360. The angle is the one that the machine tells
// for C, the axis of the spindle, or that of a formula where the test plays its drive.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <optional>
#include <vector>

#include "channels/machine/machine.h"
#include "tests/support/cycle.h"
#include "tests/support/helix.h"
#include "tests/support/machine/machine_bench.h"

namespace stanok::channels {
namespace {

using testing::cycle_s;
using ::testing::DoubleNear;
using ::testing::ElementsAre;
using testing::increment_mm;
using ::testing::IsEmpty;
using testing::lathe_C;
using testing::lathe_X;
using testing::lathe_Z;
using testing::MachineBench;

// Distance along Z, in mm, from the helix that begins at z_start; `lead` has the sign of the way.
double off_helix(const ChannelOutput& channel, double z_start, double lead, double start_deg) {
  const double turns = (channel.axes[lathe_C].position - start_deg) / 360.0;
  return testing::off_helix(turns, channel.axes[lathe_Z].position - z_start, lead);
}

struct Watched {
  double error = 0.0;  // on the helix, mm
  int samples = 0;
  double limits = 0.0;  // used of those of X and Z, at most
  std::optional<ChannelOutput> before;
};

// By the derivatives, and by the way from one setpoint to the next.
void watch_limits(const ChannelOutput& channel, Watched& watched) {
  for (const std::size_t k : {lathe_X, lathe_Z}) {
    if (!watched.before) break;
    const double way = channel.axes[k].position - watched.before->axes[k].position;
    watched.limits = std::max(watched.limits, std::abs(way) / cycle_s / 250.0);
  }
  watched.before = channel;
  for (const std::size_t k : {lathe_X, lathe_Z}) {
    const AxisSetpoint& axis = channel.axes[k];
    watched.limits =
        std::max({watched.limits, std::abs(axis.velocity) / 250.0,
                  std::abs(axis.acceleration) / 2500.0, std::abs(axis.jerk) / 50000.0});
  }
}

TEST(Thread, FollowsTheAngleOfTheSpindle) {
  MachineBench bench(testing::turning_machine());
  bench.program("p.nc", "G8 G18 G95\nS600 M3\nG0 X10 Z2\nG33 Z-30 K1.5 Q45\nG0 X20\nM30\n");
  bench.run(1, "p.nc");
  Watched watched;
  bench.run_to_end([&](const CycleOutput& output) {
    const ChannelOutput& channel = output.channels[0];
    watch_limits(channel, watched);
    const double z = channel.axes[lathe_Z].position;
    if (channel.tag.line != 4 || z > 0.5 || z < -28.5) return;
    watched.error = std::max(watched.error, off_helix(channel, 2.0, -1.5, 45.0));
    ++watched.samples;
  });
  EXPECT_THAT(bench.alarm_codes(), IsEmpty());
  EXPECT_GT(watched.samples, 1800);  // 29 mm at 15 mm/s
  EXPECT_LE(watched.error, increment_mm);
  EXPECT_LE(watched.limits, 1.0 + 1e-12);
  EXPECT_EQ(bench.channel(1).axes[lathe_Z].position, -30.0);
}

// Three starts of one thread, and the helix of each.
TEST(Thread, CutsAHelixPerStartAngle) {
  MachineBench bench(testing::turning_machine());
  bench.program("p.nc",
                "G8 G18 G95\nS450 M3\nnum start = 0;\n"
                "for (start = 0; start < 3; start = start + 1)\n{\n"
                "G0 X12 Z2\nG0 X10\nG33 Z-20 F3 Q=start*120\nG0 X12\n}\nM30\n");
  bench.run(1, "p.nc");
  Watched watched;
  int pass = 0;
  bool cuts = false;
  bench.run_to_end([&](const CycleOutput& output) {
    const ChannelOutput& channel = output.channels[0];
    watch_limits(channel, watched);
    const double z = channel.axes[lathe_Z].position;
    const bool in_thread = channel.tag.line == 8 && z < -1.0 && z > -17.0;
    if (in_thread) {
      watched.error = std::max(watched.error, off_helix(channel, 2.0, -3.0, 120.0 * pass));
      ++watched.samples;
    }
    if (cuts && !in_thread) ++pass;
    cuts = in_thread;
  });
  EXPECT_THAT(bench.alarm_codes(), IsEmpty());
  EXPECT_EQ(pass, 3);
  EXPECT_GT(watched.samples, 3 * 600);  // 16 mm at 22.5 mm/s
  EXPECT_LE(watched.error, increment_mm);
  EXPECT_LE(watched.limits, 1.0 + 1e-12);
}

// A drive that turns C by a formula: 20 % of ripple at 2 Hz, an encoder of 4096 lines.
TEST(Thread, FollowsTheMeasuredAngleNotTheCommandedOne) {
  MachineBench bench(testing::turning_machine());
  bench.program("p.nc",
                "G8 G18 G95\nS600 M3\nnum pass = 0;\n"
                "for (pass = 0; pass < 10; pass = pass + 1)\n{\n"
                "G0 X12 Z2\nG0 X10\nG33 Z-30 K2\nG0 X12\nG4 P0.123\n}\nM30\n");
  bench.run(1, "p.nc");
  const testing::Turning turns = testing::with_ripple(10.0, 0.0);
  Watched watched;
  int cycles = 0;
  do {
    std::vector<AxisFeedback> feedback(3);
    for (AxisFeedback& axis : feedback) axis.valid = axis.enabled = axis.referenced = true;
    feedback[lathe_C].position = testing::encoder_deg(turns(cycles * cycle_s), 4096);
    bench.feedback(feedback);
    bench.cycle();
    ++cycles;
    ChannelOutput channel = bench.channel(1);
    watch_limits(channel, watched);
    const double z = channel.axes[lathe_Z].position;
    if (channel.tag.line != 8 || z > -1.0 || z < -28.0) continue;
    channel.axes[lathe_C].position = 360.0 * turns(cycles * cycle_s);
    watched.error = std::max(watched.error, off_helix(channel, 2.0, -2.0, 0.0));
    ++watched.samples;
  } while (cycles < 10 || (bench.channel(1).running && cycles < 60000));
  EXPECT_THAT(bench.alarm_codes(), IsEmpty());
  EXPECT_GT(watched.samples, 10 * 1200);  // 27 mm at 20 mm/s
  EXPECT_LE(watched.error, increment_mm);
  EXPECT_LE(watched.limits, 1.0 + 1e-12);
}

TEST(Thread, StaysOnTheHelixWhileTheSpindleOverrideChanges) {
  MachineBench bench(testing::turning_machine());
  bench.program("p.nc", "G8 G18 G95\nS600 M3\nG0 X10 Z2\nG33 Z-60 K1.5\nG0 X20\nM30\n");
  bench.run(1, "p.nc");
  Watched watched;
  bool lowered = false;
  bench.run_to_end([&](const CycleOutput& output) {
    const ChannelOutput& channel = output.channels[0];
    watch_limits(channel, watched);
    const double z = channel.axes[lathe_Z].position;
    if (z < -20.0 && !lowered) {
      bench.ask(OperatorAction::override_spindle, 1, "", 0.6);
      bench.ask(OperatorAction::override_feed, 1, "", 0.3);  // it has no effect in a thread
      lowered = true;
    }
    if (channel.tag.line != 4 || z > 0.5 || z < -58.5) return;
    watched.error = std::max(watched.error, off_helix(channel, 2.0, -1.5, 0.0));
    ++watched.samples;
  });
  EXPECT_TRUE(lowered);
  EXPECT_GT(watched.samples, 5000);  // 20 mm at 15 mm/s, 38 mm at 9 mm/s
  EXPECT_LE(watched.error, increment_mm);
  EXPECT_LE(watched.limits, 1.0 + 1e-12);
}

TEST(Thread, ACycleOfPassesCutsOneHelix) {
  MachineBench bench(testing::turning_machine());
  // From X12: crest 11, passes 0.4, 0.8, 0.9 deep and once more, a taper at the end.
  bench.program("p.nc",
                "G8 G18 G95\nS400 M3\nG0 X12 Z2\n"
                "G76 P1.5 Z-25 I-1 J0.4 K0.9 R1 Q0 H1 E2 L2\nM30\n");
  bench.run(1, "p.nc");
  Watched watched;
  testing::PassDepths depths(-10.0);
  bench.run_to_end([&](const CycleOutput& output) {
    const ChannelOutput& channel = output.channels[0];
    watch_limits(channel, watched);
    const double x = channel.axes[lathe_X].position;
    const double z = channel.axes[lathe_Z].position;
    depths.see(z, x);
    if (channel.tag.line != 4 || x > 10.99 || z > 0.5 || z < -24.0) return;
    // Z does not know where the taper begins.
    watched.error = std::max(watched.error, off_helix(channel, 2.0, -1.5, 0.0));
    ++watched.samples;
  });
  EXPECT_THAT(bench.alarm_codes(), IsEmpty());
  EXPECT_THAT(depths.all(), ElementsAre(DoubleNear(10.6, 1e-9), DoubleNear(10.2, 1e-9),
                                        DoubleNear(10.1, 1e-9), DoubleNear(10.1, 1e-9)));
  EXPECT_GT(watched.samples, 4 * 2000);  // 24 mm at 10 mm/s
  EXPECT_LE(watched.error, increment_mm);
  EXPECT_LE(watched.limits, 1.0 + 1e-12);
}

// The spindle turns back at the bottom, the tool comes back along the same helix, and the spindle
// turns as before.
TEST(Thread, ATapComesBackOnItsHelix) {
  MachineBench bench(testing::turning_machine());
  bench.program("p.nc", "G8 G18 G94\nS600 M3\nG0 X0 Z5\nG33.1 Z-20 K1.5\nG4 P0.5\nM30\n");
  bench.run(1, "p.nc");
  Watched watched;
  double bottom = 5.0;
  double fastest_back = 0.0;
  double speed_at_end = 0.0;
  bench.run_to_end([&](const CycleOutput& output) {
    const ChannelOutput& channel = output.channels[0];
    watch_limits(channel, watched);
    const double z = channel.axes[lathe_Z].position;
    bottom = std::min(bottom, z);
    fastest_back = std::min(fastest_back, channel.axes[lathe_C].velocity);
    if (channel.tag.line == 5) speed_at_end = channel.axes[lathe_C].velocity;
    if (channel.tag.line != 4 || z > 3.5) return;
    watched.error = std::max(watched.error, off_helix(channel, 5.0, -1.5, 0.0));
    ++watched.samples;
  });
  EXPECT_THAT(bench.alarm_codes(), IsEmpty());
  EXPECT_NEAR(bottom, -20.0, increment_mm);
  EXPECT_EQ(fastest_back, -3600.0);  // 600 rev/min in deg/s
  EXPECT_EQ(bench.channel(1).axes[lathe_Z].position, 5.0);
  EXPECT_GT(watched.samples, 2 * 1500);
  EXPECT_LE(watched.error, 2.0 * increment_mm);
  EXPECT_LE(watched.limits, 1.0 + 1e-12);
}

TEST(Thread, AHoldActsBehindTheThread) {
  MachineBench bench(testing::turning_machine());
  bench.program("p.nc", "G8 G18 G95\nS600 M3\nG0 X10 Z2\nG33 Z-30 K1.5\nG0 X20\nM30\n");
  bench.run(1, "p.nc");
  bool asked = false;
  bench.run_to_end([&](const CycleOutput& output) {
    if (asked || output.channels[0].axes[lathe_Z].position > -10.0) return;
    bench.ask(OperatorAction::program_hold, 1);
    asked = true;
  });
  EXPECT_EQ(bench.channel(1).state, ChannelState::held);
  EXPECT_EQ(bench.channel(1).axes[lathe_Z].position, -30.0);
  EXPECT_EQ(bench.channel(1).axes[lathe_X].position, 10.0);
}

// What is left of a planned move that an override changed is forgotten with it: behind the thread
// the next move begins at its beginning.
TEST(Thread, AnOverrideBeforeItDoesNotReachBehindIt) {
  for (int begin = 450; begin < 800; begin += 50) {
    MachineBench bench(testing::turning_machine());
    bench.program("p.nc",
                  "G8 G18 G95\nS600 M3\nG94 G1 X5 F1200\nG33 Z-10 K1.5\nG0 Z0\nG1 X0 Z-3\nM30\n");
    bench.run(1, "p.nc");
    Watched watched;
    const auto watch = [&](const CycleOutput& output) {
      watch_limits(output.channels[0], watched);
    };
    for (int cycle = 0; cycle < begin; ++cycle) watch(bench.cycle());
    bench.ask(OperatorAction::override_feed, 1, "", 0.5);
    while (bench.channel(1).tag.line < 4) watch(bench.cycle());
    bench.ask(OperatorAction::override_feed, 1, "", 1.0);
    bench.run_to_end(watch);
    EXPECT_THAT(bench.alarm_codes(), IsEmpty()) << begin;
    EXPECT_EQ(bench.channel(1).axes[lathe_Z].position, -3.0) << begin;
    EXPECT_LE(watched.limits, 1.0 + 1e-9) << begin;
  }
}

// At any moment of the wait for the start angle, and for less than a turn up to several: the path
// begins with the angle of a later turn, on the same helix.
TEST(Thread, AHoldBeforeItLetsTheStartAnglePass) {
  for (int begin = 430; begin < 510; begin += 7) {
    MachineBench bench(testing::turning_machine());
    bench.program("p.nc", "G8 G18 G95\nS600 M3\nG33 Z-10 K1.5 Q45\nM30\n");
    bench.run(1, "p.nc");
    Watched watched;
    const auto watch = [&](const CycleOutput& output) {
      const ChannelOutput& channel = output.channels[0];
      watch_limits(channel, watched);
      const double z = channel.axes[lathe_Z].position;
      if (z < -1.0 && z > -9.0)
        watched.error = std::max(watched.error, off_helix(channel, 0.0, -1.5, 45.0));
    };
    for (int cycle = 0; cycle < begin; ++cycle) watch(bench.cycle());
    bench.ask(OperatorAction::program_hold, 1);
    for (int cycle = 0; cycle < 50; ++cycle) watch(bench.cycle());
    bench.ask(OperatorAction::program_resume, 1);
    bench.run_to_end(watch);
    EXPECT_THAT(bench.alarm_codes(), IsEmpty()) << begin;
    EXPECT_LE(watched.error, increment_mm) << begin;
    EXPECT_EQ(bench.channel(1).axes[lathe_Z].position, -10.0) << begin;
  }
}

TEST(Thread, AResetEndsItOnItsWay) {
  MachineBench bench(testing::turning_machine());
  bench.program("p.nc", "G8 G18 G95\nS600 M3\nG0 X10 Z2\nG33 Z-60 K1.5\nG0 X20\nM30\n");
  bench.run(1, "p.nc");
  Watched watched;
  bool asked = false;
  bench.run_to_end([&](const CycleOutput& output) {
    watch_limits(output.channels[0], watched);
    if (asked || output.channels[0].axes[lathe_Z].position > -10.0) return;
    bench.ask(OperatorAction::program_reset, 1);
    asked = true;
  });
  EXPECT_EQ(bench.channel(1).state, ChannelState::ready);
  EXPECT_NEAR(bench.channel(1).axes[lathe_Z].position, -10.3, 0.2);
  EXPECT_LE(watched.limits, 1.0 + 1e-12);
  // And the machine can be used on.
  bench.run(1, "p.nc");
  bench.run_to_end();
  EXPECT_EQ(bench.channel(1).axes[lathe_Z].position, -60.0);
}

// Single block stops before the thread and behind it; its blocks are one motion.
TEST(Thread, IsOneStepOfSingleBlock) {
  MachineBench bench(testing::turning_machine());
  bench.program("p.nc",
                "G8 G18 G95\nS600 M3\nG0 X10 Z2\nG33 Z-20 K1.5\nG33 Z-40 K1.5\nG0 X20\nM30\n");
  bench.ask(OperatorAction::single_block, 1, "", 0.0, 1);
  bench.run(1, "p.nc");
  double slowest = 1e9;
  int stops = 0;
  for (; stops < 10; ++stops) {
    bench.run_to_end([&](const CycleOutput& output) {
      const AxisSetpoint& z = output.channels[0].axes[lathe_Z];
      if (z.position < -18.0 && z.position > -22.0) slowest = std::min(slowest, -z.velocity);
    });
    if (!bench.channel(1).running) break;
    EXPECT_EQ(bench.channel(1).hold_cause, HoldCause::single_block);
    bench.ask(OperatorAction::program_start, 1);
  }
  EXPECT_THAT(bench.alarm_codes(), IsEmpty());
  EXPECT_LT(stops, 8);
  EXPECT_NEAR(slowest, 15.0, 0.5);
  EXPECT_EQ(bench.channel(1).axes[lathe_Z].position, -40.0);
}

// A tool in a hole must not be torn off its helix.
TEST(Thread, AResetInATapStopsTheSpindleOnTheHelix) {
  MachineBench bench(testing::turning_machine());
  bench.program("p.nc", "G8 G18 G94\nS600 M3\nG0 X0 Z5\nG33.1 Z-40 K1.5\nM30\n");
  bench.run(1, "p.nc");
  bool asked = false;
  double error = 0.0;
  Watched watched;
  bench.run_to_end([&](const CycleOutput& output) {
    const ChannelOutput& channel = output.channels[0];
    watch_limits(channel, watched);
    if (asked && channel.running) error = std::max(error, off_helix(channel, 5.0, -1.5, 0.0));
    if (asked || channel.axes[lathe_Z].position > -10.0) return;
    bench.ask(OperatorAction::program_reset, 1);
    asked = true;
  });
  EXPECT_EQ(bench.channel(1).state, ChannelState::ready);
  EXPECT_EQ(bench.channel(1).axes[lathe_C].velocity, 0.0);
  // 600 rev/min at 1500 rev/min/s: two turns, 3 mm.
  EXPECT_NEAR(bench.channel(1).axes[lathe_Z].position, -13.0, 0.2);
  EXPECT_LE(error, 2.0 * increment_mm);
  EXPECT_LE(watched.limits, 1.0 + 1e-12);
}

// G96 gives the speed by the diameter: 350 m/min are 1857 rev/min at 60 mm, and 2785.21 at 40,
// where a lead of 6 mm is 278.5 mm/s.
TEST(Thread, IsJudgedAtTheHighestSpeedThatG96Gives) {
  for (const char* thread : {"G33 X20 Z-30 K6\n", "G33 Z-5 K6\nG33 X20 Z-30 K6\n"}) {
    SCOPED_TRACE(thread);
    MachineBench bench(testing::turning_machine());
    bench.program("p.nc", "G8 G18 G95\nG96 S350 M3\nG0 X30 Z2\n" + std::string(thread) + "M30\n");
    bench.run(1, "p.nc");
    bench.run_to_end();
    const auto alarms = bench.machine().alarms();
    ASSERT_EQ(alarms.size(), 1U);
    EXPECT_EQ(alarms[0].diagnostic.code, "E5302");
    EXPECT_THAT(alarms[0].diagnostic.message, ::testing::HasSubstr(" mm/s at 2785.21 rev/min"));
    EXPECT_THAT(alarms[0].diagnostic.help[0], ::testing::HasSubstr(" of G97, or"));
  }
}

// A chain whose corners are made for the speed at its smallest diameter, and whose last part runs
// out of the thread: 120 m/min are 573 rev/min at 66.6 mm.
TEST(Thread, RunsOutOverAChamferUnderG96) {
  MachineBench bench(testing::turning_machine());
  bench.program("p.nc",
                "G8 G18 G95\nG96 S120 D2000 M3\nG0 X42 Z4\nX33.3\nG33 Z-23 K1.3\n"
                "G33 X34.6 Z-24.3 K1.838\nG0 X42\nM30\n");
  bench.run(1, "p.nc");
  Watched watched;
  bench.run_to_end([&](const CycleOutput& output) { watch_limits(output.channels[0], watched); });
  EXPECT_THAT(bench.alarm_codes(), ::testing::IsEmpty());
  EXPECT_EQ(bench.channel(1).axes[lathe_Z].position, -24.3);
  EXPECT_LE(watched.limits, 1.0 + 1e-12);
}

// The way out over a taper of one lead: where the axes cannot take its corner at the speed, it
// begins earlier, and the tool is nowhere deeper than programmed, nor beyond the end of the thread.
TEST(Thread, TheWayOutBeginsAsEarlyAsTheAxesNeed) {
  constexpr double end = -25.0;
  constexpr double taper = 1.5;
  constexpr double depth = 0.9;
  for (const int speed : {300, 1000, 2000, 3000}) {
    SCOPED_TRACE(speed);
    MachineBench bench(testing::turning_machine());
    bench.program("p.nc", "G8 G18 G95 G64 P0.01\nS" + std::to_string(speed) +
                              " M3\nG0 X15 Z5\n"
                              "G76 P1.5 Z-25 I-1 J0.9 K0.9 R1 Q0 H0 E1.5 L2\nM30\n");
    bench.run(1, "p.nc");
    Watched watched;
    double deepest = 20.0;
    double last_at_depth = 5.0;
    bool has_begun = false;
    bench.run_to_end([&](const CycleOutput& output) {
      watch_limits(output.channels[0], watched);
      const double x = output.channels[0].axes[lathe_X].position;
      const double z = output.channels[0].axes[lathe_Z].position;
      has_begun = has_begun || x > 14.0;
      if (!has_begun) return;
      const double programmed = 14.0 - depth + std::max(0.0, (end + taper - z) / taper * depth);
      EXPECT_GE(x, programmed - 1e-9) << z;
      EXPECT_GE(z, end - 1e-9);
      deepest = std::min(deepest, x);
      if (x < 14.0 - depth + 1e-9) last_at_depth = std::min(last_at_depth, z);
    });
    EXPECT_THAT(bench.alarm_codes(), ::testing::IsEmpty());
    EXPECT_NEAR(deepest, 14.0 - depth, 1e-9);
    EXPECT_LE(watched.limits, 1.0 + 1e-12);
    EXPECT_LE(last_at_depth, -10.0);
  }
}

TEST(Thread, NeedsAnEncoder) {
  MachineConfig machine = testing::turning_machine();
  machine.spindles[0].encoder_pulses = 0;
  MachineBench bench(machine);
  bench.program("p.nc", "G8 G18 G95\nS600 M3\nG0 X10 Z2\nG33 Z-30 K1.5\nM30\n");
  bench.run(1, "p.nc");
  bench.run_to_end();
  EXPECT_THAT(bench.alarm_codes(), ElementsAre("E5301"));
}

// With a tolerance of its own a corner keeps it, and must be passed at the speed of the spindle.
TEST(Thread, IsRefusedWhereItsCornerIsTooSharpForTheTolerance) {
  MachineBench bench(testing::turning_machine());
  bench.program("p.nc",
                "G8 G18 G95\nS1500 M3\nG0 X10 Z2\nG64 P0.001\nG33 Z-10 K3\nG33 X30 Z-12 K3\nM30\n");
  bench.run(1, "p.nc");
  bench.run_to_end();
  EXPECT_THAT(bench.alarm_codes(), ElementsAre("E5303"));
}

TEST(Thread, IsRefusedBeyondTheBlocksThatAChainMayHave) {
  MachineBench bench(testing::turning_machine());
  std::string blocks;
  for (int n = 0; n < 600; ++n) blocks += "G33 Z-0.2 K1.5\n";
  bench.program("p.nc", "G8 G18 G95\nS300 M3\nG0 X10 Z2\nG91\n" + blocks + "M30\n");
  bench.run(1, "p.nc");
  bench.run_to_end();
  EXPECT_THAT(bench.alarm_codes(), ElementsAre("E5304"));
}

TEST(Thread, IsTappedRigidlyOnlyByASpindleWithAnAcceleration) {
  MachineConfig machine = testing::turning_machine();
  machine.spindles[0].acceleration = 0.0;
  MachineBench bench(machine);
  bench.program("p.nc", "G8 G18 G95\nS300 M3\nG0 X0 Z2\nG33.1 Z-10 K1.5\nM30\n");
  bench.run(1, "p.nc");
  bench.run_to_end();
  EXPECT_THAT(bench.alarm_codes(), ElementsAre("E5305"));
}

TEST(Thread, IsRefusedWhereAnAxisIsTooSlowForIt) {
  MachineBench bench(testing::turning_machine());
  bench.program("p.nc", "G8 G18 G95\nS3000 M3\nG0 X10 Z2\nG33 Z-30 K6\nM30\n");
  bench.run(1, "p.nc");
  bench.run_to_end();
  const auto alarms = bench.machine().alarms();
  ASSERT_EQ(alarms.size(), 1U);
  EXPECT_EQ(alarms[0].diagnostic.code, "E5302");
  EXPECT_EQ(alarms[0].diagnostic.message,
            "axis Z would need 300 mm/s at 3000 rev/min, but its limit in a thread is 247.5");
  EXPECT_EQ(alarms[0].diagnostic.help[0], "use at most S2475, or cut a smaller lead");
  EXPECT_EQ(bench.channel(1).axes[lathe_Z].position, 2.0);
}

}  // namespace
}  // namespace stanok::channels
