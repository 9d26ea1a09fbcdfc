// Encoders that flicker: at rest the cycle is given what does not change.
#include "runtime/drive_side/steady_feedback.h"

#include <gtest/gtest.h>

#include <array>

namespace stanok::runtime {
namespace {

constexpr double increment = 0.001;  // mm

class SteadyFeedbackTest : public ::testing::Test {
 protected:
  SteadyFeedbackTest() {
    last.channel_count = 1;
    for (channels::AxisFeedback& axis : told) axis = {.position = 5.0, .valid = true};
    static_cast<void>(given());
  }
  static channels::MachineConfig two_axes() {
    channels::MachineConfig config;
    config.axes.resize(2);
    config.cycle_us = 1000;
    for (channels::AxisConfig& axis : config.axes) axis.resolution = increment;
    return config;
  }
  [[nodiscard]] channels::AxisFeedback given() { return steady.of(told, last)[1]; }

  channels::MachineConfig config = two_axes();
  SteadyFeedback steady{config, {}};
  std::array<channels::AxisFeedback, 2> told;
  channels::CycleOutput last;
};

TEST_F(SteadyFeedbackTest, AnIncrementOfNoiseIsNone) {
  for (const double noise : {increment, -increment, 0.0, increment}) {
    told[1].position = 5.0 + noise;
    EXPECT_EQ(given().position, 5.0);
  }
}

TEST_F(SteadyFeedbackTest, MoreThanNoiseIsGivenAsItIsTold) {
  told[1].position = 5.0 + 3.0 * increment;
  EXPECT_EQ(given().position, told[1].position);
}

// What came to rest with its noise at one end: of two increments between both ends one is given.
TEST_F(SteadyFeedbackTest, ItIsSteadyWhereverItBegan) {
  told[1].position = 7.0 + increment;
  static_cast<void>(given());
  told[1].position = 7.0 - increment;
  const double steady_position = given().position;
  EXPECT_NEAR(steady_position, 7.0, 1e-8);
  for (const double noise : {increment, -increment, 0.0, increment, increment, -increment}) {
    told[1].position = 7.0 + noise;
    EXPECT_EQ(given().position, steady_position);
  }
}

TEST_F(SteadyFeedbackTest, AnAxisThatCreepsIsFollowed) {
  for (int k = 0; k < 1000; ++k) {
    told[1].position += 0.1 * increment;
    EXPECT_NEAR(given().position, told[1].position, increment * 1.01);
  }
}

TEST_F(SteadyFeedbackTest, AVelocityOfTheLastDigitIsNone) {
  told[1].velocity = -1.0;  // an increment in a cycle
  EXPECT_EQ(given().velocity, 0.0);
  told[1].velocity = 1.1;
  EXPECT_EQ(given().velocity, 1.1);
}

TEST_F(SteadyFeedbackTest, WhateverElseIsToldIsGiven) {
  told[1].position = 5.0 + increment;
  told[1].fault = true;
  told[1].index_count = 7;
  told[1].setpoint = 1.0;
  const channels::AxisFeedback one = given();
  EXPECT_TRUE(one.fault);
  EXPECT_EQ(one.index_count, 7U);
  EXPECT_EQ(one.setpoint, 1.0);
  EXPECT_EQ(one.position, 5.0);
}

TEST_F(SteadyFeedbackTest, InMotionAndInARunEverythingIsGiven) {
  told[1].position = 5.0 + increment;
  told[1].velocity = 0.5;
  last.channels[0].running = true;
  EXPECT_EQ(given(), told[1]);
  last.channels[0].running = false;
  last.channels[0].moving = true;
  EXPECT_EQ(given(), told[1]);
}

TEST(SteadyFeedbackOfIdealDrives, IsNone) {
  const channels::MachineConfig config;
  SteadyFeedback steady(config, {});
  EXPECT_TRUE(steady.of({}, {}).empty());
}

}  // namespace
}  // namespace stanok::runtime
