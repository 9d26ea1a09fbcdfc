// Leave and return: the axes of a held program are jogged away, its spindles and coolant are off,
// and all comes back: what the program does then is what it does when nobody has touched it.
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

constexpr std::size_t axis_count = 5;
using Places = std::array<double, axis_count>;

struct Shop {
  const char* name;
  MachineConfig (*machine)();
  const char* head;  // of the program
  std::array<const char*, 3> jogged;
  const char* coordinates;
};

class Scene {
 public:
  Scene(const Shop& shop, unsigned seed)
      : shop_(shop),
        random_(seed),
        bench(shop.machine(), {.on_at_start = true, .stops_go_on = false}) {
    bench.program("p.nc", program());
  }

  int pick(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }
  double real(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }

  std::string program() {
    std::string text = std::string(shop_.head) + "M3 S1000\nM8\nF3000\n";
    for (int n = 0; n < 12; ++n) {
      text += pick(0, 4) == 0 ? "G0" : "G1";
      for (const char* word = shop_.coordinates; *word != 0; ++word)
        if (pick(0, 2) != 0) text += std::string(" ") + *word + std::to_string(pick(-40, 40));
      text += "\n";
      if (pick(0, 9) == 0) text += "G4 P0.05\n";
      if (pick(0, 9) == 0) text += "M0\n";
    }
    return text + "M30\n";
  }

  Places axes() const { return places(bench.channel(1)); }
  static Places places(const ChannelOutput& channel) {
    Places positions{};
    for (std::size_t k = 0; k < positions.size(); ++k)
      if (!channel.drives[k].follows_velocity) positions[k] = channel.axes[k].position;
    return positions;
  }

  void hold(int after) {
    bench.run(1, "p.nc");
    for (int n = 0; n < after; ++n) bench.cycle();
    bench.ask(OperatorAction::program_hold, 1);
    for (int n = 0; n < 3000 && !(n > 5 && !bench.channel(1).moving); ++n) bench.cycle();
  }

  const OperatorReply& answer(const OperatorCommand& command) {
    OperatorEvent event;
    event.channel = 1;
    event.command = command;
    const std::size_t before = bench.replies().size();
    bench.ask(event);
    for (int n = 0; n < 60000 && bench.replies().size() == before; ++n) watch(bench.cycle());
    EXPECT_GT(bench.replies().size(), before);
    return bench.replies().back();
  }
  void rest() {
    watch(bench.cycle());
    for (int n = 0; n < 60000 && bench.channel(1).moving; ++n) watch(bench.cycle());
  }

  // Velocity of each axis within its limit, and in step with its position.
  void watch(const CycleOutput& output) {
    const Places now = places(output.channels[0]);
    for (std::size_t k = 0; k < now.size(); ++k)
      EXPECT_LE(std::abs(now[k] - before_[k]), 0.25 * (1.0 + 1e-9)) << k;
    before_ = now;
  }
  void begin_watch() { before_ = axes(); }

  // Positions, cycle by cycle, until nothing happens any more; at M0 the program goes on.
  std::vector<Places> rest_of_program() {
    std::vector<Places> course;
    for (int n = 0; n < 60000 && bench.channel(1).running; ++n) {
      course.push_back(places(bench.cycle().channels[0]));
      if (bench.channel(1).state == ChannelState::held) bench.ask(OperatorAction::program_start, 1);
    }
    EXPECT_FALSE(bench.channel(1).running);
    return course;
  }

  // Along the path, by a way or as long as it is asked for.
  void retrace() {
    commands::ProgramRetrace retrace;
    retrace.direction = pick(0, 2) == 0 ? RetraceDirection::forward : RetraceDirection::back;
    if (pick(0, 1) == 0) retrace.length = real(0.01, 60.0);
    for (int times = retrace.length > 0.0 ? 1 : pick(1, 20); times > 0; --times) {
      const OperatorReply reply = answer(retrace);
      const std::string_view code = reply.code.view();
      EXPECT_TRUE(reply.ok || code == "E6099" || code == "E6102" || code == "E6097") << code;
      if (reply.ok) ++retraced;
      if (retrace.length == 0.0)
        for (int n = 0; n < 100; ++n) watch(bench.cycle());
    }
    rest();
  }

  // Axes away, a few times, one after the other.
  void go_away() {
    for (int moves = pick(1, 6); moves > 0; --moves) {
      if (pick(0, 2) == 0) retrace();
      commands::Jog jog;
      const std::size_t axis = static_cast<std::size_t>(pick(0, 2));
      jog.axis = ShortText(shop_.jogged[axis]);
      jog.velocity = (pick(0, 1) == 0 ? 1.0 : -1.0) * real(5.0, 60.0);
      jog.increment = real(0.01, 30.0);
      const OperatorReply reply = answer(jog);
      EXPECT_TRUE(reply.ok || reply.code.view() == "E6099" || reply.code.view() == "E6053")
          << reply.code.view();
      rest();
    }
  }

