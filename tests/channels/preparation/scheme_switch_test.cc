// A change of kinematics with drives that do, or do not do, what they are told; and random
// sequences of changes, spindle axes, moves, holds and resets.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "channels/machine/machine.h"
#include "tests/support/machine/machine_bench.h"

namespace stanok::channels {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::MachineBench;

constexpr std::size_t mill_B = 3;
constexpr std::size_t mill_C = 4;

// Drives that obey at once, but for those that are told not to.
class SchemeSwitchTest : public ::testing::Test {
 protected:
  SchemeSwitchTest() {
    MachineConfig config = testing::two_channel_machine();
    config.channels[0].schemes[0].zero = {-300.0, -40.0, -100.0};
    std::get<kinematics::HeadTable::Geometry>(config.channels[0].schemes[1].geometry)
        .table_centre = {0.0, 0.0, -350.0};
    config.channels[0].schemes[1].zero = {0.0, 0.0, -150.0};  // table centre - pivot to spindle
    bench = std::make_unique<MachineBench>(config);
    drives.resize(5);
    for (AxisFeedback& drive : drives) drive = {.valid = true, .enabled = true, .referenced = true};
  }
  void cycle() {
    bench->feedback(drives);
    const ChannelOutput& channel = bench->cycle().channels[0];
    for (std::size_t k = 0; k < drives.size(); ++k) {
      drives[k].position = drives[k].setpoint = channel.axes[k].position;
      drives[k].enabled = channel.drives[k].enabled && !dead[k];
      drives[k].brake_closed = channel.drives[k].brake_closed && !stuck_open[k];
    }
  }
  void to_end(int cycles_max = 60000) {
    cycle();
    for (int n = 0; n < cycles_max && !bench->machine().waits_for_operator(); ++n) cycle();
    EXPECT_TRUE(bench->machine().waits_for_operator());
  }
  void run(const std::string& text, int channel = 1) {
    const std::string name = "p" + std::to_string(channel) + ".nc";
    bench->program(name, text);
    bench->run(channel, name);
    to_end();
  }
  [[nodiscard]] std::string alarm() {
    const auto alarms = bench->machine().alarms();
    return alarms.empty() ? ""
                          : alarms.back().diagnostic.code + " " + alarms.back().diagnostic.message;
  }
  void reset() {
    bench->ask(OperatorAction::program_reset, 1);
    to_end();
  }

