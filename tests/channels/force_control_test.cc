// What a channel does with the modifier of its feed: what it tells it, what it takes from it, when
// it waits for it, and what becomes of its events. The modifier here does what a test says.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "tests/support/machine/machine_bench.h"

namespace stanok::channels {
namespace {

using motion::ForceCommand;
using motion::ForceEvent;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using testing::MachineBench;

class ScriptedModifier final : public motion::FeedModifier {
 public:
  bool command(const ForceCommand& order) RT_SAFE override {
    if (commands_taken < orders.size()) orders[commands_taken++] = order;
    return takes_orders;
  }
  motion::FeedDemand advance(const motion::CutState& cut) RT_SAFE override {
    ++cycles;
    latest = cut;
    starts_max = std::max(starts_max, cut.spindle_starts);
    told = cycles == event_cycle ? event_to_tell : ForceEvent::none;
    return demand;
  }
  bool is_ready() const RT_SAFE override { return cycles >= ready_cycle; }
  ForceEvent event() const RT_SAFE override { return told; }
  motion::ForceStatus status() const RT_SAFE override { return {}; }

  std::array<ForceCommand, 16> orders{};
  std::size_t commands_taken = 0;
  bool takes_orders = true;
  motion::FeedDemand demand;
  motion::CutState latest;
  std::uint32_t starts_max = 0;
  int cycles = 0;
  int ready_cycle = 0;
  int event_cycle = -1;
  ForceEvent event_to_tell = ForceEvent::none;
  ForceEvent told = ForceEvent::none;
};

class ForceControlOfAChannel : public ::testing::Test {
 protected:
  ForceControlOfAChannel() {
    MachineConfig config = testing::turning_machine();
    config.channels[0].force_control = true;
    bench = std::make_unique<MachineBench>(
        config,
        MachineOptions{.on_at_start = true, .stops_go_on = true, .feed_modifiers = {&modifier}});
  }
  // Path speeds at feed, in mm/s.
  std::vector<double> run(const std::string& text) {
    bench->program("cut.nc", text);
    bench->run(1, "cut.nc");
    std::vector<double> speeds;
    bench->run_to_end([&](const CycleOutput& output) {
      const ChannelOutput& channel = output.channels[0];
      if (channel.feed_commanded > 0.0 && channel.path_speed > 0.0)
        speeds.push_back(channel.path_speed);
    });
    return speeds;
  }

