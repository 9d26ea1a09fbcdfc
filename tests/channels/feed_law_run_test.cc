// Feed laws stated in programs, through language, preparation and cycle: the feed at each place of
// the path against the law's definition, written out here.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/cycle.h"
#include "tests/support/machine/turning_bench.h"

namespace stanok::channels {
namespace {

using ::testing::ElementsAre;
using testing::increment_mm;
using ::testing::IsEmpty;
using testing::MachineBench;

struct Cut {
  double way = 0.0;  // along Z from where the cut began
  ProcessOutput process;
  double x = 0.0;
};

// Runs a program that cuts along Z from 0 and gives the cycles of the cut.
std::vector<Cut> cut(const std::string& program, double spindle_acceleration = 0.0) {
  MachineBench bench(testing::lathe_with_spindle(10.0, spindle_acceleration));
  bench.program("cut.nc", program);
  bench.run(1, "cut.nc");
  std::vector<Cut> cuts;
  bench.run_to_end([&](const CycleOutput& output) {
    const ChannelOutput& channel = output.channels[0];
    if (channel.process.feed_mm_per_min > 0.0)
      cuts.push_back({-channel.point_W[1].value, channel.process, channel.point_W[0].value});
  });
  EXPECT_THAT(bench.alarm_codes(), IsEmpty());
  EXPECT_FALSE(cuts.empty());
  return cuts;
}

std::vector<std::string> alarms_of(const std::string& program, int line) {
  MachineBench bench(testing::lathe_with_spindle(10.0, 0.0));
  bench.program("cut.nc", program);
  bench.run(1, "cut.nc");
  bench.run_to_end();
  EXPECT_EQ(bench.machine().alarms().size(), 1U);
  if (!bench.machine().alarms().empty()) {
    EXPECT_EQ(bench.machine().alarms()[0].diagnostic.place.line, line);
  }
  return bench.alarm_codes();
}

// Increments that a law with one at every `step` mm has made at `way`; at an increment either
// count.
void expect_count(const Cut& one, double step, double increments_max = 1e9) {
  const double low = std::min(std::floor((one.way - increment_mm) / step), increments_max);
  const double high = std::min(std::floor((one.way + increment_mm) / step), increments_max);
  EXPECT_GE(static_cast<double>(one.process.increments), low) << "at " << one.way;
  EXPECT_LE(static_cast<double>(one.process.increments), high) << "at " << one.way;
}

TEST(FeedLawRun, LinearFeedRisesWithTheWay) {
  const auto cuts = cut("G0 X60 Z0\nG94 G1 Z-20 S_n=120 dS=0.5 dl=0.1\nM30\n");
  ASSERT_GT(cuts.size(), 1000U);
  for (const Cut& one : cuts) {
    expect_count(one, 0.1);
    EXPECT_NEAR(one.process.feed_mm_per_min,
                120.0 + 0.5 * static_cast<double>(one.process.increments), 1e-9);
    if (::testing::Test::HasFailure()) return;
  }
  EXPECT_EQ(cuts.back().process.law, motion::LawKind::linear);
}

// dl follows from the length, rounded down to increments of the machine: 7 mm / 30 -> 0.233 mm.
TEST(FeedLawRun, LinearFeedReachesItsLastFeed) {
  const auto cuts = cut("G0 X60 Z0\nG94 G1 Z-7 S_n=100 S_k=70 dS=1\nM30\n");
  for (const Cut& one : cuts) {
    expect_count(one, 0.233, 30.0);
    EXPECT_NEAR(one.process.feed_mm_per_min, 100.0 - static_cast<double>(one.process.increments),
                1e-9);
    if (::testing::Test::HasFailure()) return;
  }
  EXPECT_NEAR(cuts.back().process.feed_mm_per_min, 70.0, 1e-9);
}

TEST(FeedLawRun, ModulatedFeedGoesOnAcrossBlocks) {
  const auto cuts =
      cut("G0 X60 Z0\nG94 G61\nSmin=100 Smax=200 dS=10 dl=0.2\nG1 Z-5.5\nZ-11.3\n#feedlaw (off)\n"
          "G1 Z-12 F50\nM30\n");
  for (const Cut& one : cuts) {
    if (one.way > 11.3 - increment_mm) break;
    expect_count(one, 0.2);
    const auto in_cycle = one.process.increments % 20;
    const auto above = static_cast<double>(in_cycle < 10 ? in_cycle : 20 - in_cycle);
    EXPECT_NEAR(one.process.feed_mm_per_min, 100.0 + 10.0 * above, 1e-9);
    if (::testing::Test::HasFailure()) return;
  }
  EXPECT_NEAR(cuts.back().process.feed_mm_per_min, 50.0, 1e-9);
  EXPECT_EQ(cuts.back().process.law, motion::LawKind::none);
}

TEST(FeedLawRun, FeedPerRevolutionStepsWithTheSpindleAtItsSpeed) {
  const auto cuts = cut("G0 X60 Z0\nS800 M3\nG95 G1 Z-6 S_n=0.10 dS=0.002 dl=0.5\nM5\nM30\n");
  for (const Cut& one : cuts) {
    expect_count(one, 0.5);
    EXPECT_NEAR(one.process.feed_mm_per_rev,
                0.1 + 0.002 * static_cast<double>(one.process.increments), 1e-12);
  }
}

TEST(FeedLawRun, SpindleStepsAtThePlacesOfTheFeed) {
  const auto cuts =
      cut("G0 X60 Z0\nS600 M3\nG94 G1 Z-10 n_n=600 dn=-4 S_n=90 dS=2 dl=0.25\nM5\nM30\n");
  for (const Cut& one : cuts) {
    const auto k = static_cast<double>(one.process.increments);
    expect_count(one, 0.25);
    EXPECT_NEAR(one.process.feed_mm_per_min, 90.0 + 2.0 * k, 1e-9);
    EXPECT_NEAR(one.process.spindle_rev_per_min, 600.0 - 4.0 * k, 1e-9);
    if (::testing::Test::HasFailure()) return;
  }
}

TEST(FeedLawRun, CuttingSpeedStepsAtThePlacesOfTheFeed) {
  const auto cuts =
      cut("G0 X60 Z0\nS530 M3\nG94 G1 X50 Z-10 v_n=100 dv=2 S_n=90 dS=2 dl=0.25\nM5\nM30\n");
  double diameter_before = 60.0;
  for (const Cut& one : cuts) {
    const auto k = static_cast<double>(one.process.increments);
    const double v = 100.0 + 2.0 * k;
    const double n = 1000.0 * v / (std::numbers::pi * diameter_before);
    // The spindle takes the diameter of this cycle or the one before.
    EXPECT_NEAR(one.process.spindle_rev_per_min, n, 1e-3 * n);
    diameter_before = 2.0 * one.x;
    if (::testing::Test::HasFailure()) return;
  }
}

TEST(FeedLawRun, InterruptedFeedStands) {
  const std::string head = "G0 X60 Z0\nG94 G61\n";
  const auto plain = cut(head + "G1 Z-10 F120\nM30\n");
  const auto cuts = cut(head + "G1 Z-10 F120 L_A=0.4 L_B=2\nM30\n");
  // Four stands of 0.4 mm at 2 mm/s, and four times the loss of a stop from 2 mm/s, which takes
  // 2 sqrt(v / j) and is half of it behind, twice: 12.6 ms.
  const double extra = static_cast<double>(cuts.size()) - static_cast<double>(plain.size());
  EXPECT_NEAR(extra, 4.0 * (200.0 + 2.0 * 1000.0 * std::sqrt(2.0 / 50000.0)), 6.0);
  EXPECT_TRUE(std::any_of(cuts.begin(), cuts.end(), [](const Cut& one) {
    return one.process.stands && std::abs(one.way - 2.0) < 1e-9;
  }));
}

TEST(FeedLawRun, CurveOfArrays) {
  const auto cuts =
      cut("num ways[3] = {0, 4, 10};\nnum feeds[3] = {60, 100, 80};\nG0 X60 Z0\nG94 G61\n"
          "#feedlaw (curve, ways, feeds)\nG1 Z-12\nM30\n");
  for (const Cut& one : cuts) {
    const double wanted = one.way < 4.0    ? 60.0 + 10.0 * one.way
                          : one.way < 10.0 ? 100.0 - 20.0 * (one.way - 4.0) / 6.0
                                           : 80.0;
    EXPECT_NEAR(one.process.feed_mm_per_min, wanted, 0.15);
    if (::testing::Test::HasFailure()) return;
  }
}

TEST(FeedLawRun, IsTheSameToTheBitWithoutALaw) {
  const std::string head = "G0 X60 Z0\nG94 G1 Z-1 F120\n";
  const std::string tail = "X64 Z-5\nG3 X60 Z-12 R9\nG1 Z-14\nM30\n";
  std::vector<Cut> with = cut(head + tail);
  const std::vector<Cut> without = cut(head + "#feedlaw (off)\n" + tail);
  ASSERT_EQ(with.size(), without.size());
  for (std::size_t k = 0; k < with.size(); ++k) {
    EXPECT_EQ(with[k].way, without[k].way);
    EXPECT_EQ(with[k].x, without[k].x);
  }
}

// 10 - k after k mm: zero at the tenth.
TEST(FeedLawRun, RefusesALawThatComesToZero) {
  MachineBench bench(testing::lathe_with_spindle(10.0, 0.0));
  bench.program("cut.nc", "G0 X60 Z0\nG94\nG1 Z-1 F100\nZ-20 S_n=10 dS=1 dl=-1\nM30\n");
  bench.run(1, "cut.nc");
  bench.run_to_end();
  EXPECT_THAT(bench.alarm_codes(), ElementsAre("E5106"));
  EXPECT_EQ(bench.channel(1).point_W[1].value, -1.0) << "the end of the block before";
  const auto alarms = bench.machine().alarms();
  ASSERT_EQ(alarms.size(), 1U);
  EXPECT_EQ(alarms[0].diagnostic.place.line, 4);
  EXPECT_EQ(alarms[0].diagnostic.message,
            "the feed law reaches 0 mm/min after 10 mm of its path of 19 mm");
}

TEST(FeedLawRun, DoesNotCountBlocksOfRotaryAxesAlone) {
  MachineBench bench;
  bench.program("p.nc",
                "#kinematics (2, 1)\nG21 G90 G94 G61\nG1 X0 F600\n#feedlaw (linear, 600, 30, "
                "1)\nX5\nB30\nX12\nM30\n");
  bench.run(1, "p.nc");
  std::uint64_t made = 0;
  bench.run_to_end([&](const CycleOutput& output) {
    const ChannelOutput& channel = output.channels[0];
    if (channel.process.law != motion::LawKind::linear || !channel.moving) return;
    made = std::max(made, channel.process.increments);
    EXPECT_NEAR(channel.process.feed_mm_per_min,
                600.0 + 30.0 * static_cast<double>(channel.process.increments), 1e-9);
  });
  EXPECT_EQ(made, 11U);
}

// y = x^2 from -2 to 2: the way is that of the curve, in its own block and for a modal law.
TEST(FeedLawRun, FollowsASpline) {
  for (const char* law :
       {"G5.1 X2 I2 J-8 S_n=600 dS=10 dl=0.5\n", "S_n=600 dS=10 dl=0.5\nG5.1 X2 I2 J-8\n"}) {
    SCOPED_TRACE(law);
    MachineBench bench;
    bench.program("p.nc", "G94 G17 G61\nG0 X-2 Y4 Z0\n" + std::string(law) + "M30\n");
    bench.run(1, "p.nc");
    std::uint64_t made = 0;
    const auto length_to = [](double x) {  // from the vertex
      return 0.5 * x * std::sqrt(1.0 + 4.0 * x * x) + 0.25 * std::asinh(2.0 * x);
    };
    bench.run_to_end([&](const CycleOutput& output) {
      const ChannelOutput& channel = output.channels[0];
      if (channel.process.law != motion::LawKind::linear || !channel.moving) return;
      const double way = length_to(2.0) + length_to(channel.point_W[0].value);
      made = channel.process.increments;
      expect_count({.way = way, .process = channel.process}, 0.5);
      EXPECT_NEAR(channel.process.feed_mm_per_min, 600.0 + 10.0 * static_cast<double>(made), 1e-9);
    });
    EXPECT_THAT(bench.alarm_codes(), IsEmpty());
    EXPECT_EQ(made, 18U);  // 9.29 mm
  }
}

// The axes stand while the tool changes; the path of the law waits.
TEST(FeedLawRun, GoesOnBehindAToolChange) {
  const auto cuts =
      cut("G0 X60 Z0\nG94 G61\nS_n=120 dS=2 dl=0.5\nG1 Z-3.2\nT2 M6\nG4 P0.05\nG1 Z-8\nM30\n");
  std::uint64_t made = 0;
  for (const Cut& one : cuts) {
    expect_count(one, 0.5);
    made = one.process.increments;
    EXPECT_NEAR(one.process.feed_mm_per_min, 120.0 + 2.0 * static_cast<double>(made), 1e-9);
    if (::testing::Test::HasFailure()) return;
  }
  EXPECT_EQ(made, 15U);
}

// Lines of an operator share the spindle and the modal law.
TEST(FeedLawRun, LastsFromLineToLineAsTheSpindleDoes) {
  MachineBench bench(testing::lathe_with_spindle(10.0, 0.0));
  for (const char* line : {"G18 S600 M3", "G95 G1 Z-1 F0.1", "G94 S_n=60 dS=1 dl=1"}) {
    bench.ask(OperatorAction::mdi, 1, line);
    bench.run_to_end();
  }
  bench.ask(OperatorAction::mdi, 1, "G1 Z-6.5");
  bench.run_to_end();
  EXPECT_THAT(bench.alarm_codes(), IsEmpty());
  EXPECT_EQ(bench.channel(1).process.law, motion::LawKind::linear);
  EXPECT_EQ(bench.channel(1).process.increments, 5U);
}

TEST(FeedLawRun, EndsWithAReset) {
  MachineBench bench(testing::lathe_with_spindle(10.0, 0.0));
  bench.program("law.nc", "G94 G18\nS_n=60 dS=1 dl=1\nG1 Z-50\nM30\n");
  bench.program("plain.nc", "G94 G18\nG1 Z-60 F300\nM30\n");
  bench.run(1, "law.nc");
  for (int cycle = 0; cycle < 500; ++cycle) bench.cycle();
  EXPECT_EQ(bench.channel(1).process.law, motion::LawKind::linear);
  bench.ask(OperatorAction::program_reset, 1);
  bench.run_to_end();
  bench.run(1, "plain.nc");
  bench.run_to_end();
  EXPECT_THAT(bench.alarm_codes(), IsEmpty());
  EXPECT_EQ(bench.channel(1).process.law, motion::LawKind::none);
}

// A reset stops the spindle: a feed per revolution would wait for it for ever.
TEST(ResetFeedPerRevolution, NeedsTheSpindleAnewAfterAReset) {
  MachineBench bench(testing::lathe_with_spindle(10.0, 0.0));
  bench.program("cut.nc", "G95 G18 S600 M3\nG1 Z-50 F0.1\nM30\n");
  bench.run(1, "cut.nc");
  for (int cycle = 0; cycle < 500; ++cycle) bench.cycle();
  bench.ask(OperatorAction::program_reset, 1);
  bench.run_to_end();
  bench.ask(OperatorAction::mdi, 1, "G95 G1 Z-60 F0.1");
  bench.run_to_end();
  EXPECT_THAT(bench.alarm_codes(), ElementsAre("E4021"));
}

TEST(FeedLawRun, RefusesMoreIncrementsThanTheMachineHas) {
  EXPECT_THAT(alarms_of("G0 X60 Z0\nG94\nG1 Z-0.05 S_n=10 S_k=1000 dS=0.1\nM30\n", 3),
              ElementsAre("E5105"));
}

}  // namespace
}  // namespace stanok::channels
