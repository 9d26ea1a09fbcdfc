// Block search on the machine: a program that begins at a block stands as if it had come there.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <random>
#include <sstream>

#include "channels/machine/machine.h"
#include "lang/run/block_search.h"
#include "tests/support/machine/machine_bench.h"
#include "tests/support/sanitized.h"

namespace stanok::channels {
namespace {

using ::testing::DoubleNear;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::MachineBench;
using ::testing::Pointwise;
using ::testing::StartsWith;

constexpr double place_tolerance = 1e-9;

class ProgramSearchTest : public ::testing::Test {
 protected:
  void load(const std::string& text) {
    bench.program("p.nc", text);
    bench.ask(OperatorAction::program_load, 1, "p.nc");
    bench.run_to_end();
  }
  // Empty: found; else what the operator reads.
  std::string search(const std::string& target, double pass = 1.0, bool calculates = true) {
    const std::size_t before = bench.replies().size();
    bench.ask(OperatorAction::program_search, 1, target, pass, calculates ? 0 : 1);
    bench.run_to_end();
    EXPECT_EQ(bench.replies().size(), before + 1);
    const OperatorReply& reply = bench.replies().back();
    return reply.ok ? "" : std::string(reply.code.view()) + std::string(reply.text.view());
  }
  void start(const std::function<void(const CycleOutput&)>& watch = {}) {
    bench.ask(OperatorAction::program_start, 1);
    bench.run_to_end(watch);
  }
  std::vector<double> stands() {
    const auto& axes = bench.channel(1).axes;
    return {axes[0].position, axes[1].position, axes[2].position};
  }

