// A length of the tool that an operator changes in a hold counts at once: the path of its point on
// the part is the programmed one, and the axes go by the change beside where they went.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "tests/support/machine/machine_bench.h"
#include "tests/support/sanitized.h"

namespace stanok::channels {
namespace {

using testing::MachineBench;

using PlaceOfThree = std::array<double, 3>;

// A machine with the axes on which a tool has a length, by their places in the channel.
struct LengthCase {
  const char* name;
  MachineConfig (*machine)();
  const char* head;  // takes tool 1
  const char* coordinates;
  std::vector<std::pair<const char*, std::size_t>> keys;  // values of a tool, and their axis
  std::array<const char*, 3> jogged;
};

class LengthScene {
 public:
  LengthScene(const LengthCase& at, unsigned seed)
      : random_(seed), bench(at.machine(), {.on_at_start = true, .stops_go_on = false}) {
    for (const auto& [key, axis] : at.keys)
      set(key, std::string_view(key).starts_with("wear") ? 0.125 : 40.0);
    std::string text = std::string(at.head) + "G64 P0.05\nF3000\n";
    for (int n = 0; n < 14; ++n) {
      text += pick(0, 4) == 0 ? "G0" : "G1";
      for (const char* word = at.coordinates; *word != 0; ++word)
        if (pick(0, 2) != 0) text += std::string(" ") + *word + std::to_string(pick(-40, 40));
      text += pick(0, 9) == 0 ? "\nM0\n" : "\n";
    }
    bench.program("p.nc", text + "M30\n");
  }

  int pick(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }
  double real(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }

  std::string code_of(const OperatorCommand& command) {
    OperatorEvent event;
    event.channel = std::holds_alternative<commands::ToolSet>(command) ? 0 : 1;
    event.command = command;
    const std::size_t before = bench.replies().size();
    bench.ask(event);
    for (int n = 0; n < 60000 && bench.replies().size() == before; ++n) bench.cycle();
    return std::string(bench.replies().back().code.view());
  }
  void set(const char* key, double value, int tool = 1) {
    EXPECT_EQ(code_of(commands::ToolSet{.key = ShortText(key), .value = value, .tool = tool}), "");
    values_[{tool, key}] = value;
  }
  void change(const char* key, double by, int tool = 1) {
    set(key, values_[{tool, key}] + by, tool);
  }
  void hold(int after) {
    bench.run(1, "p.nc");
    for (int n = 0; n < after; ++n) bench.cycle();
    bench.ask(OperatorAction::program_hold, 1);
    for (int n = 0; n < 3000 && !(n > 5 && !bench.channel(1).moving); ++n) bench.cycle();
  }
  void jog(const char* axis, double way) {
    commands::Jog jog{.axis = ShortText(axis), .velocity = way < 0 ? -50.0 : 50.0};
    jog.increment = std::abs(way);
    const std::string code = code_of(jog);
    EXPECT_TRUE(code.empty() || code == "E6099" || code == "E6053") << code;
    for (int n = 0; n < 3 || bench.channel(1).moving; ++n) bench.cycle();
  }
  void go_back_and_on() {
    if (bench.channel(1).aside) {
      EXPECT_EQ(code_of(commands::ProgramReturn{}), "");
    }
    EXPECT_FALSE(bench.channel(1).aside);
    bench.ask(OperatorAction::program_start, 1);
  }
  PlaceOfThree axes() const {
    PlaceOfThree places{};
    for (std::size_t k = 0; k < places.size(); ++k) {
      if (!bench.channel(1).drives[k].follows_velocity)
        places[k] = bench.channel(1).axes[k].position;
    }
    return places;
  }
  // Where the axes are, each place once, until the program ends; at M0 it goes on.
  std::vector<PlaceOfThree> rest_of_program() {
    std::vector<PlaceOfThree> course{axes()};
    for (int n = 0; n < 60000 && bench.channel(1).running; ++n) {
      bench.cycle();
      if (course.back() != axes()) course.push_back(axes());
      if (bench.channel(1).state == ChannelState::held) bench.ask(OperatorAction::program_start, 1);
    }
    EXPECT_FALSE(bench.channel(1).running);
    return course;
  }

