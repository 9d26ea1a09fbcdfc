// What `simulate --why` says of cycles that are made by hand.
#include "client/offline/simulate/speed_limits.h"

#include <gtest/gtest.h>

namespace stanok::client {
namespace {

class SpeedLimitsTest : public ::testing::Test {
 protected:
  SpeedLimitsTest() {
    machine_.cycle_us = 1000;
    for (const char* const name : {"X", "Y"}) {
      channels::AxisConfig axis;
      axis.name = name;
      axis.limits.velocity_max = 200.0;
      axis.limits.acceleration_max = 1000.0;
      axis.limits.jerk_max = 10000.0;
      machine_.axes.push_back(axis);
    }
    channels::ChannelConfig channel;
    channel.axes = {0, 1};
    channel.words = {"X", "Y"};
    machine_.channels.push_back(channel);
    channel_.id = 1;
    channel_.axis_count = 2;
    channel_.running = true;
    channel_.moving = true;
    channel_.state = channels::ChannelState::running;
    channel_.tag.line = 7;
    channel_.feed_commanded = 100.0;
    channel_.path_speed = 50.0;
  }
  // The causes of line 7 after a cycle with this output, and one before at the same speed.
  nlohmann::ordered_json cause() {
    SpeedLimits limits(machine_, {{.file = "", .line = 7}});
    channels::CycleOutput output;
    output.channel_count = 1;
    output.channels[0] = channel_;
    output.channels[0].tag.line = 6;
    output.channels[0].path_speed = before_;
    limits.observe(output);
    output.channels[0] = channel_;
    limits.observe(output);
    const auto json = limits.json({});
    EXPECT_EQ(json.size(), 1U);
    EXPECT_EQ(json.at(0).at("line"), 7);
    EXPECT_EQ(json.at(0).at("time_s"), 0.001);
    return json.at(0).at("causes").at(0);
  }

  channels::MachineConfig machine_;
  channels::ChannelOutput channel_;
  double before_ = 50.0;
};

TEST_F(SpeedLimitsTest, TheFeed) {
  channel_.path_speed = 100.0;
  EXPECT_EQ(cause().at("cause"), "feed");
}

TEST_F(SpeedLimitsTest, AnOverride) {
  channel_.feed_override = 0.5;
  EXPECT_EQ(cause().at("cause"), "feed override");
}

TEST_F(SpeedLimitsTest, ALaw) {
  channel_.path_speed = 100.0;
  channel_.process.law = motion::LawKind::linear;
  EXPECT_EQ(cause().at("cause"), "law");
}

TEST_F(SpeedLimitsTest, TheAxisThatUsesMostOfItsLimits) {
  channel_.axes[0].acceleration = 900.0;
  channel_.axes[1].jerk = -9900.0;
  const auto found = cause();
  EXPECT_EQ(found.at("cause"), "jerk");
  EXPECT_EQ(found.at("axis"), "Y");
  EXPECT_EQ(found.at("in_curve"), true);
}

TEST_F(SpeedLimitsTest, ARampIsNoCurve) {
  channel_.axes[0].acceleration = 990.0;
  before_ = 49.1;
  EXPECT_EQ(cause().at("in_curve"), false);
}

TEST_F(SpeedLimitsTest, NoneAtItsLimit) {
  channel_.axes[0].acceleration = 300.0;
  EXPECT_EQ(cause().at("cause"), "between limits");
}

TEST_F(SpeedLimitsTest, HoldAndRest) {
  channel_.state = channels::ChannelState::held;
  EXPECT_EQ(cause().at("cause"), "hold");
  channel_.state = channels::ChannelState::running;
  channel_.moving = false;
  EXPECT_EQ(cause().at("cause"), "standing");
}

TEST_F(SpeedLimitsTest, LinesThatWereNotRunAreSaidSo) {
  EXPECT_EQ(SpeedLimits(machine_, {{.file = "", .line = 3}}).text({}),
            "no line asked for was run\n");
}

// Line 7 of the program, of a file that it calls, and of another program on the same channel.
TEST_F(SpeedLimitsTest, AFileIsNamed) {
  const auto lines_of = [&](std::vector<AskedLine> asked) {
    SpeedLimits limits(machine_, std::move(asked));
    channels::CycleOutput output;
    output.channel_count = 1;
    for (const std::uint32_t run : {1U, 2U, 3U}) {
      for (const std::uint16_t file : {std::uint16_t{0}, std::uint16_t{1}}) {
        output.channels[0] = channel_;
        output.channels[0].tag = {.run = run, .line = 7, .file = file};
        limits.observe(output);
      }
    }
    const auto report = [](std::uint32_t run, const char* program) {
      channels::RunReport ended;
      ended.channel = 1;
      ended.run = run;
      ended.files = {std::string("/jobs/") + program, "/jobs/sub.nc"};
      return ended;
    };
    std::vector<std::string> lines;
    for (const auto& line : limits.json({report(1, "a.nc"), report(2, "b.nc"), report(3, "b.nc")}))
      lines.push_back(line.at("file").get<std::string>() + " " + line.at("time_s").dump());
    return lines;
  };
  using Lines = std::vector<std::string>;
  EXPECT_EQ(lines_of({{.file = "", .line = 7}}), (Lines{"/jobs/a.nc 0.001", "/jobs/b.nc 0.002"}));
  EXPECT_EQ(lines_of({{.file = "sub.nc", .line = 7}}), (Lines{"/jobs/sub.nc 0.003"}));
  EXPECT_EQ(lines_of({{.file = "jobs/b.nc", .line = 7}}), (Lines{"/jobs/b.nc 0.002"}));
  EXPECT_EQ(lines_of({{.file = "ub.nc", .line = 7}}), Lines{});
  EXPECT_EQ(lines_of({}).size(), 3U);
}

}  // namespace
}  // namespace stanok::client