  MachineBench bench;
};

constexpr const char* pocket =
    "G21 G90 G54\n"    // 1
    "T1 M6\n"          // 2
    "S1000 M3\n"       // 3
    "M8\n"             // 4
    "G0 X10 Y10 Z5\n"  // 5
    "G1 Z-1 F600\n"    // 6
    "N70 X50\n"        // 7
    "N80 Y40\n"        // 8
    "G0 Z20\n"         // 9
    "M30\n";           // 10

// Words as they are read at the block that is found: diameters of a lathe, mm also under G20.
TEST(ProgramSearchOfALathe, TellsWordsAndThePoint) {
  MachineBench bench(testing::turning_machine());
  bench.program("p.nc", "G7 G21 G90 G54\nG0 X40 Z5\nN30 X2\nG20\nN50 X1\nM30\n");
  bench.ask(OperatorAction::program_load, 1, "p.nc");
  bench.run_to_end();
  bench.ask(OperatorAction::program_search, 1, "N30", 1.0, 0);
  bench.run_to_end();
  auto report = bench.machine().search(1);
  ASSERT_TRUE(report);
  EXPECT_NEAR(report->position.at(testing::lathe_X), 40.0, place_tolerance);
  EXPECT_NEAR(report->point_W.at(testing::lathe_X), 20.0, place_tolerance);
  EXPECT_TRUE(report->meaning.is_diameter(testing::lathe_X));
  EXPECT_FALSE(report->meaning.inches());
  bench.ask(OperatorAction::program_search, 1, "N50", 1.0, 0);
  bench.run_to_end();
  report = bench.machine().search(1);
  ASSERT_TRUE(report);
  EXPECT_NEAR(report->position.at(testing::lathe_X), 2.0, place_tolerance);
  EXPECT_TRUE(report->meaning.inches());
}

TEST_F(ProgramSearchTest, TellsWhatLiesBeforeTheBlock) {
  load(pocket);
  ASSERT_EQ(search("N80"), "");
  const auto report = bench.machine().search(1);
  ASSERT_TRUE(report);
  EXPECT_EQ(report->file, "p.nc");
  EXPECT_EQ(report->line, 8u);
  EXPECT_THAT(report->position,
              Pointwise(DoubleNear(place_tolerance), {50.0, 10.0, -1.0, 0.0, 0.0}));
  EXPECT_THAT(report->stands_at, Pointwise(DoubleNear(place_tolerance), {0.0, 0.0, 0.0, 0.0, 0.0}));
  EXPECT_EQ(report->state.tool, 1);
  EXPECT_EQ(report->state.speeds.at(0), 1000.0);
  EXPECT_EQ(report->state.spindles.at(0).action, lang::SpindleAction::clockwise);
  EXPECT_TRUE(report->state.coolant.flood);
  EXPECT_THAT(stands(), Pointwise(DoubleNear(0.0), {0.0, 0.0, 0.0})) << "nothing has moved";
}

// Line by line of the way to a block: Z where X and Y move, and the order.
TEST_F(ProgramSearchTest, TheToolIsLiftedThenChangedThenComesDownAtFeed) {
  load(pocket);
  bench.ask(OperatorAction::mdi, 1, "G0 X-60 Y-40 Z-5");
  bench.run_to_end();
  ASSERT_EQ(search("8"), "");
  double lowest_aside = 100.0;    // Z while X and Y move
  double z_of_the_tool = -100.0;  // where the tool is changed
  double fastest_down = 0.0;
  bool spindle_turned_first = true;
  bool has_been_down = false;
  start([&](const CycleOutput& output) {
    const ChannelOutput& channel = output.channels[0];
    const double x = channel.axes[0].position;
    const double z = channel.axes[2].position;
    if (channel.tool.number == 1 && z_of_the_tool == -100.0) z_of_the_tool = z;
    const bool moves_aside = std::abs(channel.axes[0].velocity) > 1e-9;
    if (moves_aside && !has_been_down) lowest_aside = std::min(lowest_aside, z);
    spindle_turned_first &=
        x < -60.0 + place_tolerance || has_been_down || channel.process.spindle_rev_per_min > 0.0;
    if (x > 49.0 && !has_been_down)
      fastest_down = std::max(fastest_down, -channel.axes[2].velocity);
    has_been_down = has_been_down || (x > 49.0 && z < -1.0 + place_tolerance);
  });
  EXPECT_TRUE(has_been_down);
  EXPECT_TRUE(spindle_turned_first);
  EXPECT_NEAR(lowest_aside, 5.0, place_tolerance) << "the height of G0 Z5 in line 5";
  EXPECT_NEAR(z_of_the_tool, 5.0, place_tolerance) << "not in the depth";
  EXPECT_LE(fastest_down, 600.0 / 60.0 + 1e-9) << "F600 of line 6";
  EXPECT_THAT(stands(), Pointwise(DoubleNear(place_tolerance), {50.0, 40.0, 20.0}));
  EXPECT_THAT(bench.alarm_codes(), IsEmpty());
  EXPECT_FALSE(bench.machine().search(1)) << "the next start begins at the first block";
}

// What a search tells of the way, in words.
TEST_F(ProgramSearchTest, TellsTheApproach) {
  load(pocket);
  bench.ask(OperatorAction::mdi, 1, "G0 X-60 Y-40 Z-5");
  bench.run_to_end();
  ASSERT_EQ(search("8"), "");
  const auto report = bench.machine().search(1);
  using Kind = SearchReport::Leg::Kind;
  ASSERT_EQ(report->approach.size(), 3U);
  EXPECT_EQ(report->approach[0].kind, Kind::lift);
  EXPECT_NEAR(report->approach[0].length_mm, 10.0, place_tolerance);
  EXPECT_EQ(report->approach[1].kind, Kind::lateral);
  EXPECT_THAT(report->approach[1].end,
              Pointwise(DoubleNear(place_tolerance), {50.0, 10.0, 5.0, 0.0, 0.0}));
  EXPECT_EQ(report->approach[2].kind, Kind::plunge);
  EXPECT_NEAR(report->approach[2].length_mm, 6.0, place_tolerance);
  EXPECT_EQ(report->plunge_feed_mm_min, 600.0);
  const std::uint32_t number = report->number;
  ASSERT_EQ(search("8"), "");
  EXPECT_GT(bench.machine().search(1)->number, number);
}

// Seeded: over all that was skipped since the last tool change, arcs in XZ included, the tool goes
// sideways no deeper than it ever was, or than it starts or ends.
TEST(ProgramSearchProperties, TheWayAsideIsAsHighAsTheToolEverWas) {
  for (unsigned seed = 1; seed <= stanok::testing::cases(20U); ++seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> place(-40.0, 40.0);
    std::ostringstream text;
    text << "G21 G90 G18\nT1 M6\nF3000\n";
    double highest = -1e9;
    for (int n = 0; n < 12; ++n) {
      const double z = place(random);
      const double radius = 1.0 + std::abs(place(random)) / 8.0;
      if (n % 3 == 2) {  // a full circle that begins at its lowest point
        text << "G2 I0 K" << radius << "\n";
        continue;
      }
      text << "G1 X" << place(random) << " Y" << place(random) << " Z" << z << "\n";
    }
    text << "G1 X7 Y8 Z-30\nM30\n";
    MachineBench whole;
    whole.program("p.nc", text.str());
    whole.run(1, "p.nc");
    bool has_tool = false;
    whole.run_to_end([&](const CycleOutput& output) {
      const ChannelOutput& channel = output.channels[0];
      has_tool = has_tool || (channel.tool.number == 1 && channel.tag.line > 3);
      if (has_tool && channel.tag.line < 16) highest = std::max(highest, channel.axes[2].position);
    });
    ASSERT_THAT(whole.alarm_codes(), IsEmpty()) << text.str();
    MachineBench bench;
    bench.program("p.nc", text.str());
    bench.ask(OperatorAction::mdi, 1, "G0 X-50 Y-50 Z-45");
    bench.run_to_end();
    bench.ask(OperatorAction::program_load, 1, "p.nc");
    bench.run_to_end();
    bench.ask(OperatorAction::program_search, 1, "16");
    bench.run_to_end();
    ASSERT_TRUE(bench.machine().search(1)) << text.str();
    bench.ask(OperatorAction::program_start, 1);
    double lowest_aside = 1e9;
    bool comes_down = false;
    bench.run_to_end([&](const CycleOutput& output) {
      const auto& axes = output.channels[0].axes;
      const bool aside = std::abs(axes[0].velocity) > 1e-6 || std::abs(axes[1].velocity) > 1e-6;
      comes_down = comes_down || (!aside && axes[2].velocity < -1e-6);
      if (aside && !comes_down) lowest_aside = std::min(lowest_aside, axes[2].position);
    });
    EXPECT_GE(lowest_aside, highest - 1e-6) << "seed " << seed << '\n' << text.str();
  }
}

// Nothing is known of the way of a tool that was only changed: up to the end of the axis.
TEST_F(ProgramSearchTest, WithoutAWayBeforeTheToolGoesToTheTop) {
  load("G21 G90\nG0 X10 Y10 Z-3\nT1 M6\nX20\nM30\n");
  ASSERT_EQ(search("4"), "");
  const auto report = bench.machine().search(1);
  ASSERT_FALSE(report->approach.empty());
  EXPECT_EQ(report->approach[0].end[2], testing::two_channel_machine().axes[2].limits.position_max);
}

// The tip led by head and table: out of the workpiece and into it along the tool.
TEST_F(ProgramSearchTest, ATurnedToolComesDownAlongItself) {
  bench.program("k.nc", "#kinematics (2, 1)\nG0 X0 Y0 Z250 B0 C0\nM30\n");
  bench.run(1, "k.nc");
  bench.run_to_end();
  load("G21 G90 G54\nG43.4 H0\nG0 X0 Y0 Z50 B30 C20\nG1 X10 Y5 Z0 F1200\nN50 X20\nM0\nM30\n");
  ASSERT_EQ(search("N50"), "");
  const double b = std::numbers::pi / 6.0;
  const double c = std::numbers::pi / 9.0;
  // The tool seen from the table: Rz(C)^T Ry(B) z.
  const std::array<double, 3> tool{std::sin(b) * std::cos(c), -std::sin(b) * std::sin(c),
                                   std::cos(b)};
  const auto report = bench.machine().search(1);
  ASSERT_TRUE(report);
  ASSERT_EQ(report->approach.size(), 2U);
  const double rise = 50.0 / tool[2];
  EXPECT_THAT(
      report->approach[0].end,
      Pointwise(DoubleNear(1e-9), {10.0 + rise * tool[0], 5.0 + rise * tool[1], 50.0, 30.0, 20.0}));
  EXPECT_NEAR(report->approach[1].length_mm, rise, 1e-9);
  double off = 0.0;
  int cycles = 0;
  start([&](const CycleOutput& output) {
    const auto& axes = output.channels[0].axes;
    const double x = axes[0].position - 200.0 * std::sin(b);
    const double y = axes[1].position;
    const std::array<double, 3> from_target{std::cos(c) * x + std::sin(c) * y - 10.0,
                                            -std::sin(c) * x + std::cos(c) * y - 5.0,
                                            axes[2].position - 200.0 * std::cos(b)};
    const bool plunges = output.channels[0].tag.line == 5 && from_target[2] > 1e-6 &&
                         from_target[2] < 50.0 - 1e-6 && axes[3].position == 30.0;
    if (!plunges || axes[2].velocity >= 0.0) return;
    ++cycles;
    for (std::size_t k = 0; k < 3; ++k)
      off = std::max(off, std::abs(from_target[k] - from_target[2] / tool[2] * tool[k]));
  });
  EXPECT_THAT(bench.alarm_codes(), IsEmpty());
  EXPECT_GT(cycles, 1000) << "57.7 mm at F1200";
  EXPECT_LT(off, 1e-9);
}

// A tool that lies flat, and one whose way out would leave the travel, come straight down.
TEST_F(ProgramSearchTest, AFlatToolComesStraightDown) {
  bench.program("k.nc", "#kinematics (2, 1)\nG0 X0 Y0 Z250 B0 C0\nM30\n");
  bench.run(1, "k.nc");
  bench.run_to_end();
  for (const char* pose : {"X0 Y0 B85", "X290 Y0 B75"}) {
    load("G21 G90 G54\nG43.4 H0\nG0 " + std::string(pose) + " Z50 C0\nG1 Z0 F1200\nN50 Y5\nM30\n");
    ASSERT_EQ(search("N50"), "") << pose;
    const auto report = bench.machine().search(1);
    ASSERT_TRUE(report);
    ASSERT_EQ(report->approach.size(), 2U) << pose;
    EXPECT_NEAR(report->approach[1].length_mm, 50.0, 1e-9) << pose;
  }
}

// Between search and start the operator jogs, enters lines, measures.
TEST_F(ProgramSearchTest, HoldsAfterLinesOfTheOperator) {
  load(pocket);
  ASSERT_EQ(search("8"), "");
  bench.ask(OperatorAction::mdi, 1, "G0 X-20 Z30");
  bench.run_to_end();
  double least_y = 100.0;
  start([&](const CycleOutput& output) {
    if (output.channels[0].tag.line >= 8)
      least_y = std::min(least_y, output.channels[0].axes[1].position);
  });
  EXPECT_THAT(stands(), Pointwise(DoubleNear(place_tolerance), {50.0, 40.0, 20.0}));
}

TEST_F(ProgramSearchTest, ResetAndLoadForgetIt) {
  load(pocket);
  ASSERT_EQ(search("8"), "");
  bench.ask(OperatorAction::program_reset, 1);
  bench.run_to_end();
  EXPECT_FALSE(bench.machine().search(1));
  ASSERT_EQ(search("8"), "");
  load(pocket);
  EXPECT_FALSE(bench.machine().search(1));
  bool has_begun_at_first = false;
  start([&](const CycleOutput& output) {
    has_begun_at_first = has_begun_at_first || output.channels[0].tag.line == 5;
  });
  EXPECT_TRUE(has_begun_at_first);
}

TEST_F(ProgramSearchTest, FindsThePassOfALoop) {
  load(
      "num turn = 0;\n"
      "while (turn < 5) {\n"
      "  turn += 1;\n"
      "  G1 X=turn F6000\n"
      "  Y=turn\n"
      "}\n"
      "M30\n");
  ASSERT_EQ(search("5", 4.0), "");
  EXPECT_THAT(bench.machine().search(1)->position,
              Pointwise(DoubleNear(place_tolerance), {4.0, 3.0, 0.0, 0.0, 0.0}));
  start();
  EXPECT_THAT(stands(), Pointwise(DoubleNear(place_tolerance), {5.0, 5.0, 0.0}));
}

TEST_F(ProgramSearchTest, WithoutCalculationTheDefaultStateHolds) {
  load("G91\nG0 X10\nG0 X10\nM30\n");
  ASSERT_EQ(search("3", 1.0, false), "");
  bench.ask(OperatorAction::mdi, 1, "G0 X3");
  bench.run_to_end();
  start();
  EXPECT_NEAR(stands()[0], 10.0, place_tolerance) << "G90: the default state";
}

TEST_F(ProgramSearchTest, FramesAndToolLengthsAreThoseOfTheBlock) {
  load("G0 X1\nG52 X100\nG43.1 Z7\nG0 X1 Y1\nG68 X0 Y0 R90\nG1 X5 Y0 F6000\nX6\nM30\n");
  ASSERT_EQ(search("7"), "");
  start();
  const std::vector<double> searched = stands();
  bench.run(1, "p.nc");
  bench.run_to_end();
  EXPECT_THAT(searched, Pointwise(DoubleNear(place_tolerance), stands()));
}

TEST_F(ProgramSearchTest, AMarkAndAChannelFunctionAreNotExecuted) {
  load("mark_wait (3, 1, 2);\nchannel_run (2, \"none.nc\");\nG0 X5\nX6\nM30\n");
  ASSERT_EQ(search("4"), "");
  const auto report = bench.machine().search(1);
  std::map<std::string, int> counts;
  for (const auto& omission : report->state.omissions) counts[omission.what] = omission.count;
  EXPECT_EQ(counts["channel functions"], 1);
  start();
  EXPECT_NEAR(stands()[0], 6.0, place_tolerance);
  EXPECT_THAT(bench.alarm_codes(), IsEmpty());
}

struct Refusal {
  const char* name;
  const char* program;
  const char* target;
  const char* code;
  const char* word;
};

class ProgramSearchRefusal : public ProgramSearchTest,
                             public ::testing::WithParamInterface<Refusal> {};

TEST_P(ProgramSearchRefusal, IsToldAndLeavesTheMachineAsItWas) {
  const Refusal& refusal = GetParam();
  load(refusal.program);
  const std::string told = search(refusal.target);
  EXPECT_THAT(told, StartsWith(refusal.code));
  EXPECT_THAT(told, HasSubstr(refusal.word));
  EXPECT_EQ(bench.channel(1).state, ChannelState::ready);
  EXPECT_FALSE(bench.machine().search(1));
  EXPECT_THAT(bench.alarm_codes(), IsEmpty());
}

INSTANTIATE_TEST_SUITE_P(
    Searches, ProgramSearchRefusal,
    ::testing::Values(
        Refusal{"NoTarget", "G0 X1\nM30\n", "first", "E6040", "first"},
        Refusal{"NoSuchBlock", "G0 X1\nM30\n", "N9", "E6040", "N9"},
        Refusal{"TwiceTheBlock", "N1 G0 X1\nN1 X2\nM30\n", "N1", "E6040", "more than once"},
        Refusal{"BehindTheEnd", "G0 X1\nM30\n", "40", "E6040", "40"},
        Refusal{"NeverReached", "G0 X1\nif (1 > 2) {\n  X2\n}\nM30\n", "3", "E6041", "line 3"},
        Refusal{"AnInput", "G0 X0\nif ($in[1]) {\n  G0 X1\n}\nG0 X2\nM30\n", "5", "E6041",
                "p.nc:2"},
        Refusal{"OtherKinematics", "#kinematics (2, 1)\nG0 X1\nX2\nM30\n", "3", "E6043",
                "scheme 2"},
        Refusal{"NoSuchFile", "G0 X1\nM30\n", "sub.nc:3", "E6040", "sub.nc"}),
    [](const auto& refusal) { return refusal.param.name; });

TEST_F(ProgramSearchTest, NeedsALoadedProgramAndAChannelAtRest) {
  EXPECT_THAT(search("1"), StartsWith("E6005"));
  load("G1 X100 F600\nM30\n");
  bench.ask(OperatorAction::program_start, 1);
  for (int n = 0; n < 50; ++n) bench.cycle();
  EXPECT_THAT(search("2"), StartsWith("E6003"));
}

// Random programs of lines, arcs, shifts and spindle commands: from any line on they go where the
// whole program goes.
class RandomProgram {
 public:
  explicit RandomProgram(unsigned seed) : random_(seed) {
    line("G21 G90 G17");
    for (int n = 0; n < 25; ++n) add();
    line("M30");
  }
  [[nodiscard]] std::string text() const { return text_.str(); }
  [[nodiscard]] int lines() const { return lines_; }

