// The scope: every cycle once, from before the trigger, within its bounds.
#include "daemon/scope/scope.h"

#include <gtest/gtest.h>

#include <cmath>

#include "daemon/scope/scope_desk.h"
#include "tests/daemon/fake_machine.h"

namespace stanok::daemon {
namespace {

using nlohmann::json;

// X2 goes up by 1 mm a cycle, from 0 in cycle 0.
class ScopeTest : public ::testing::Test {
 protected:
  ScopeTest() {
    file.machine.cycle_us = 1000;
    file.machine.axes[0].limits.velocity_max = 250.0;
    output.channel_count = 2;
    output.channels[0].id = 1;
    output.channels[0].axis_count = 2;
    output.channels[1].id = 2;
  }
  void cycle(std::int64_t number) {
    output.cycle = number;
    output.channels[0].axes[0].position = static_cast<double>(number);
    scope.take({output, {.latency_ns = 1500, .duration_ns = 80'000}});
  }
  void cycles(std::int64_t from, std::int64_t to) {
    for (std::int64_t number = from; number < to; ++number) cycle(number);
  }
  void start(const json& parameters) {
    const auto started = start_scope(scope, file.machine, parameters);
    ASSERT_TRUE(started) << started.error().message;
  }
  std::string refusal(const json& parameters) {
    const auto started = start_scope(scope, file.machine, parameters);
    return started ? "" : started.error().message;
  }

  config::MachineFile file = two_channel_machine();
  channels::CycleOutput output;
  Scope scope;
};

TEST_F(ScopeTest, RecordsEveryCycleFromTheStartWithoutATrigger) {
  cycles(0, 50);
  start({{"signals", "X2.position cycle.time, cycle.latency"}, {"length_s", 0.01}});
  cycles(50, 100);
  const ScopeReading reading = scope.read(0);
  EXPECT_EQ(reading.state, ScopeState::complete);
  EXPECT_EQ(reading.cycles, 10U);
  EXPECT_EQ(reading.first_cycle, 50);
  EXPECT_EQ(reading.trigger_cycle, 0U);
  ASSERT_EQ(reading.values.size(), 30U);
  for (std::size_t k = 0; k < 10; ++k) {
    EXPECT_EQ(reading.values[3 * k], 50.0F + static_cast<float>(k));
    EXPECT_EQ(reading.values[3 * k + 1], 80.0F);
    EXPECT_EQ(reading.values[3 * k + 2], 1.5F);
  }
}

TEST_F(ScopeTest, ALevelIsCrossedNotStoodOn) {
  start({{"signals", "X2.position"},
         {"trigger", "level"},
         {"level", 40.0},
         {"before_s", 0.005},
         {"length_s", 0.02}});
  cycles(60, 80);
  EXPECT_EQ(scope.read(0).state, ScopeState::waiting) << "above from the beginning";
  EXPECT_EQ(scope.read(0).cycles, 6U) << "what is kept from before, and the cycle of now";
  cycles(20, 100);
  const ScopeReading reading = scope.read(0);
  EXPECT_EQ(reading.state, ScopeState::complete);
  EXPECT_EQ(reading.cycles, 20U);
  EXPECT_EQ(reading.trigger_cycle, 5U);
  EXPECT_EQ(reading.values[5], 40.0F);
  EXPECT_EQ(reading.values.front(), 35.0F);
  EXPECT_EQ(reading.values.back(), 54.0F);
}

TEST_F(ScopeTest, AFallingEdgeIsTheOtherOne) {
  start({{"signals", "X2.position"}, {"trigger", "level"}, {"level", 10.0}, {"edge", "falling"}});
  cycles(0, 30);
  EXPECT_EQ(scope.read(0).state, ScopeState::waiting);
  cycle(9);
  EXPECT_EQ(scope.read(0).state, ScopeState::recording);
}

TEST_F(ScopeTest, BlockAlarmAndEventBeginWhatTheyAre) {
  start({{"signals", "X2.position"}, {"trigger", "block"}, {"line", 12}, {"channel", 1}});
  output.channels[1].running = true;
  output.channels[1].tag.line = 12;
  cycles(0, 3);
  EXPECT_EQ(scope.read(0).state, ScopeState::waiting) << "of another channel";
  output.channels[0].running = true;
  output.channels[0].tag.line = 12;
  cycle(3);
  EXPECT_EQ(scope.read(0).state, ScopeState::recording);

  output.channels[0].state = channels::ChannelState::alarm;
  start({{"signals", "X2.position"}, {"trigger", "alarm"}});
  cycles(4, 6);
  EXPECT_EQ(scope.read(0).state, ScopeState::waiting) << "it stood already";
  output.channels[0].state = channels::ChannelState::idle;
  cycle(6);
  output.channels[0].state = channels::ChannelState::alarm;
  cycle(7);
  EXPECT_EQ(scope.read(0).state, ScopeState::recording);

  start({{"signals", "X2.position"}, {"trigger", "event"}, {"event", "E6010"}});
  channels::Event event;
  event.code = FixedText<8>("E6011");
  scope.take(event);
  cycle(8);
  EXPECT_EQ(scope.read(0).state, ScopeState::waiting);
  event.code = FixedText<8>("E6010");
  scope.take(event);
  cycle(9);
  EXPECT_EQ(scope.read(0).state, ScopeState::recording);
}

TEST_F(ScopeTest, CyclesThatWereLostKeepTheirPlace) {
  start({{"signals", "X2.position"}, {"length_s", 0.01}});
  cycle(100);
  cycle(104);
  cycles(105, 200);
  const ScopeReading reading = scope.read(0);
  ASSERT_EQ(reading.values.size(), 10U);
  for (const std::size_t k : {1U, 2U, 3U}) EXPECT_TRUE(std::isnan(reading.values[k])) << k;
  EXPECT_EQ(reading.values[4], 104.0F);
  EXPECT_EQ(reading.values[9], 109.0F);
}

TEST_F(ScopeTest, IsReadInPartsAndStaysWhenItIsStopped) {
  start({{"signals", "X2.position"}, {"length_s", 20.0}});
  cycles(0, 10'000);
  scope.stop();
  cycles(10'000, 11'000);
  EXPECT_EQ(scope.read(0).state, ScopeState::complete);
  std::vector<float> all;
  while (all.size() < scope.read(0).cycles) {
    const ScopeReading part = scope.read(all.size());
    ASSERT_FALSE(part.values.empty());
    EXPECT_LE(part.values.size(), Scope::read_cycles_max);
    all.insert(all.end(), part.values.begin(), part.values.end());
  }
  ASSERT_EQ(all.size(), 10'000U);
  for (std::size_t k = 0; k < all.size(); ++k) ASSERT_EQ(all[k], static_cast<float>(k));
  EXPECT_TRUE(scope.read(1'000'000).values.empty());
}

TEST_F(ScopeTest, WhatADriveDoesNotTellIsNoNumber) {
  start({{"signals", "X2.actual X2.error"}, {"length_s", 0.002}});
  cycle(1);
  output.channels[0].has_feedback = true;
  output.channels[0].feedback[0].valid = true;
  output.channels[0].feedback[0].position = 7.5;
  output.channels[0].feedback[0].setpoint = 7.75;
  cycle(2);
  const ScopeReading reading = scope.read(0);
  ASSERT_EQ(reading.values.size(), 4U);
  EXPECT_TRUE(std::isnan(reading.values[0]) && std::isnan(reading.values[1]));
  EXPECT_EQ(reading.values[2], 7.5F);
  EXPECT_EQ(reading.values[3], 0.25F);
}

TEST_F(ScopeTest, OrdersThatMakeNoSenseAreRefused) {
  EXPECT_NE(refusal({{"signals", "Q.position"}}).find("there is no signal Q.position"),
            std::string::npos);
  EXPECT_NE(refusal({{"signals", " , "}}), "");
  EXPECT_NE(
      refusal({{"signals", "B.jerk B.jerk B.jerk B.jerk B.jerk B.jerk B.jerk B.jerk B.jerk"}}), "");
  EXPECT_NE(refusal({{"signals", "B.jerk"}, {"trigger", "block"}}), "");
  EXPECT_NE(refusal({{"signals", "B.jerk"}, {"trigger", "level"}, {"signal", "X2.jerk"}}), "");
  EXPECT_NE(refusal({{"signals", "B.jerk"}, {"trigger", "alarm"}, {"before_s", 3}}), "");
  file.machine.cycle_us = 250;
  EXPECT_NE(refusal({{"signals", "B.jerk"}, {"length_s", 100}}).find("30 s"), std::string::npos);
  EXPECT_EQ(scope.read(0).state, ScopeState::off);
}

TEST_F(ScopeTest, SignalsHaveTheLimitsOfTheMachineFile) {
  const json list = scope_signal_list(file.machine)["signals"];
  const auto of = [&](const char* name) {
    return *std::find_if(list.begin(), list.end(),
                         [&](const json& s) { return s["name"] == name; });
  };
  EXPECT_EQ(of("X2.velocity")["limit"], 250.0);
  EXPECT_EQ(of("X2.velocity")["unit"], "mm/s");
  EXPECT_EQ(of("X2.position")["limit"], nullptr);
  EXPECT_EQ(of("cycle.time")["limit"], 1000.0);
  EXPECT_EQ(of("channel1.speed")["unit"], "mm/min");
}

}  // namespace
}  // namespace stanok::daemon