 private:
  std::mt19937 random_;
  std::map<std::pair<int, std::string>, double> values_;

 public:
  MachineBench bench;
};

class NewLength : public ::testing::TestWithParam<LengthCase> {};

TEST_P(NewLength, LeadsTheSamePathBesideTheOneBefore) {
  const unsigned seeds = testing::is_sanitized ? 6 : 60;
  int changed = 0;
  for (unsigned seed = 1; seed <= seeds; ++seed) {
    SCOPED_TRACE(seed);
    LengthScene untouched(GetParam(), seed);
    LengthScene scene(GetParam(), seed);
    const int after = scene.pick(100, 4000);
    ASSERT_EQ(untouched.pick(100, 4000), after);
    untouched.hold(after);
    scene.hold(after);
    if (!scene.bench.channel(1).running) continue;
    ++changed;
    const PlaceOfThree held = scene.axes();
    ASSERT_EQ(held, untouched.axes());
    PlaceOfThree by{};
    for (int times = scene.pick(1, 3); times > 0; --times) {
      if (scene.pick(0, 1) == 0)
        scene.jog(GetParam().jogged[static_cast<std::size_t>(scene.pick(0, 2))],
                  scene.real(-20.0, 20.0));
      const auto& [key, axis] =
          GetParam().keys[static_cast<std::size_t>(scene.pick(0, 99)) % GetParam().keys.size()];
      const double longer = scene.real(-1.0, 1.0);
      const PlaceOfThree standing = scene.axes();
      scene.change(key, longer);
      for (int n = 0; n < 20; ++n) scene.bench.cycle();
      EXPECT_EQ(scene.axes(), standing) << "the axes stay until they are led";
      EXPECT_TRUE(scene.bench.channel(1).aside);
      by[axis] += longer;
    }
    EXPECT_EQ(scene.code_of(commands::ProgramStart{}), "E6097");
    scene.go_back_and_on();
    untouched.bench.ask(OperatorAction::program_start, 1);
    for (std::size_t k = 0; k < held.size(); ++k)
      EXPECT_NEAR(scene.axes()[k], held[k] + by[k], 1e-9);
    const std::vector<PlaceOfThree> course = scene.rest_of_program();
    const std::vector<PlaceOfThree> other = untouched.rest_of_program();
    ASSERT_EQ(course.size(), other.size());
    for (std::size_t n = 0; n < course.size(); ++n) {
      for (std::size_t k = 0; k < held.size(); ++k)
        ASSERT_NEAR(course[n][k], other[n][k] + by[k], 1e-9) << n << " " << k;
    }
    EXPECT_EQ(scene.bench.alarm_codes(), std::vector<std::string>());
  }
  EXPECT_GT(changed, static_cast<int>(seeds) / 2);
}

constexpr const char* mill_head = "T1 M6\nG43 H1\n";

MachineConfig machine_with_head() {
  MachineConfig machine = testing::two_channel_machine();
  machine.channels[0].scheme = 2;
  return machine;
}

const LengthCase mill_of_lengths{.name = "mill",
                                 .machine = testing::two_channel_machine,
                                 .head = mill_head,
                                 .coordinates = "XYZ",
                                 .keys = {{"length", 2}, {"wear_length", 2}},
                                 .jogged = {"X", "Y", "Z"}};
const LengthCase head_of_lengths{.name = "five_axes",
                                 .machine = machine_with_head,
                                 .head = mill_head,
                                 .coordinates = "XYZBC",
                                 .keys = {{"length", 2}, {"wear_length", 2}},
                                 .jogged = {"Z", "B", "C"}};
const LengthCase lathe_of_lengths{
    .name = "lathe",
    .machine = testing::turning_machine,
    .head = "T1\nG43 H1\nM3 S1000\n",
    .coordinates = "XZ",
    .keys = {{"length", 1}, {"length_x", 0}, {"wear_length", 1}, {"wear_length_x", 0}},
    .jogged = {"X", "Z", "X"}};

INSTANTIATE_TEST_SUITE_P(All, NewLength,
                         ::testing::Values(mill_of_lengths, head_of_lengths, lathe_of_lengths),
                         [](const auto& at) { return std::string(at.param.name); });

// The point of a longer tool goes back where the one before came: up first.
TEST(NewLengthAside, TheWayOfThePointIsTheOneThatWasFree) {
  LengthScene scene(mill_of_lengths, 1);
  scene.hold(1500);
  const PlaceOfThree held = scene.axes();
  scene.jog("X", 20.0);
  scene.change("length", 30.0);
  scene.bench.ask(OperatorAction::program_return, 1);
  double lowest = 1e9;
  for (int n = 0; n < 20000 && scene.bench.channel(1).aside; ++n) {
    scene.bench.cycle();
    const PlaceOfThree now = scene.axes();
    if (std::abs(now[0] - held[0] - 20.0) > 1e-6) lowest = std::min(lowest, now[2]);
  }
  EXPECT_NEAR(lowest, held[2] + 30.0, 1e-9);
}

// What lies in the queue when the length changes was prepared for the one before.
class PreparedBefore : public ::testing::Test {
 protected:
  explicit PreparedBefore(MachineConfig config = testing::two_channel_machine())
      : bench(std::move(config), {.on_at_start = true, .stops_go_on = false}) {}