  std::unique_ptr<MachineBench> bench;
  std::vector<AxisFeedback> drives;
  std::array<bool, 5> dead{};
  std::array<bool, 5> stuck_open{};
};

TEST_F(SchemeSwitchTest, BrakesAndReleasesWhatLeavesAndJoins) {
  run("#kinematics (2, 1)\nG0 B10 C20\n#kinematics (1, 1)\nM30\n");
  EXPECT_EQ(alarm(), "");
  const ChannelOutput& channel = bench->channel(1);
  EXPECT_EQ(channel.scheme, 1);
  for (const std::size_t axis : {mill_B, mill_C}) {
    EXPECT_EQ(channel.axes[axis].position, 0.0);
    EXPECT_TRUE(channel.drives[axis].brake_closed);
    EXPECT_FALSE(channel.drives[axis].enabled);
  }
}

TEST_F(SchemeSwitchTest, StaysWithTheOldSchemeWhenADriveDoesNotSwitchOn) {
  dead[mill_C] = true;
  run("#kinematics (2, 1)\nG0 C20\nM30\n");
  EXPECT_THAT(bench->alarm_codes(), ElementsAre("E5205"));
  EXPECT_THAT(alarm(), HasSubstr("the drive of axis C does not switch on"));
  EXPECT_EQ(bench->channel(1).scheme, 1);
  EXPECT_TRUE(bench->channel(1).drives[mill_B].brake_closed);
  EXPECT_TRUE(bench->channel(1).drives[mill_C].brake_closed);
  dead[mill_C] = false;
  reset();
  run("#kinematics (2, 1)\nG0 C20\nM30\n");
  EXPECT_EQ(bench->channel(1).scheme, 2);
  EXPECT_EQ(bench->channel(1).axes[mill_C].position, 20.0);
}

TEST_F(SchemeSwitchTest, StaysWithTheOldSchemeWhenABrakeDoesNotClose) {
  run("#kinematics (2, 1)\nG0 B10 C20\nM30\n");
  stuck_open[mill_C] = true;
  run("#kinematics (1, 1)\nM30\n");
  EXPECT_THAT(alarm(), HasSubstr("E5205 the brake of axis C does not close"));
  EXPECT_EQ(bench->channel(1).scheme, 2);
  // What was moved stays where it is, braked.
  EXPECT_EQ(bench->channel(1).axes[mill_B].position, 0.0);
  EXPECT_TRUE(bench->channel(1).drives[mill_B].brake_closed);
  EXPECT_TRUE(bench->channel(1).drives[mill_C].brake_closed);
  stuck_open[mill_C] = false;
  reset();
  run("G0 B5\nM30\n");  // the old scheme goes on
  EXPECT_EQ(bench->channel(1).axes[mill_B].position, 5.0);
}

TEST_F(SchemeSwitchTest, FailsTheMasterThatAskedForIt) {
  dead[mill_B] = true;
  run("#kinematics (2, 1)\nM30\n", 2);
  EXPECT_THAT(alarm(), HasSubstr("E5205 the drive of axis B does not switch on"));
  EXPECT_EQ(bench->channel(1).scheme, 1);
  EXPECT_EQ(bench->channel(2).state, ChannelState::alarm);
}

TEST_F(SchemeSwitchTest, NeedsAxesThatAreHomed) {
  drives[mill_B].referenced = false;
  run("#kinematics (2, 1)\nM30\n");
  EXPECT_THAT(alarm(), HasSubstr("axis B is not homed"));
  reset();
  bench->ask(OperatorAction::kinematics_select, 1, "", 0.0, 2);
  to_end();
  EXPECT_EQ(bench->replies().back().code.view(), "E5208");
}

TEST_F(SchemeSwitchTest, TheSamePoseIsTheSameTipInBothSchemes) {
  // The bases lie at (-300, -40, -100) and, with the head upright, at (0, 0, -150) of M.
  run("G0 X310 Y55 Z-20\n"
      "num at_x = $pos[X];\nnum at_y = $pos[Y];\nnum at_z = $pos[Z];\n"
      "#kinematics (2, 1)\n"
      "if (abs (at_x - 300 - $pos[X]) > 0.001 || abs (at_y - 40 - $pos[Y]) > 0.001\n"
      "    || abs (at_z - 100 + 150 - $pos[Z]) > 0.001) { terminate (1001, \"moved\"); }\n"
      "G43.4 H0\n"
      "if (abs (at_x - 300 - $pos[X]) > 0.001 || abs (at_z - 100 + 150 - $pos[Z]) > 0.001)\n"
      "  { terminate (1002, \"moved by TCP\"); }\nM30\n");
  EXPECT_EQ(alarm(), "");
}

TEST_F(SchemeSwitchTest, ParkedAxesCannotBeProgrammed) {
  run("G0 B5\nM30\n");
  EXPECT_THAT(alarm(), HasSubstr("E5102 axis B is not part of scheme 1"));
  EXPECT_EQ(bench->channel(1).axes[mill_B].position, 0.0);
}

// One line of a random program: a change, a spindle axis, a move. Many of them are refused.
class Sequences {
 public:
  explicit Sequences(unsigned seed) : engine_(seed) {}

  std::string program(bool has_spindle_axis) {
    std::string text = "G94 G90 F3000\n";
    const int lines = pick(2, 8);
    for (int n = 0; n < lines; ++n) text += line(has_spindle_axis);
    return text + "M30\n";
  }
  int pick(int least, int most) { return std::uniform_int_distribution<int>(least, most)(engine_); }

 private:
  std::string line(bool has_spindle_axis) {
    const std::string value = std::to_string(pick(-90, 90));
    switch (pick(0, 8)) {
      case 0:
      case 1:
        return "#kinematics (" + std::to_string(pick(0, 15) == 0 ? 3 : pick(1, 2)) + ", 1)\n";
      case 2:
        return "#kinematics (" + std::to_string(pick(1, 2)) + ", 2)\n";
      case 3:
        return "G0 X" + value + "\n";
      case 4:
        return "G1 C" + value + "\n";
      case 5:
        return has_spindle_axis ? "M902\n" : "G1 X" + value + " C" + value + "\n";
      case 6:
        return has_spindle_axis ? "M903\n" : "G4 P0.05\n";
      case 7:
        return has_spindle_axis ? "S" + std::to_string(pick(10, 300)) + " M3\n" : "G0 X0\n";
      default:
        return "M5\n";
    }
  }

