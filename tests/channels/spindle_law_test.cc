// Laws of spindle speed with feed, from the program to the setpoints: n_n to n_k and S_n to S_k in
// increments at the same places, against the sum over the increments that is made here.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "tests/support/machine/turning_bench.h"

namespace stanok::channels {
namespace {

using testing::CutCycle;
using testing::CutTime;
using ::testing::ElementsAre;
using testing::FeedOf;
using testing::MachineBench;
using testing::per_min;
using testing::per_rev;
using testing::word_unless_zero;

// A case states n_k and S_k, or dn, dS and dl; what is 0 stands not in the program.
struct SpindleLawCase {
  const char* name;
  const char* motion;  // from X60 Z0
  double length;       // of the motion
  bool per_revolution;
  double n_first, n_last, n_step;
  double feed_first, feed_last, feed_step;  // the step without sign, as the program has it
  double dl;                                // signed, as the program has it
};

std::string program_of(const SpindleLawCase& c) {
  return "G0 X60 Z0\nG4 P0.01\nG97 S" + std::to_string(c.n_first) + " M3\n" +
         (c.per_revolution ? "G95 " : "G94 ") + c.motion + word_unless_zero("n_n", c.n_first) +
         word_unless_zero("n_k", c.n_last) + word_unless_zero("dn", c.n_step) +
         word_unless_zero("S_n", c.feed_first) + word_unless_zero("S_k", c.feed_last) +
         word_unless_zero("dS", c.feed_step) + word_unless_zero("dl", c.dl) + "\nM5\nM30\n";
}

// What the law says: |dl| is a whole number of machine increments first, its number of increments
// comes from the feed, or from the length where the feed stays, and dn follows from it.
struct Reckoning {
  double dl = 0.0;
  double feed_step = 0.0;
  double n_step = 0.0;
  std::uint64_t increments = 0;  // that have a path behind them
  double n_end = 0.0;            // one at the very end counts

