// Probing moves, G38.2 to G38.5, on running programs: a surface at a known place of the machine.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/support/cycle.h"
#include "tests/support/machine/machine_bench.h"

namespace stanok::channels {
namespace {

using testing::cycle_s;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using testing::MachineBench;

constexpr int probe = 7;

MachineConfig mill_with_probe() {
  MachineConfig config = testing::two_channel_machine();
  config.channels[0].probe_input = probe;
  return config;
}

// The probe touches at and below a height of the machine.
class Touching {
 public:
  explicit Touching(MachineBench& bench, double surface) : bench_(bench), surface_(surface) {}

  void operator()(const CycleOutput& output) {
    const ChannelOutput& channel = output.channels[0];
    Signals inputs;
    inputs.set(probe, channel.axes[2].position <= surface_);
    bench_.inputs(inputs);
    lowest_ = std::min(lowest_, channel.axes[2].position);
    const double step = std::abs(channel.axes[2].acceleration);
    acceleration_ = std::max(acceleration_, step);
  }

  [[nodiscard]] double lowest() const { return lowest_; }
  [[nodiscard]] double acceleration() const { return acceleration_; }

 private:
  MachineBench& bench_;
  double surface_;
  double lowest_ = 1e9;
  double acceleration_ = 0.0;
};

MachineConfig mill_with_probe_in_table() {
  MachineConfig config = mill_with_probe();
  ToolEdge tool;
  tool.number = 9;
  tool.kind = "probe";
  tool.radius = 2.0;
  config.tables.tools.push_back(tool);
  tool.number = 1;
  tool.kind = "flat";
  config.tables.tools.push_back(tool);
  return config;
}

// By rapid, at feed, on an arc: the axes stop on their path, within what they need for it.
TEST(Probing, AMoveThatDoesNotProbeStopsWhereTheProbeMeetsSomething) {
  for (const char* const move : {"G0 Z-40", "G1 Z-40 F3000", "G18 G2 X40 Z-40 R40 F3000"}) {
    SCOPED_TRACE(move);
    MachineBench bench(mill_with_probe_in_table());
    bench.program("p.nc", std::string("T9 M6\nG0 Z10\n") + move + "\nM30\n");
    bench.run(1, "p.nc");
    Touching touching(bench, -10.0);
    bench.run_to_end([&](const CycleOutput& output) { touching(output); });
    EXPECT_THAT(bench.alarm_codes(), ElementsAre("E4326"));
    EXPECT_GT(touching.lowest(), -30.0);
  }
}

TEST(Probing, OtherToolsAndProbingMovesAreNotStopped) {
  for (const char* const program :
       {"T1 M6\nG1 Z-20 F1000\nG0 Z10\nM30\n", "T9 M6\nG38.2 Z-20 F300\nG0 Z10\nM30\n"}) {
    SCOPED_TRACE(program);
    MachineBench bench(mill_with_probe_in_table());
    bench.program("p.nc", program);
    bench.run(1, "p.nc");
    Touching touching(bench, -10.0);
    bench.run_to_end([&](const CycleOutput& output) { touching(output); });
    EXPECT_THAT(bench.alarm_codes(), IsEmpty());
  }
}

// A contact that opens bounces.
TEST(Probing, TheWayBackFromATouchIsFreeThoughTheContactBounces) {
  MachineBench bench(mill_with_probe_in_table());
  bench.program("p.nc", "T9 M6\nG38.2 Z-20 F300\nG0 Z10\nM30\n");
  bench.run(1, "p.nc");
  Touching touching(bench, -10.0);
  int cycles = 0;
  bool has_touched = false;
  bench.run_to_end([&](const CycleOutput& output) {
    touching(output);
    const double z = output.channels[0].axes[2].position;
    has_touched = has_touched || z <= -10.0;
    if (!has_touched || z <= -10.0 || z > -9.5) return;
    Signals inputs;
    inputs.set(probe, ++cycles % 7 < 3);
    bench.inputs(inputs);
  });
  EXPECT_THAT(bench.alarm_codes(), IsEmpty());
  EXPECT_GT(cycles, 20);
}

// The machine stands; the next jog is free.
TEST(Probing, AJogStopsWhereTheProbeMeetsSomething) {
  MachineBench bench(mill_with_probe_in_table());
  bench.ask(OperatorAction::mdi, 1, "T9 M6");
  bench.run_to_end();
  Touching touching(bench, -10.0);
  OperatorEvent event;
  event.channel = 1;
  event.command = commands::Jog{.axis = ShortText("Z"), .velocity = -20.0, .increment = 40.0};
  bench.ask(event);
  bench.run_to_end([&](const CycleOutput& output) { touching(output); });
  EXPECT_GT(touching.lowest(), -12.0);
  EXPECT_THAT(bench.event_codes(), ::testing::Contains("W733"));
  EXPECT_THAT(bench.alarm_codes(), IsEmpty());
  event.command = commands::Jog{.axis = ShortText("Z"), .velocity = 20.0, .increment = 5.0};
  bench.ask(event);
  bench.run_to_end();
  EXPECT_GT(bench.channel(1).axes[2].position, -8.0);
}

// The moves behind the probing one go to places made of what it found: they are what is measured.
TEST(Probing, FindsTheSurfaceInTheFrameOfTheProgramAndGoesOnFromWhereItStopped) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  for (int trial = 0; trial < 20; ++trial) {
    SCOPED_TRACE(trial);
    const double surface = -5.0 - 30.0 * part(random);
    const double feed = 60.0 + 2000.0 * part(random);  // mm/min
    MachineBench bench(mill_with_probe());
    bench.program("p.nc", "G52 Z3\nG0 Z0\nG38.2 Z-50 F" + std::to_string(feed) +
                              "\n"
                              "G0 X=$probe[Z] Z=$probe[Z]+10\nG91 G1 Y2 F600\nM30\n");
    bench.run(1, "p.nc");
    Touching watch(bench, surface);
    bench.run_to_end(std::ref(watch));
    ASSERT_THAT(bench.alarm_codes(), IsEmpty());
    const double travel_of_a_cycle = feed / 60.0 * cycle_s;
    const auto& axes = bench.channel(1).axes;
    EXPECT_LE(axes[0].position, surface - 3.0 + 1e-9);
    EXPECT_GE(axes[0].position, surface - 3.0 - travel_of_a_cycle - 1e-9);
    EXPECT_NEAR(axes[2].position, axes[0].position + 10.0 + 3.0, 1e-9);
    EXPECT_NEAR(axes[1].position, 2.0, 1e-9);
    // Down by the way to rest from the feed: v/2 times the time of a ramp with limited jerk.
    const double v = feed / 60.0;
    const double t = v > 2500.0 * 2500.0 / 50000.0 ? v / 2500.0 + 2500.0 / 50000.0
                                                   : 2.0 * std::sqrt(v / 50000.0);
    EXPECT_GE(watch.lowest(), surface - 0.5 * v * t - 3.0 * travel_of_a_cycle);
    EXPECT_LE(watch.acceleration(), 2500.0 * (1.0 + 1e-6));
  }
}

struct ProbingCase {
  const char* name;
  const char* program;
  double surface;
  std::vector<std::string> alarms;
  double end_X;  // 1: the program came to its end; 2: it saw that the probe was found
};

class ProbingCases : public ::testing::TestWithParam<ProbingCase> {};

TEST_P(ProbingCases, EndAsTheCodesSay) {
  const ProbingCase& one = GetParam();
  MachineBench bench(mill_with_probe());
  bench.program("p.nc", one.program);
  bench.run(1, "p.nc");
  Touching watch(bench, one.surface);
  bench.run_to_end(std::ref(watch));
  EXPECT_EQ(bench.alarm_codes(), one.alarms);
  EXPECT_NEAR(bench.channel(1).axes[0].position, one.end_X, 1e-9);
}

#define STANOK_SEEN "\nG0 X1\nif ($probe_ok) { G0 X2 }\nM30\n"

INSTANTIATE_TEST_SUITE_P(
    Codes, ProbingCases,
    ::testing::Values(
        ProbingCase{"missed_with_alarm", "G38.2 Z-10 F600" STANOK_SEEN, -20.0, {"E4320"}, 0.0},
        ProbingCase{"missed_without_alarm", "G38.3 Z-10 F600" STANOK_SEEN, -20.0, {}, 1.0},
        ProbingCase{"found_without_alarm", "G38.3 Z-10 F600" STANOK_SEEN, -5.0, {}, 2.0},
        ProbingCase{"found_in_exact_stop", "G61.1\nG38.2 Z-10 F600" STANOK_SEEN, -5.0, {}, 2.0},
        ProbingCase{"found_by_a_block_that_stops", "G9 G38.2 Z-10 F600" STANOK_SEEN, -5.0, {}, 2.0},
        ProbingCase{"touches_before", "G1 Z-6 F600\nG38.2 Z-10" STANOK_SEEN, -5.0, {"E4322"}, 0.0},
        ProbingCase{
            "touches_before_without_alarm", "G1 Z-6 F600\nG38.3 Z-10" STANOK_SEEN, -5.0, {}, 1.0},
        ProbingCase{"leaves", "G1 Z-6 F600\nG38.4 Z10" STANOK_SEEN, -5.0, {}, 2.0},
        ProbingCase{"never_leaves", "G1 Z-6 F600\nG38.4 Z-5.5" STANOK_SEEN, -5.0, {"E4320"}, 0.0},
        ProbingCase{"is_free_before", "G38.4 Z10 F600" STANOK_SEEN, -5.0, {"E4322"}, 0.0},
        ProbingCase{"is_free_before_without_alarm", "G38.5 Z10 F600" STANOK_SEEN, -5.0, {}, 1.0}),
    [](const auto& one) { return std::string(one.param.name); });

#undef STANOK_SEEN

// Without motion: the axes stand where they were, and the program counts from there.
TEST(Probing, WithoutAWayToGoTheProgramGoesOnFromWhereTheAxesStand) {
  MachineBench bench(mill_with_probe());
  bench.program("p.nc", "G1 Z-6 F600\nG38.3 Z-10\nG91 G1 Z1\nM30\n");
  bench.run(1, "p.nc");
  Touching watch(bench, -5.0);
  bench.run_to_end(std::ref(watch));
  EXPECT_NEAR(bench.channel(1).axes[2].position, -5.0, 1e-9);
  EXPECT_GE(watch.lowest(), -6.0 - 1e-9);
}

TEST(Probing, NeedsAProbe) {
  MachineBench bench;
  bench.program("p.nc", "G38.2 Z-10 F600\nM30\n");
  bench.run(1, "p.nc");
  bench.run_to_end();
  EXPECT_THAT(bench.alarm_codes(), ElementsAre("E4323"));
}

// P2 is the first of skip_inputs: the probe of P1 touches earlier and is not what ends the move.
TEST(Probing, WatchesTheInputOfItsP) {
  constexpr int other = 3;
  MachineConfig config = mill_with_probe();
  config.channels[0].skip_inputs = {other};
  MachineBench bench(config);
  bench.program("p.nc", "G31 P2 Z-30 F600\nG0 X=$probe[Z]\nM30\n");
  bench.run(1, "p.nc");
  bench.run_to_end([&](const CycleOutput& output) {
    Signals inputs;
    inputs.set(probe, output.channels[0].axes[2].position <= -5.0);
    inputs.set(other, output.channels[0].axes[2].position <= -12.0);
    bench.inputs(inputs);
  });
  EXPECT_THAT(bench.alarm_codes(), IsEmpty());
  EXPECT_NEAR(bench.channel(1).axes[0].position, -12.0, 10.0 * cycle_s + 1e-9);

  bench.program("none.nc", "G31 P3 Z-40 F600\nM30\n");
  bench.run(1, "none.nc");
  bench.run_to_end();
  EXPECT_THAT(bench.alarm_codes(), ElementsAre("E4323"));
}

// A hold and a resume on the way, and a reset: the probe is looked at all the same, or forgotten.
TEST(Probing, SurvivesHoldAndReset) {
  MachineBench bench(mill_with_probe());
  bench.program("p.nc", "G38.2 Z-30 F1200\nG0 X=$probe[Z]\nM30\n");
  bench.run(1, "p.nc");
  Touching watch(bench, -12.0);
  for (int k = 0; k < 300; ++k) watch(bench.cycle());
  bench.ask(OperatorAction::program_hold, 1);
  for (int k = 0; k < 200; ++k) watch(bench.cycle());
  bench.ask(OperatorAction::program_resume, 1);
  bench.run_to_end(std::ref(watch));
  EXPECT_THAT(bench.alarm_codes(), IsEmpty());
  EXPECT_NEAR(bench.channel(1).axes[0].position, -12.0, 20.0 * cycle_s);

  bench.program("free.nc", "G0 Z0\nG38.2 Z-30 F1200\nM30\n");
  bench.run(1, "free.nc");
  for (int k = 0; k < 400; ++k) watch(bench.cycle());
  bench.ask(OperatorAction::program_reset, 1);
  bench.run_to_end(std::ref(watch));
  bench.program("line.nc", "G0 Z0\nG1 Z-20 F3000\nM30\n");
  bench.run(1, "line.nc");
  bench.run_to_end(std::ref(watch));
  EXPECT_NEAR(bench.channel(1).axes[2].position, -20.0, 1e-9);
}

}  // namespace
}  // namespace stanok::channels