  ScriptedModifier modifier;
  std::unique_ptr<MachineBench> bench;
};

TEST_F(ForceControlOfAChannel, GoesAtTheFeedAskedFor) {
  modifier.demand = {.feed_per_s = 3.0, .feed_max_per_s = 20.0};
  const std::vector<double> speeds = run("G0 X60 Z0\nG94 G1 Z-20 F600\nM30\n");
  ASSERT_GT(speeds.size(), 1000U);
  EXPECT_NEAR(speeds[speeds.size() / 2], 3.0, 1e-9);
}

TEST_F(ForceControlOfAChannel, TakesTheOrdersOfAProgramInItsUnits) {
  run("G18 G8 G94\n#adaptive (force, 1200, 30, 240)\nG95\n#adaptive (force, 900, 0.1, 0.5)\n"
      "#adaptive (oscillate, 50, 4)\n#adaptive (vibration, on, 5, 2, 4)\n#adaptive (off)\nM30\n");
  ASSERT_EQ(modifier.commands_taken, 6U) << "and off at the end";
  EXPECT_EQ(modifier.orders[0].kind, ForceCommand::Kind::force);
  EXPECT_EQ(modifier.orders[0].force_n, 1200.0);
  EXPECT_EQ(modifier.orders[0].feed_max, 240.0);
  EXPECT_FALSE(modifier.orders[0].per_revolution);
  EXPECT_TRUE(modifier.orders[1].per_revolution);
  EXPECT_EQ(modifier.orders[2].oscillation_n, 50.0);
  EXPECT_EQ(modifier.orders[3].reduced_mass_kg, 2.0);
  EXPECT_EQ(modifier.orders[4].kind, ForceCommand::Kind::off);
}

TEST_F(ForceControlOfAChannel, EndsAProgramWhoseOrderIsNotTaken) {
  modifier.takes_orders = false;
  run("#adaptive (oscillate, 50, 4)\nM30\n");
  EXPECT_THAT(bench->alarm_codes(), ElementsAre("E6062"));
}

TEST_F(ForceControlOfAChannel, WaitsWithThePathUntilItIsReady) {
  modifier.ready_cycle = 3000;
  modifier.demand = {};
  bench->program("cut.nc", "S600 M3\n#adaptive (force, 1200)\nG1 X1 F600\nM30\n");
  bench->run(1, "cut.nc");
  bench->run_to_end([&](const CycleOutput& output) {
    if (modifier.cycles < 3000) {
      ASSERT_EQ(output.channels[0].path_speed, 0.0);
    }
  });
  EXPECT_GT(modifier.cycles, 3000);
}

// Started, stopped and started the other way round.
TEST_F(ForceControlOfAChannel, IsToldOfEachStartOfTheSpindle) {
  run("S600 M3\nS700\nM5\nM3\nM4\nM30\n");
  EXPECT_EQ(modifier.starts_max, 3U);
}

struct Told {
  ForceEvent event;
  const char* code;
  bool holds;
  bool alarms;
};
class ForceEventOf : public ForceControlOfAChannel, public ::testing::WithParamInterface<Told> {};

TEST_P(ForceEventOf, IsToldByItsCode) {
  const Told& told = GetParam();
  modifier.event_to_tell = told.event;
  modifier.event_cycle = 400;
  run("G0 X60 Z0\nG94 G1 Z-20 F600\nM30\n");
  EXPECT_THAT(bench->event_codes(), Contains(told.code));
  EXPECT_EQ(bench->channel(1).state == ChannelState::held, told.holds);
  if (told.holds) {
    EXPECT_EQ(bench->channel(1).hold_cause, HoldCause::sensor_fault);
    EXPECT_EQ(bench->channel(1).path_speed, 0.0);
  }
  if (told.alarms) {
    EXPECT_THAT(bench->alarm_codes(), ElementsAre(told.code));
  } else {
    EXPECT_THAT(bench->alarm_codes(), IsEmpty());
  }
}

INSTANTIATE_TEST_SUITE_P(
    All, ForceEventOf,
    ::testing::Values(Told{ForceEvent::sensor_lost, "A4010", true, true},
                      Told{ForceEvent::sensor_lost_slow, "A4010", false, true},
                      Told{ForceEvent::no_answer, "A4011", true, true},
                      Told{ForceEvent::no_answer_slow, "A4011", false, true},
                      Told{ForceEvent::stays_high, "A4011", true, true},
                      Told{ForceEvent::stays_high_slow, "A4011", false, true},
                      Told{ForceEvent::below_idle, "A4011", true, true},
                      Told{ForceEvent::below_idle_slow, "A4011", false, true},
                      Told{ForceEvent::vibration_lost, "W611", false, false},
                      Told{ForceEvent::frequency_shifted, "W612", false, false},
                      Told{ForceEvent::oscillation_limited, "W613", false, false},
                      Told{ForceEvent::overload_at_feed_min, "W614", false, false},
                      Told{ForceEvent::force_missing, "W615", false, false},
                      Told{ForceEvent::cut_is_lighter, "W616", false, false}),
    [](const auto& test) {
      return std::string(test.param.code) + (test.param.holds ? "_holds_" : "_goes_on_") +
             std::to_string(static_cast<int>(test.param.event));
    });

OperatorEvent adaptive(ForceAction action, const char* quantity, double value) {
  OperatorEvent event;
  event.command = command_of({.action = OperatorAction::process_adaptive,
                              .number = static_cast<int>(action),
                              .value = value,
                              .text = ShortText(quantity)})
                      .value();
  event.channel = 1;
  return event;
}

TEST_F(ForceControlOfAChannel, TakesTheOrdersOfAnOperator) {
  for (const OperatorEvent& event :
       {adaptive(ForceAction::on, "force", 1500.0), adaptive(ForceAction::set, "level", 7.0),
        adaptive(ForceAction::set, "mass", 3.0), adaptive(ForceAction::set, "frequency", 5.0),
        adaptive(ForceAction::set, "force", 800.0), adaptive(ForceAction::off, "", 0.0)}) {
    bench->ask(event);
    bench->cycle();
  }
  ASSERT_EQ(modifier.commands_taken, 6U);
  EXPECT_EQ(modifier.orders[0].kind, ForceCommand::Kind::force);
  EXPECT_EQ(modifier.orders[0].force_n, 1500.0);
  EXPECT_EQ(modifier.orders[1].kind, ForceCommand::Kind::adjust);
  EXPECT_EQ(modifier.orders[1].level_um, 7.0);
  EXPECT_EQ(modifier.orders[2].reduced_mass_kg, 3.0);
  EXPECT_EQ(modifier.orders[3].oscillation_hz, 5.0);
  EXPECT_EQ(modifier.orders[4].force_n, 800.0);
  EXPECT_EQ(modifier.orders[5].kind, ForceCommand::Kind::off);
  for (const OperatorReply& reply : bench->replies()) EXPECT_TRUE(reply.ok);
}

TEST_F(ForceControlOfAChannel, RefusesOrdersThatSayNothing) {
  bench->ask(adaptive(ForceAction::set, "", 5.0));
  bench->ask(adaptive(ForceAction::set, "level", 0.0));
  bench->ask(adaptive(ForceAction::on, "mass", 2.0));
  bench->cycle();
  ASSERT_EQ(bench->replies().size(), 3U);
  for (const OperatorReply& reply : bench->replies()) EXPECT_EQ(reply.code.view(), "E6061");
  EXPECT_EQ(modifier.commands_taken, 0U);
}

TEST(ForceControlOfAnotherChannel, IsNotThere) {
  MachineBench bench(testing::turning_machine());
  bench.ask(adaptive(ForceAction::on, "force", 1000.0));
  bench.cycle();
  ASSERT_FALSE(bench.replies().empty());
  EXPECT_EQ(bench.replies().back().code.view(), "E6060");
}

}  // namespace
}  // namespace stanok::channels