  explicit Reckoning(const SpindleLawCase& c) {
    const bool has_last = c.feed_last > 0.0;
    const double change = c.feed_last - c.feed_first;
    double count = std::round(std::abs(change) / c.feed_step);
    dl = std::abs(c.dl);
    if (c.dl == 0.0) dl = 0.001 * std::floor(c.length / count / 0.001 + 1e-6);
    const double fit = std::ceil(c.length / dl - 1e-6) - 1.0;  // one at the very end is none
    if (has_last && change == 0.0) count = std::floor(c.length / dl + 1e-6);
    feed_step = has_last ? (change == 0.0 ? 0.0 : std::copysign(c.feed_step, change))
                         : std::copysign(c.feed_step, c.dl);
    n_step = c.n_last > 0.0 ? (c.n_last - c.n_first) / count : c.n_step;
    increments = static_cast<std::uint64_t>(has_last ? std::min(count, fit) : fit);
    const double all = std::floor(c.length / dl + 1e-6);
    n_end = c.n_first + n_step * (has_last ? std::min(count, all) : all);
  }
};

class SpindleLaw : public ::testing::TestWithParam<SpindleLawCase> {};

TEST_P(SpindleLaw, StepsSpeedAndFeedAtTheSamePlaces) {
  const SpindleLawCase& c = GetParam();
  const Reckoning law(c);
  CutTime wanted;
  double n = c.n_first;
  double feed = c.feed_first;
  for (std::uint64_t k = 0; k < law.increments; ++k) {
    wanted.add(law.dl, c.per_revolution ? feed * n : feed);
    n += law.n_step;
    feed += law.feed_step;
  }
  wanted.add(c.length - wanted.way(), c.per_revolution ? feed * n : feed);

  MachineBench bench(testing::strong_lathe(10.0));
  const auto cycles = testing::cycles_of_cut(bench, program_of(c));
  testing::expect_cut(cycles, wanted, c.per_revolution ? FeedOf::revolution : FeedOf::time);
  for (const CutCycle& one : cycles) {
    if (one.is_last) break;
    const auto k = static_cast<double>(one.process.increments);
    EXPECT_NEAR(one.process.spindle_rev_per_min, c.n_first + k * law.n_step, 1e-9);
    // Beside an increment either count; behind the last one none is made any more.
    const auto most = static_cast<double>(law.increments);
    EXPECT_GE(k, std::min(most, std::floor((one.way - 1e-3) / law.dl)));
    EXPECT_LE(k, std::min(most, std::floor((one.way + 1e-3) / law.dl)));
    if (!c.per_revolution) {
      EXPECT_NEAR(one.process.feed_mm_per_min, c.feed_first + k * law.feed_step, 1e-9);
    }
    if (::testing::Test::HasFailure()) return;
  }
  EXPECT_EQ(cycles.back().process.increments, law.increments);
  EXPECT_NEAR(cycles.back().process.spindle_rev_per_min, law.n_end, 1e-9);
  if (c.n_last > 0.0 && c.dl == 0.0) {
    EXPECT_NEAR(law.n_end, c.n_last, 1e-9);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Cases, SpindleLaw,
    ::testing::Values(
        // By the increments.
        SpindleLawCase{"both_rise", "G1 Z-10", 10.0, per_min, 600, 0, 4, 90, 0, 2, 0.25},
        SpindleLawCase{"speed_falls", "G1 Z-10", 10.0, per_min, 900, 0, -5, 120, 0, 1.5, 0.2},
        SpindleLawCase{"feed_falls", "G1 Z-8", 8.0, per_min, 400, 0, 12.5, 200, 0, 2, -0.125},
        SpindleLawCase{"both_fall", "G1 Z-8", 8.0, per_min, 2500, 0, -20, 300, 0, 3, -0.1},
        SpindleLawCase{"fine_steps", "G1 Z-5", 5.0, per_min, 1000, 0, 0.1, 150, 0, 0.1, 0.001},
        SpindleLawCase{"no_step_fits", "G1 Z-2", 2.0, per_min, 700, 0, 50, 100, 0, 10, 3.0},
        SpindleLawCase{"step_at_the_end", "G1 Z-4", 4.0, per_min, 700, 0, 50, 100, 0, 10, 2.0},
        SpindleLawCase{"several_in_a_cycle", "G1 Z-6", 6.0, per_min, 500, 0, 1, 2400, 0, 0.1,
                       0.004},
        // By the ends.
        SpindleLawCase{"ends_rise", "G1 Z-10", 10.0, per_min, 600, 800, 0, 100, 180, 2, 0},
        SpindleLawCase{"ends_cross", "G1 Z-10", 10.0, per_min, 1200, 450, 0, 100, 160, 1.5, 0},
        SpindleLawCase{"ends_fall", "G1 Z-7", 7.0, per_min, 1500, 700, 0, 240, 120, 4, 0},
        SpindleLawCase{"dl_is_rounded_down", "G1 Z-7", 7.0, per_min, 600, 660, 0, 100, 130, 1, 0},
        SpindleLawCase{"ends_before_the_block", "G1 Z-12", 12.0, per_min, 600, 900, 0, 90, 120, 1.5,
                       0.3},
        SpindleLawCase{"block_ends_before", "G1 Z-4", 4.0, per_min, 600, 900, 0, 90, 150, 1, 0.2},
        SpindleLawCase{"feed_stays", "G1 Z-9", 9.0, per_min, 500, 950, 0, 120, 120, 1, 0.45},
        SpindleLawCase{"speed_stays", "G1 Z-6", 6.0, per_min, 800, 800, 0, 60, 90, 0.5, 0},
        SpindleLawCase{"taper", "G1 X52 Z-3", 5.0, per_min, 640, 1280, 0, 150, 75, 2.5, 0},
        SpindleLawCase{"facing", "G1 X20", 20.0, per_min, 500, 1500, 0, 180, 240, 3, 0},
        SpindleLawCase{"arc", "G2 X80 Z-10 R10", 5.0 * 3.14159265358979323846, per_min, 700, 1000,
                       0, 150, 210, 2, 0},
        // Per revolution, with the speed of the same place.
        SpindleLawCase{"rev_both_rise", "G1 Z-6", 6.0, per_rev, 600, 0, 10, 0.1, 0, 0.002, 0.25},
        SpindleLawCase{"rev_cross", "G1 Z-6", 6.0, per_rev, 1200, 0, -16, 0.08, 0, 0.003, 0.2},
        SpindleLawCase{"rev_ends", "G1 Z-9", 9.0, per_rev, 800, 1300, 0, 0.2, 0.1, 0.004, 0},
        SpindleLawCase{"rev_feed_stays", "G1 Z-5", 5.0, per_rev, 400, 640, 0, 0.15, 0.15, 0.001,
                       0.2},
        SpindleLawCase{"rev_taper", "G1 X52 Z-3", 5.0, per_rev, 900, 500, 0, 0.06, 0.16, 0.002, 0}),
    [](const auto& with) { return std::string(with.param.name); });

// The speed stays behind the law until another one is programmed.
TEST(SpindleLaw, LeavesTheSpindleAtItsLastSpeed) {
  MachineBench bench(testing::strong_lathe(10.0));
  bench.program("p.nc",
                "G0 X60 Z0\nG97 S600 M3\nG94 G1 Z-5 n_n=600 n_k=900 S_n=100 S_k=160 dS=2\n"
                "G95 G1 Z-8 F0.1\nS500\nZ-9\nM5\nM30\n");
  bench.run(1, "p.nc");
  double n_behind = 0.0;
  double n_anew = 0.0;
  bench.run_to_end([&](const CycleOutput& output) {
    const ChannelOutput& channel = output.channels[0];
    if (channel.tag.line == 4 && channel.moving) {
      n_behind = channel.process.spindle_rev_per_min;
      EXPECT_NEAR(channel.process.feed_mm_per_min, 90.0, 1e-9);
    }
    if (channel.tag.line == 6 && channel.moving) n_anew = channel.process.spindle_rev_per_min;
  });
  EXPECT_THAT(bench.alarm_codes(), ElementsAre());
  EXPECT_EQ(n_behind, 900.0);
  EXPECT_EQ(n_anew, 500.0);
}

// 500 - 100 k rev/min: the spindle would stand at the fifth increment, 2.5 mm on.
TEST(SpindleLaw, IsRefusedWhereItsSpeedComesToZero) {
  for (const char* law : {"n_n=500 dn=-100", "v_n=50 dv=-10"}) {
    SCOPED_TRACE(law);
    MachineBench bench(testing::strong_lathe(10.0));
    bench.program("p.nc", "G0 X60 Z0\nG97 S500 M3\nG94 G1 Z-1 F100\nZ-9 " + std::string(law) +
                              " S_n=100 dS=1 dl=0.5\nM30\n");
    bench.run(1, "p.nc");
    bench.run_to_end();
    EXPECT_THAT(bench.alarm_codes(), ElementsAre("E5106"));
    EXPECT_EQ(bench.channel(1).point_W[1].value, -1.0) << "the end of the block before";
    const auto alarms = bench.machine().alarms();
    ASSERT_EQ(alarms.size(), 1U);
    EXPECT_EQ(alarms[0].diagnostic.place.line, 4);
    EXPECT_THAT(alarms[0].diagnostic.message,
                ::testing::StartsWith("the speed of the law reaches 0 "));
    EXPECT_THAT(alarms[0].diagnostic.message,
                ::testing::EndsWith(" after 2.5 mm of its path of 8 mm"));
  }
}

// The driven tool has speeds of its own: neither they nor its stop concern the master spindle.
TEST(FeedPerRevolutionWithADrivenTool, IsThatOfTheMasterSpindle) {
  MachineConfig config = testing::strong_lathe(10.0);
  SpindleConfig driven_tool;
  driven_tool.id = 2;
  driven_tool.speed_max = 6000.0;
  config.spindles.push_back(driven_tool);
  config.channels[0].spindles = {1, 2};
  MachineBench bench(config);
  const auto cycles = testing::cycles_of_cut(
      bench, "G0 X60 Z0\nS600 M3\nS4000 $2 M3\nM5 $2\nG95 G1 Z-6 F0.2\nM5\nM30\n");
  CutTime wanted;
  wanted.add(6.0, 120.0);
  testing::expect_cut(cycles, wanted, FeedOf::revolution);
}

}  // namespace
}  // namespace stanok::channels