  std::string code_of(const OperatorCommand& command) {
    OperatorEvent event;
    event.channel = std::holds_alternative<commands::ToolSet>(command) ? 0 : 1;
    event.command = command;
    const std::size_t before = bench.replies().size();
    bench.ask(event);
    for (int n = 0; n < 60000 && bench.replies().size() == before; ++n) bench.cycle();
    return std::string(bench.replies().back().code.view());
  }
  std::string set(int tool, const char* key, double value) {
    return code_of(commands::ToolSet{.key = ShortText(key), .value = value, .tool = tool});
  }
  void hold_in(const std::string& text, int after = 400) {
    ASSERT_EQ(set(1, "length", 50.0), "");
    ASSERT_EQ(set(2, "length", 80.0), "");
    bench.program("p.nc", text);
    bench.run(1, "p.nc");
    for (int n = 0; n < after; ++n) bench.cycle();
    bench.ask(OperatorAction::program_hold, 1);
    for (int n = 0; n < 400; ++n) bench.cycle();
    ASSERT_EQ(bench.channel(1).state, ChannelState::held);
  }
  // To the end of the run, or to where the path is elsewhere than the axes; Z at the end of each
  // line.
  void go_on() {
    if (bench.channel(1).aside) {
      EXPECT_EQ(code_of(commands::ProgramReturn{}), "");
    }
    bench.ask(OperatorAction::program_start, 1);
    for (int n = 0; n < 60000; ++n) {
      bench.cycle();
      z[bench.channel(1).tag.line] = bench.channel(1).axes[2].position;
      if (!bench.channel(1).running || bench.channel(1).hold_cause == HoldCause::changed_length)
        return;
    }
    ADD_FAILURE() << "no end";
  }