 private:
  double coordinate() { return std::uniform_int_distribution(-400, 400)(random_) * 0.1; }
  void line(const std::string& words) {
    text_ << words << '\n';
    ++lines_;
  }
  void add() {
    std::ostringstream words;
    switch (std::uniform_int_distribution(0, 7)(random_)) {
      case 0:
        words << "G0 X" << coordinate() << " Z" << coordinate();
        break;
      case 1:
        words << "G52 X" << coordinate() << " Y" << coordinate();
        break;
      case 2:
        words << "S" << std::uniform_int_distribution(100, 2000)(random_) << " M3";
        break;
      case 3:
        words << "G43.1 Z" << coordinate();
        break;
      case 4:
        words << "G91 G1 X1.5 Y-0.5 F3000";
        break;
      case 5:
        words << "G2 I2 J0 F2000";
        break;
      default:
        words << "G90 G1 X" << coordinate() << " Y" << coordinate() << " F4000";
    }
    line(words.str());
  }

  std::mt19937 random_;
  std::ostringstream text_;
  int lines_ = 0;
};

TEST(ProgramSearchProperties, FromAnyLineTheProgramGoesWhereItWouldGo) {
  for (unsigned seed = 1; seed <= stanok::testing::cases(12U); ++seed) {
    const RandomProgram program(seed);
    // The last place at each line.
    const auto trace = [&](int from) {
      MachineBench bench;
      bench.program("p.nc", program.text());
      bench.ask(OperatorAction::program_load, 1, "p.nc");
      bench.run_to_end();
      if (from > 1) bench.ask(OperatorAction::program_search, 1, std::to_string(from));
      bench.run_to_end();
      bench.ask(OperatorAction::program_start, 1);
      std::map<std::uint32_t, std::vector<double>> places;
      // It plunges from the end of Z where nothing that was skipped tells a height.
      constexpr int cycles_max = 1'000'000;
      bench.run_to_end(
          [&](const CycleOutput& output) {
            const ChannelOutput& channel = output.channels[0];
            places[channel.tag.line] = {channel.axes[0].position, channel.axes[1].position,
                                        channel.axes[2].position,
                                        channel.process.spindle_rev_per_min};
          },
          cycles_max);
      EXPECT_THAT(bench.alarm_codes(), IsEmpty()) << program.text() << from;
      return places;
    };
    const auto whole = trace(1);
    std::mt19937 random(seed);
    const int from = std::uniform_int_distribution(2, program.lines() - 1)(random);
    const auto searched = trace(from);
    ASSERT_FALSE(searched.empty());
    EXPECT_THAT(searched.rbegin()->second, Pointwise(DoubleNear(1e-6), whole.rbegin()->second))
        << "seed " << seed << " from line " << from << '\n'
        << program.text();
  }
}

}  // namespace
}  // namespace stanok::channels
