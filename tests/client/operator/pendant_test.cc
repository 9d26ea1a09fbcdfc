// What the events of a wheel and of keys ask of the machine.
#include "client/operator/pendant.h"

#include <gtest/gtest.h>

namespace stanok::client {
namespace {

constexpr double now = 1000.0;

input_event event_of(int type, int code, int value, double time_s = now) {
  input_event event{};
  event.input_event_sec = static_cast<decltype(event.input_event_sec)>(time_s);
  const double part = time_s - static_cast<double>(event.input_event_sec);
  event.input_event_usec = static_cast<decltype(event.input_event_usec)>(1e6 * part);
  event.type = static_cast<__u16>(type);
  event.code = static_cast<__u16>(code);
  event.value = value;
  return event;
}
input_event notch(int count, double time_s = now) {
  return event_of(EV_REL, REL_DIAL, count, time_s);
}
input_event press(int code) {
  return event_of(EV_KEY, code, 1);
}

class PendantTest : public ::testing::Test {
 protected:
  Pendant pendant{{.axis = "X",
                   .step = 0.01,
                   .keys = {{256, pendant::ChooseAxis{"Y"}},
                            {257, pendant::ChooseStep{0.5}},
                            {258, pendant::Hold{}},
                            {259, pendant::Resume{}}}}};

  std::vector<pendant::Order> orders(std::vector<input_event> events) {
    return pendant.orders(events, now);
  }
};

TEST_F(PendantTest, NotchesOfOneAxisAreOneWay) {
  const auto found = orders({notch(1), event_of(EV_SYN, 0, 0), notch(1), notch(-3)});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(std::get<pendant::Turn>(found[0]).axis, "X");
  EXPECT_NEAR(std::get<pendant::Turn>(found[0]).way, -0.01, 1e-15);
}

TEST_F(PendantTest, KeysChooseAxisAndStep) {
  const auto found = orders({notch(2), press(256), notch(1), press(257), notch(-1)});
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(std::get<pendant::Turn>(found[0]), (pendant::Turn{"X", 0.02}));
  EXPECT_EQ(std::get<pendant::Turn>(found[1]).axis, "Y");
  EXPECT_NEAR(std::get<pendant::Turn>(found[1]).way, 0.01 - 0.5, 1e-15);
}

TEST_F(PendantTest, HoldAndResumeStandWhereTheyWerePressed) {
  const auto found = orders({notch(1), press(258), notch(1), press(259), press(300)});
  ASSERT_EQ(found.size(), 4U);
  EXPECT_TRUE(std::holds_alternative<pendant::Hold>(found[1]));
  EXPECT_TRUE(std::holds_alternative<pendant::Resume>(found[3]));
}

// Of a program that stood still: nobody waits for it any more. A hold is obeyed however late.
TEST_F(PendantTest, WhatIsLateIsDropped) {
  input_event late = press(258);
  late.input_event_sec -= 20;
  const auto found = orders({notch(1, now - 0.5), notch(1, now - 0.1), late});
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(std::get<pendant::Turn>(found[0]).way, 0.01);
  EXPECT_TRUE(std::holds_alternative<pendant::Hold>(found[1]));
  EXPECT_EQ(pendant.dropped(), 1);
}

TEST(PendantWithoutAxis, MovesNothing) {
  Pendant pendant({.axis = "", .step = 0.01, .keys = {{256, pendant::ChooseAxis{"Z"}}}});
  EXPECT_TRUE(pendant.orders(std::vector{notch(1)}, now).empty());
  EXPECT_EQ(pendant.orders(std::vector{press(256), notch(1)}, now).size(), 1U);
}

TEST(PendantKeys, SayWhatTheyDo) {
  EXPECT_TRUE(std::holds_alternative<pendant::Hold>(*pendant::key_effect("hold")));
  EXPECT_TRUE(std::holds_alternative<pendant::Resume>(*pendant::key_effect("resume")));
  EXPECT_EQ(std::get<pendant::ChooseStep>(*pendant::key_effect("step:0.1")).step, 0.1);
  EXPECT_EQ(std::get<pendant::ChooseAxis>(*pendant::key_effect("X1")).axis, "X1");
  for (const char* const wrong : {"", "step:", "step:-1", "step:0.1mm", "step:nan"})
    EXPECT_FALSE(pendant::key_effect(wrong)) << wrong;
}

TEST(PendantEvents, AreShownToFindTheirCodes) {
  EXPECT_EQ(text_of(notch(-2)), "wheel 7 -2");
  EXPECT_EQ(text_of(press(256)), "key 256 down");
  EXPECT_EQ(text_of(event_of(EV_KEY, 256, 0)), "key 256 up");
  EXPECT_EQ(text_of(event_of(EV_KEY, 256, 2)), "");
  EXPECT_EQ(text_of(event_of(EV_SYN, 0, 0)), "");
}

}  // namespace
}  // namespace stanok::client