  std::map<std::uint32_t, double> z;
  MachineBench bench;
};

TEST_F(PreparedBefore, AMachinePositionIsWhereItIs) {
  hold_in("G61 G43 H1\nG1 Z1 F3000\nX50\nG53 G1 Z100\nX60 Z2\nM30\n");
  EXPECT_EQ(set(1, "length", 52.5), "");
  go_on();
  EXPECT_NEAR(z[3], 1.0 + 52.5, 1e-9);
  ASSERT_EQ(bench.channel(1).hold_cause, HoldCause::changed_length);
  EXPECT_TRUE(bench.channel(1).aside);
  go_on();
  EXPECT_NEAR(z[4], 100.0, 1e-9);
  ASSERT_EQ(bench.channel(1).hold_cause, HoldCause::changed_length);
  go_on();
  EXPECT_NEAR(z[5], 2.0 + 52.5, 1e-9);
  EXPECT_FALSE(bench.channel(1).running);
  EXPECT_EQ(bench.alarm_codes(), std::vector<std::string>());
}

TEST_F(PreparedBefore, ALengthThatWasReadAheadCountsWhereItComesIntoForce) {
  hold_in("G43 H1\nG1 Z1 F3000\nX50\nG43 H2\nX60 Z2\nM30\n");
  EXPECT_EQ(set(2, "length", 81.0), "");
  EXPECT_FALSE(bench.channel(1).aside);
  go_on();
  EXPECT_NEAR(z[3], 1.0 + 50.0, 1e-9);
  ASSERT_EQ(bench.channel(1).hold_cause, HoldCause::changed_length);
  go_on();
  EXPECT_NEAR(z[5], 2.0 + 81.0, 1e-9);
  EXPECT_FALSE(bench.channel(1).running);
}

// So much that the blocks behind it are prepared later.
std::string many_blocks() {
  std::string text;
  for (int n = 0; n < 400; ++n) text += n % 2 == 0 ? "X10\n" : "X14\n";
  return text;
}

TEST_F(PreparedBefore, WhatIsPreparedLaterKnowsIt) {
  hold_in("G61 G43 H1\nG1 Z1 F6000\n" + many_blocks() +
          "G53 G1 Z100\nG91 G1 Z-1\nG90 X20\nG49\nG91 Z3\nM30\n");
  EXPECT_EQ(set(1, "length", 52.5), "");
  go_on();
  EXPECT_FALSE(bench.channel(1).running);
  EXPECT_NEAR(z[403], 100.0, 1e-6);
  EXPECT_NEAR(z[404], 99.0, 1e-6);
  EXPECT_NEAR(z[407], 102.0, 1e-9);
  EXPECT_EQ(bench.alarm_codes(), std::vector<std::string>());
}

TEST_F(PreparedBefore, TheEndOfALengthMovesNothing) {
  hold_in("G61 G43 H1\nG1 Z1 F6000\n" + many_blocks() + "G49\nG91 X1\nZ3\nG43 H1\nG90 Z7\nM30\n");
  EXPECT_EQ(set(1, "length", 52.5), "");
  go_on();
  EXPECT_FALSE(bench.channel(1).running);
  EXPECT_NEAR(z[404], 53.5, 1e-9);
  EXPECT_NEAR(z[405], 56.5, 1e-9);
  EXPECT_NEAR(z[407], 59.5, 1e-9);
}

// The position on the way to which the program reads it again.
TEST_F(PreparedBefore, AnswersOfTheMachineAreInIt) {
  hold_in("G43 H1\nG1 Z1 F3000\nX50\nT2 M6\nG91 Z1\nM30\n");
  EXPECT_EQ(set(1, "length", 52.5), "");
  go_on();
  EXPECT_FALSE(bench.channel(1).running);
  EXPECT_NEAR(z[5], 2.0 + 52.5, 1e-9);
}

TEST_F(PreparedBefore, TheNextRunBeginsWithTheTable) {
  hold_in("G43 H1\nG1 Z1 F3000\nX50\nM30\n");
  EXPECT_EQ(set(1, "length", 52.5), "");
  go_on();
  EXPECT_FALSE(bench.channel(1).running);
  z.clear();
  bench.run(1, "p.nc");
  bench.run_to_end();
  EXPECT_NEAR(bench.channel(1).axes[2].position, 1.0 + 52.5, 1e-9);
  EXPECT_EQ(bench.alarm_codes(), std::vector<std::string>());
}

TEST_F(PreparedBefore, OtherValuesChangeAsInARun) {
  hold_in("G43 H1\nG1 Z1 F3000\nX50\nM30\n");
  EXPECT_EQ(set(1, "radius", 5.0), "E6101");
  EXPECT_EQ(set(1, "wear_radius", 0.51), "E6101");
  EXPECT_EQ(set(1, "wear_radius", 0.1), "");
  EXPECT_FALSE(bench.channel(1).aside);
  EXPECT_EQ(set(1, "length", 1e7), "E5020");
  EXPECT_FALSE(bench.channel(1).aside);
}

class Probed : public PreparedBefore {
 protected:
  static MachineConfig machine() {
    MachineConfig config = testing::two_channel_machine();
    config.channels[0].probe_input = 7;
    return config;
  }
  Probed() : PreparedBefore(machine()) {}
};

// The axes stand where the probe changed, and not at the end of the way that was programmed.
TEST_F(Probed, AContactBehindTheChangeIsWhereTheAxesStand) {
  hold_in("G43 H1\nG1 Z1 F3000\nX50\nG38.3 Z-20 F600\nG91 G1 Z5 F600\nM30\n");
  EXPECT_EQ(set(1, "length", 52.5), "");
  EXPECT_EQ(code_of(commands::ProgramReturn{}), "");
  bench.ask(OperatorAction::program_start, 1);
  Signals signals;
  double stands_at = 0.0;
  for (int n = 0; n < 60000 && bench.channel(1).running; ++n) {
    const double z_M = bench.cycle().channels[0].axes[2].position;
    signals.set(7, bench.channel(1).tag.line == 4 && z_M < 45.0);
    bench.inputs(signals);
    if (bench.channel(1).tag.line == 4) stands_at = z_M;
    ASSERT_NE(bench.channel(1).hold_cause, HoldCause::changed_length);
  }
  EXPECT_FALSE(bench.channel(1).running);
  EXPECT_GT(stands_at, 30.0) << "it did not reach the end of its way";
  EXPECT_NEAR(bench.channel(1).axes[2].position, stands_at + 5.0, 1e-6);
}

TEST_F(PreparedBefore, TheAxesKeepTheirTravel) {
  hold_in("G43 H1\nG1 Z1 F3000\nX50\nM30\n", 1500);
  EXPECT_EQ(set(1, "length", 499.0), "");
  EXPECT_EQ(set(1, "length", 501.0), "E6053");
  EXPECT_EQ(set(1, "length", 52.0), "");
}

TEST_F(PreparedBefore, WhileTheAxesComeToRestNoLengthChanges) {
  ASSERT_EQ(set(1, "length", 50.0), "");
  bench.program("p.nc", "G43 H1\nG1 Z1 F6000\nX200\nM30\n");
  bench.run(1, "p.nc");
  for (int n = 0; n < 1000; ++n) bench.cycle();
  bench.ask(OperatorAction::program_hold, 1);
  bench.cycle();
  EXPECT_EQ(set(1, "length", 51.0), "E6070");
}

class LedPoint : public PreparedBefore {
 protected:
  LedPoint() : PreparedBefore(machine_with_head()) {}
};

// Speeds of the linear axes depend on the length there.
TEST_F(LedPoint, KeepsItsLength) {
  hold_in("G43.4 H1\nG1 Z1 F3000\nX50 B10\nM30\n");
  EXPECT_EQ(set(1, "length", 51.0), "E6101");
  EXPECT_EQ(set(2, "length", 81.0), "");
}

TEST_F(LedPoint, HasALengthThatCounts) {
  constexpr const char* text = "G43 H1\nG1 Z1 F3000\nX50\nG43.4 H2\nX60 Z3 B10\nM30\n";
  hold_in(text);
  EXPECT_EQ(set(2, "length", 81.0), "");
  go_on();
  if (bench.channel(1).running) go_on();
  EXPECT_FALSE(bench.channel(1).running);
  const double x = bench.channel(1).axes[0].position;
  const double held_z = bench.channel(1).axes[2].position;
  bench.run(1, "p.nc");
  bench.run_to_end();
  EXPECT_NEAR(bench.channel(1).axes[0].position, x, 1e-9);
  EXPECT_NEAR(bench.channel(1).axes[2].position, held_z, 1e-9);
  EXPECT_EQ(bench.alarm_codes(), std::vector<std::string>());
}

}  // namespace
}  // namespace stanok::channels
