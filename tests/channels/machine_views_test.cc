// What motion and the interpreter are told of a machine: motion_config, channel_description.
#include <gtest/gtest.h>

#include "channels/contract/channel_description.h"
#include "channels/contract/motion_config.h"

namespace stanok::channels {
namespace {

// Two channels; the second calls its axes X2, C2, Z2 by the words X, C, Z.
MachineConfig two_channels() {
  MachineConfig machine;
  machine.cycle_us = 500;
  for (const char* name : {"X1", "X2", "C2", "Z2"}) {
    AxisConfig axis;
    axis.name = name;
    axis.rotary = axis.name == "C2";
    axis.modulo_deg = axis.rotary ? 360.0 : 0.0;
    axis.limits.velocity_max = 100.0 + static_cast<double>(machine.axes.size());
    machine.axes.push_back(axis);
  }
  ChannelConfig first;
  first.id = 1;
  first.axes = {0};
  first.words = {"X"};
  first.schemes.resize(1);
  first.schemes[0].id = 4;
  ChannelConfig second;
  second.id = 2;
  second.name = "lower";
  second.kind = lang::ChannelKind::lathe;
  second.axes = {1, 2, 3};
  second.words = {"X", "C", "Z"};
  second.spindles = {2, 3};
  second.path_tolerance_mm = 0.02;
  second.orientation_tolerance_deg = 0.1;
  second.arc_radius_tolerance_mm = 0.005;
  machine.channels = {first, second};
  return machine;
}

TEST(MotionConfig, TakesLimitsInTheOrderOfTheChannelAndGeometryByWord) {
  const MachineConfig machine = two_channels();
  const motion::MotionConfig config = motion_config(machine, machine.channels[1]);
  EXPECT_EQ(config.axis_count, 3);
  EXPECT_EQ(config.geometry, (std::array<int, 3>{0, -1, 2}));
  EXPECT_EQ(config.axes[0].velocity_max, 101.0);
  EXPECT_EQ(config.axes[2].velocity_max, 103.0);
  EXPECT_TRUE(config.axes[0].linear);
  EXPECT_FALSE(config.axes[1].linear);
  EXPECT_DOUBLE_EQ(config.cycle_s, 0.0005);
  EXPECT_EQ(config.path_tolerance_mm, 0.02);
  EXPECT_EQ(config.orientation_tolerance_deg, 0.1);
}

TEST(ChannelDescription, TellsTheInterpreterAxesSpindlesAndAllSchemes) {
  const MachineConfig machine = two_channels();
  const lang::ChannelDescription description = channel_description(machine, machine.channels[1]);
  EXPECT_EQ(description.id, 2);
  EXPECT_EQ(description.name, "lower");
  EXPECT_EQ(description.kind, lang::ChannelKind::lathe);
  ASSERT_EQ(description.axes.size(), 3U);
  EXPECT_EQ(description.axes[0].word, "X");
  EXPECT_EQ(description.axes[0].geometry, 0);
  EXPECT_EQ(description.axes[1].word, "C");
  EXPECT_TRUE(description.axes[1].rotary);
  EXPECT_EQ(description.axes[1].modulo_deg, 360.0);
  EXPECT_EQ(description.axes[1].geometry, -1);
  EXPECT_EQ(description.axes[2].geometry, 2);
  EXPECT_EQ(description.spindles, (std::vector<int>{2, 3}));
  EXPECT_EQ(description.channels, (std::vector<int>{1, 2}));
  EXPECT_EQ(description.schemes, (std::vector<std::pair<int, int>>{{1, 4}}));
  EXPECT_EQ(description.arc_radius_tolerance_mm, 0.005);
}

// Of X 0.002 and Z 0.0005 mm; the 0.0001 deg of C are no length. A channel of rotary axes has none.
TEST(ChannelDescription, KnowsTheFinestResolutionOfItsLinearAxes) {
  MachineConfig machine = two_channels();
  machine.axes[1].resolution = 0.002;
  machine.axes[2].resolution = 0.0001;
  machine.axes[3].resolution = 0.0005;
  EXPECT_EQ(channel_description(machine, machine.channels[1]).finest_resolution_mm, 0.0005);
  machine.channels[0].axes = {2};
  EXPECT_EQ(channel_description(machine, machine.channels[0]).finest_resolution_mm, 0.0);
}

// The address as the language spells it; a letter that is no alias is left out.
TEST(ChannelDescription, TakesTheLettersOfNamedAddresses) {
  MachineConfig machine = two_channels();
  machine.channels[1].address_alias = {{"E", "ds"}, {"X", "dl"}};
  const auto aliases = channel_description(machine, machine.channels[1]).address_alias;
  ASSERT_EQ(aliases.size(), 1U);
  EXPECT_EQ(aliases[0].letter, 'E');
  EXPECT_EQ(aliases[0].address, "dS");
}

}  // namespace
}  // namespace stanok::channels
