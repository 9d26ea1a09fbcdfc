// The message of force control: what it says, and that it is there only while the control is on.
#include <gtest/gtest.h>

#include "recording/format/channel_names.h"
#include "recording/format/encode.h"

namespace stanok::recording {
namespace {

TEST(EncodeForce, TellsTheControlOfTheCuttingForce) {
  channels::ChannelOutput output;
  output.id = 2;
  output.process.has_force_control = true;
  output.process.force = {.state = motion::ForceState::regulating,
                          .force_set_n = 1200.0,
                          .force_now_n = 1260.0,
                          .force_n = 1195.0,
                          .power_w = 2400.0,
                          .power_idle_w = 250.0,
                          .radius_mm = 30.0,
                          .feed_per_s = 2.5,
                          .feed_min_per_s = 0.5,
                          .feed_max_per_s = 6.0,
                          .vibration_um = 8.0,
                          .vibration_hz = 110.0,
                          .oscillation_n = 60.0,
                          .oscillation_hz = 4.0};
  const force_status_t message = to_force_status(output, {.utime = 1000, .cycle = 1, .seq = 0});
  EXPECT_EQ(message.channel, 2);
  EXPECT_EQ(message.control, 3);
  EXPECT_EQ(message.force_set, 1200.0);
  EXPECT_EQ(message.force_set_now, 1260.0);
  EXPECT_EQ(message.force, 1195.0);
  EXPECT_EQ(message.power, 2400.0);
  EXPECT_EQ(message.power_idle, 250.0);
  EXPECT_EQ(message.radius, 30.0);
  EXPECT_EQ(message.feed, 2.5);
  EXPECT_EQ(message.feed_min, 0.5);
  EXPECT_EQ(message.feed_max, 6.0);
  EXPECT_EQ(message.vibration, 8.0);
  EXPECT_EQ(message.vibration_rate, 110.0);
  EXPECT_EQ(message.oscillation, 60.0);
  EXPECT_EQ(message.oscillation_rate, 4.0);
}

TEST(EncodeForce, HasAChannelOfItsOwn) {
  EXPECT_EQ(ChannelNames("lathe").name(1, Topic::force), "STANOK_LATHE_CH1_FORCE");
  EXPECT_EQ(topic_of("STANOK_LATHE_CH1_FORCE"), "FORCE");
}

}  // namespace
}  // namespace stanok::recording