 private:
  const Shop& shop_;
  std::mt19937 random_;
  Places before_{};

 public:
  MachineBench bench;
  int retraced = 0;
};

// The courses without the time that axes stand in front.
std::vector<Places> moving_part(const std::vector<Places>& course) {
  std::vector<Places> moving;
  for (const Places& place : course)
    if (moving.empty() || moving.back() != place) moving.push_back(place);
  return moving;
}

class MoveAside : public ::testing::TestWithParam<Shop> {};

TEST_P(MoveAside, TheProgramGoesOnAsIfNobodyHadTouchedIt) {
  const unsigned seeds = testing::is_sanitized ? 4 : 40;
  int left = 0;
  int retraced = 0;
  for (unsigned seed = 1; seed <= seeds; ++seed) {
    SCOPED_TRACE(seed);
    Scene untouched(GetParam(), seed);
    Scene scene(GetParam(), seed);
    const int after = scene.pick(100, 5000);
    ASSERT_EQ(untouched.pick(100, 5000), after);
    untouched.hold(after);
    scene.hold(after);
    if (!scene.bench.channel(1).running) continue;
    ASSERT_EQ(scene.axes(), untouched.axes());
    const Places held = scene.axes();
    const double turned = scene.bench.channel(1).process.spindles[0].target_rev_per_min;
    scene.begin_watch();
    const bool is_off = scene.pick(0, 1) == 1;
    if (is_off) {
      EXPECT_TRUE(scene.answer(commands::SpindleSwitch{Switch::off}).ok);
      EXPECT_TRUE(scene.answer(commands::CoolantSwitch{Switch::off}).ok);
    }
    scene.go_away();
    if (scene.bench.channel(1).aside) {
      ++left;
      EXPECT_EQ(scene.answer(commands::ProgramStart{}).code.view(), "E6097");
      if (scene.pick(0, 1) == 1) {
        scene.bench.ask(OperatorAction::program_return, 1);
        for (int n = scene.pick(1, 400); n > 0; --n) scene.watch(scene.bench.cycle());
        scene.bench.ask(OperatorAction::program_hold, 1);
        scene.rest();
        scene.go_away();
      }
      if (scene.bench.channel(1).aside) {
        const OperatorReply& back = scene.answer(commands::ProgramReturn{scene.real(2.0, 80.0)});
        EXPECT_TRUE(back.ok) << back.code.view();
      }
      if (is_off) {
        EXPECT_EQ(scene.bench.channel(1).process.spindles[0].rev_per_min, turned);
      }
    }
    EXPECT_FALSE(scene.bench.channel(1).aside);
    EXPECT_EQ(scene.axes(), held);
    retraced += scene.retraced > 0 ? 1 : 0;
    scene.bench.ask(OperatorAction::program_start, 1);
    untouched.bench.ask(OperatorAction::program_start, 1);
    EXPECT_EQ(moving_part(scene.rest_of_program()), moving_part(untouched.rest_of_program()));
    EXPECT_EQ(scene.bench.alarm_codes(), std::vector<std::string>());
  }
  EXPECT_GT(left, static_cast<int>(seeds) / 2);
  EXPECT_GE(retraced, static_cast<int>(seeds) / 8);
}

TEST_P(MoveAside, AResetLeavesTheAxesWhereTheyAre) {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    SCOPED_TRACE(seed);
    Scene scene(GetParam(), seed);
    scene.hold(scene.pick(100, 3000));
    if (!scene.bench.channel(1).running) continue;
    scene.begin_watch();
    scene.go_away();
    const Places away = scene.axes();
    scene.bench.ask(OperatorAction::program_reset, 1);
    scene.bench.run_to_end([&](const CycleOutput& output) { scene.watch(output); });
    EXPECT_EQ(scene.axes(), away);
    EXPECT_FALSE(scene.bench.channel(1).aside);
    scene.bench.ask(OperatorAction::mdi, 1, "G53 G1 X" + std::to_string(away[0]) + " F500");
    scene.bench.run_to_end([&](const CycleOutput& output) { scene.watch(output); });
    for (std::size_t k = 0; k < away.size(); ++k) EXPECT_NEAR(scene.axes()[k], away[k], 1e-5);
  }
}