  std::mt19937 engine_;
};

// Channels 1 and 2 with an axis X each and a shared axis A; channel 1 has a spindle that becomes C.
MachineConfig two_sided_machine() {
  MachineConfig machine = testing::machine_with_a_shared_axis();
  AxisConfig spindle_axis = machine.axes[2];
  spindle_axis.name = "C1";
  machine.axes.push_back(spindle_axis);
  SpindleConfig spindle;
  spindle.speed_max = 300.0;
  spindle.acceleration = 1000.0;
  spindle.axis = "C1";
  machine.spindles = {spindle};
  ChannelConfig& first = machine.channels[0];
  first.axes = {0, 2, 3};
  first.words = {"X", "A", "C"};
  first.spindles = {1};
  for (kinematics::SchemeConfig& scheme : first.schemes) scheme.axes.push_back(2);
  return machine;
}

// Every cycle of the two-sided machine: steps within the limits, one shared axis for both.
class Watch {
 public:
  void look(const CycleOutput& output) {
    for (std::size_t c = 0; c < 2; ++c) {
      const ChannelOutput& channel = output.channels[c];
      changes += channel.scheme != schemes_[c] ? 1 : 0;
      schemes_[c] = channel.scheme;
      for (std::size_t k = 0; k < static_cast<std::size_t>(channel.axis_count); ++k)
        judge(channel, c, k);
    }
    ASSERT_EQ(output.channels[0].axes[1].position, output.channels[1].axes[1].position);
  }

  int changes = 0;      // of schemes
  int conversions = 0;  // of the spindle to its axis

 private:
  void judge(const ChannelOutput& channel, std::size_t c, std::size_t k) {
    const bool turns = channel.drives[k].follows_velocity;
    const bool turned = turned_[c][k];
    const double way = channel.axes[k].position - before_[c][k];
    const double step = turns || turned ? std::remainder(way, 360.0) : way;
    const double most = k == 0 ? 0.25 : turns || turned ? 1.8 : 0.12;  // 300 rev/min, 120 deg/s
    ASSERT_LE(std::abs(step), most + 1e-9) << "channel " << c + 1 << " axis " << k;
    conversions += turned && !turns ? 1 : 0;
    turned_[c][k] = turns;
    before_[c][k] = channel.axes[k].position;
  }

  std::array<std::array<double, 3>, 2> before_{};
  std::array<std::array<bool, 3>, 2> turned_{};
  std::array<int, 2> schemes_{1, 1};
};

// Two random programs at once, perhaps a hold, then a reset.
void run_sequence(MachineBench& bench, Sequences& sequence, Watch& watch) {
  for (const int channel : {1, 2}) {
    const std::string name = "p" + std::to_string(channel) + ".nc";
    bench.program(name, sequence.program(channel == 1));
    bench.run(channel, name);
  }
  const auto cycles = [&](int count) {
    for (int k = 0; k < count; ++k) watch.look(bench.cycle());
  };
  cycles(sequence.pick(10, 400));
  if (sequence.pick(0, 1) == 1) {
    bench.ask(OperatorAction::program_hold, sequence.pick(1, 2));
    cycles(50);
    bench.ask(OperatorAction::program_resume, 0);
  }
  cycles(100);
  bench.ask(OperatorAction::program_reset, 1);
  bench.ask(OperatorAction::program_reset, 2);
  bench.run_to_end([&](const CycleOutput& output) { watch.look(output); }, 5000);  // or a wedge
}

TEST(SchemeSequences, RandomOnesKeepTheLimitsAndAlwaysComeToAnEnd) {
  constexpr int sequences = 1000;
  const std::vector<std::string> known = {"E5010", "E5102", "E5201", "E5202", "E5203",
                                          "E6003", "E4055", "E4056", "W0001", "W810",
                                          "E6004", "",      "E4010", "E6072"};
  MachineBench bench(two_sided_machine());
  bench.may_refuse();  // a scheme that is not there
  Sequences sequence(20261);
  Watch watch;
  for (int n = 0; n < sequences && !::testing::Test::HasFailure(); ++n) {
    SCOPED_TRACE(::testing::Message() << "sequence " << n);
    run_sequence(bench, sequence, watch);
  }
  for (const std::string& code : bench.event_codes())
    EXPECT_THAT(code, ::testing::AnyOfArray(known));
  EXPECT_THAT(bench.event_codes(), Contains("E5203"));
  EXPECT_THAT(bench.event_codes(), Contains("E5102"));
  EXPECT_GT(watch.changes, 100);
  EXPECT_GT(watch.conversions, 100);
}

}  // namespace
}  // namespace stanok::channels