// The rapid override may lower it further; the feed is what it was.
TEST(FirstPart, RapidTraverseKeepsToAQuarter) {
  const auto fastest = [](int is_first, double override_percent) {
    MachineBench bench(testing::two_channel_machine(), {.on_at_start = true});
    bench.program("p.nc", "G0 X200\nG1 X0 F6000\nM30\n");
    bench.ask(OperatorAction::first_part, 1, "", 0.0, is_first);
    bench.ask(OperatorAction::override_rapid, 1, "", 0.01 * override_percent);
    bench.run(1, "p.nc");
    std::array<double, 2> speeds{};
    bench.run_to_end([&](const CycleOutput& output) {
      const ChannelOutput& channel = output.channels[0];
      double& speed = speeds[channel.feed_commanded > 0.0 ? 1 : 0];
      speed = std::max(speed, channel.path_speed);
    });
    return speeds;
  };
  EXPECT_NEAR(fastest(0, 100.0)[0], 250.0, 1e-6);
  EXPECT_NEAR(fastest(1, 100.0)[0], 0.25 * 250.0, 1e-6);
  EXPECT_NEAR(fastest(1, 10.0)[0], 0.10 * 250.0, 1e-6);
  EXPECT_NEAR(fastest(1, 100.0)[1], 100.0, 1e-6);
}

// [machine] first_run: until a program has run to its end; a subprogram belongs to its text.
TEST(FirstPart, IsTheFirstRunOfEachText) {
  MachineConfig machine = testing::two_channel_machine();
  machine.first_run = true;
  MachineBench bench(machine, {.on_at_start = true, .stops_go_on = false});
  const auto fastest = [&](const char* name, int reset_after = 0) {
    bench.run(1, name);
    double speed = 0.0;
    int cycles = 0;
    bench.run_to_end([&](const CycleOutput& output) {
      if (++cycles == reset_after) bench.ask(OperatorAction::program_reset, 1);
      speed = std::max(speed, output.channels[0].path_speed);
    });
    bench.ask(OperatorAction::mdi, 1, "G0 X0");
    bench.run_to_end();
    return speed;
  };
  bench.program("sub.nc", "const num far = 100;\n");
  bench.program("a.nc", "#include \"sub.nc\"\nG0 X200\nM30\n");
  bench.program("b.nc", "G0 X150\nM30\n");
  EXPECT_NEAR(fastest("a.nc", 500), 62.5, 1e-6) << "a reset is no end";
  EXPECT_NEAR(fastest("a.nc"), 62.5, 1e-6);
  EXPECT_NEAR(fastest("a.nc"), 250.0, 1e-6);
  EXPECT_NEAR(fastest("b.nc"), 62.5, 1e-6);
  EXPECT_NEAR(fastest("a.nc"), 250.0, 1e-6);
  EXPECT_NEAR(fastest("b.nc"), 250.0, 1e-6);
  bench.program("b.nc", "G0 X151\nM30\n");
  EXPECT_NEAR(fastest("b.nc"), 62.5, 1e-6);
  bench.program("sub.nc", "const num far = 101;\n");
  EXPECT_NEAR(fastest("a.nc"), 62.5, 1e-6);
}

// What lies before the line where it was started has not run.
TEST(FirstPart, ARunFromTheMiddleIsNone) {
  MachineConfig machine = testing::two_channel_machine();
  machine.first_run = true;
  MachineBench bench(machine, {.on_at_start = true, .stops_go_on = false});
  bench.program("a.nc", "G0 X200\nG0 X0\nG0 X200\nG0 X0\nM30\n");
  const auto fastest = [&](const char* from) {
    bench.ask(OperatorAction::program_load, 1, "a.nc");
    bench.run_to_end();
    if (from != nullptr) bench.ask(OperatorAction::program_search, 1, from);
    bench.run_to_end();
    bench.ask(OperatorAction::program_start, 1);
    double speed = 0.0;
    bench.run_to_end(
        [&](const CycleOutput& output) { speed = std::max(speed, output.channels[0].path_speed); });
    return speed;
  };
  EXPECT_NEAR(fastest("3"), 62.5, 1e-6);
  EXPECT_NEAR(fastest(nullptr), 62.5, 1e-6);
  EXPECT_NEAR(fastest("3"), 250.0, 1e-6);
}

class Refusals : public ::testing::Test {
 protected:
  std::string code_of(const OperatorCommand& command) {
    OperatorEvent event;
    event.channel = 1;
    event.command = command;
    const std::size_t before = bench.replies().size();
    bench.ask(event);
    for (int n = 0; n < 20000 && bench.replies().size() == before; ++n) bench.cycle();
    return std::string(bench.replies().back().code.view());
  }
  void hold_in(const std::string& text) {
    bench.program("p.nc", text);
    bench.run(1, "p.nc");
    cycles(300);
    EXPECT_EQ(code_of(commands::ProgramReturn{}), "E6096");
    bench.ask(OperatorAction::program_hold, 1);
    cycles(300);
  }
  void cycles(int count) {
    for (int n = 0; n < count; ++n) bench.cycle();
  }
  static commands::Jog jog_of(const char* axis) {
    return {.axis = ShortText(axis), .velocity = 50.0, .increment = 0.1};
  }

  static MachineConfig machine() {
    MachineConfig config = testing::two_channel_machine();
    config.channels[0].probe_input = 7;
    return config;
  }

  MachineBench bench{machine(), {.on_at_start = true}};
};

TEST_F(Refusals, OnThePathThereIsNothingToReturnFrom) {
  hold_in("G1 X100 F600\nM30\n");
  EXPECT_EQ(code_of(commands::ProgramReturn{}), "E6098");
}

TEST_F(Refusals, AProbeThatIsAwaitedKeepsTheAxesOnThePath) {
  hold_in("G38.3 X100 F600\nM30\n");
  EXPECT_EQ(code_of(jog_of("Y")), "E6099");
}

TEST_F(Refusals, TheWayBackHasAnEnd) {
  hold_in("G1 X100 F600\nM30\n");
  for (int n = 0; n < 63; ++n) {
    EXPECT_EQ(code_of(jog_of(n % 2 == 0 ? "Y" : "Z")), "");
    cycles(100);
  }
  EXPECT_EQ(code_of(jog_of("Z")), "E6100");
  EXPECT_EQ(code_of(commands::ProgramResume{}), "E6097");
  EXPECT_EQ(code_of(commands::ProgramReturn{.velocity = 50.0}), "");
  EXPECT_EQ(code_of(commands::ProgramResume{}), "");
}

// One move after the other, so that the way back is the way that was free.
TEST_F(Refusals, OneAxisMovesAtATime) {
  hold_in("G1 X100 F600\nM30\n");
  bench.ask(OperatorAction::jog, 1, "Y", 5.0);
  bench.cycle();
  EXPECT_EQ(code_of(jog_of("Z")), "E6056");
}

// A return that waits for its spindle is called off by whoever moves on by hand: it does not begin
// behind that move.
TEST(Return, IsCalledOffByAJogWhileItWaitsForTheSpindle) {
  MachineBench bench(testing::turning_machine(), {.on_at_start = true});
  const auto ask = [&](const OperatorCommand& command) {
    OperatorEvent event;
    event.channel = 1;
    event.command = command;
    bench.ask(event);
  };
  const auto cycles = [&](int count) {
    for (int n = 0; n < count; ++n) bench.cycle();
  };
  const commands::Jog jog{.axis = ShortText("X"), .velocity = 50.0, .increment = 1.0};
  bench.program("p.nc", "S1000 M3\nG94 G1 X50 F600\nM30\n");
  bench.run(1, "p.nc");
  bench.cycle();
  for (int n = 0; n < 20000 && bench.channel(1).path_speed < 5.0; ++n) bench.cycle();
  bench.ask(OperatorAction::program_hold, 1);
  cycles(300);
  ask(commands::SpindleSwitch{Switch::off});
  for (int n = 0; n < 20000 && bench.channel(1).process.spindles[0].rev_per_min != 0.0; ++n)
    bench.cycle();
  ask(jog);
  cycles(300);
  ASSERT_TRUE(bench.channel(1).aside);
  ask(commands::ProgramReturn{});
  cycles(20);
  ASSERT_LT(bench.channel(1).process.spindles[0].rev_per_min, 900.0) << "it still waits";
  ask(jog);
  cycles(300);
  const double stands = bench.channel(1).axes[testing::lathe_X].position;
  cycles(5000);
  EXPECT_EQ(bench.channel(1).axes[testing::lathe_X].position, stands);
  EXPECT_TRUE(bench.channel(1).aside);
  EXPECT_EQ(bench.replies()[bench.replies().size() - 1].code.view(), "E6072");
}

MachineConfig five_axis_machine() {
  MachineConfig machine = testing::two_channel_machine();
  machine.channels[0].scheme = 2;
  return machine;
}

constexpr Shop mill{.name = "mill",
                    .machine = testing::two_channel_machine,
                    .head = "G64 P0.05\n",
                    .jogged = {"X", "Y", "Z"},
                    .coordinates = "XYZ"};
constexpr Shop five_axes{.name = "five_axes",
                         .machine = five_axis_machine,
                         .head = "G43.4\nG64 P0.05\n",
                         .jogged = {"Z", "B", "C"},
                         .coordinates = "XYZBC"};
constexpr Shop lathe{.name = "lathe",
                     .machine = testing::turning_machine,
                     .head = "G64 P0.05\n",
                     .jogged = {"X", "Z", "X"},
                     .coordinates = "XZ"};

INSTANTIATE_TEST_SUITE_P(All, MoveAside, ::testing::Values(mill, five_axes, lathe),
                         [](const auto& shop) { return std::string(shop.param.name); });

}  // namespace
}  // namespace stanok::channels
