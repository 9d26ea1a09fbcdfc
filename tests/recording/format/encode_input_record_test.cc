// Input records in their recorded form: the numbers are a format, written down here once more.
#include "recording/format/encode_input_record.h"

#include <gtest/gtest.h>

#include <vector>

#include "base/signals.h"

namespace stanok::recording {
namespace {

using namespace channels;

struct Recorded {
  InputContent content;
  int kind = 0;
  int method = 0;
  int number = 0;
  double value = 0.0;
  double value_2 = 0.0;
  const char* text = "";
};

std::vector<Recorded> all_inputs() {
  const OperatorCommand jog = commands::Jog{ShortText("X"), 20.0, 0.5};
  return {
      {jog, 0, 22, 0, 20.0, 0.5, "X"},
      {OperatorCommand(commands::ChannelControl{7}), 0, 28, 7},
      {DigitalInput{40, true}, 3, 40, 0, 1.0},
      {DigitalInput{5, false}, 3, 5},
      {AnalogInput{3, 2.5}, 3, Signals::digital_count + 3, 0, 2.5},
      {Overrun{12}, 4, 0, 0, 12.0},
      {SpindleInput{1, SpindleQuantity::power_w, 700.0}, 5, 1, 0, 700.0},
      {SpindleInput{1, SpindleQuantity::vibration_um, 1.5}, 5, 1, 1, 1.5},
      {SpindleInput{0, SpindleQuantity::vibration_hz, 400.0}, 5, 0, 2, 400.0},
      {LostInputs{0}, 6},
      {LostInputs{85}, 6, 0, 0, 85.0},
      {TableTaking{.run = 3, .command = 250, .version = 12}, 7, 3, 0, 250.0, 12.0},
  };
}

TEST(InputRecordTest, EachHasItsRecordedFormAndComesBack) {
  std::size_t alternatives = 0;
  for (const Recorded& row : all_inputs()) {
    SCOPED_TRACE("alternative " + std::to_string(row.content.index()));
    alternatives |= std::size_t{1} << row.content.index();
    const input_t message = to_input({.cycle = 1234, .channel = 2, .content = row.content},
                                     {.utime = 5, .cycle = 1234, .seq = 9});
    EXPECT_EQ(message.utime, 5);
    EXPECT_EQ(message.cycle, 1234);
    EXPECT_EQ(message.seq, 9);
    EXPECT_EQ(message.channel, 2);
    EXPECT_EQ(message.kind, row.kind);
    EXPECT_EQ(message.method, row.method);
    EXPECT_EQ(message.number, row.number);
    EXPECT_EQ(message.value, row.value);
    EXPECT_EQ(message.value_2, row.value_2);
    EXPECT_EQ(text_of(message.text), row.text);

    const InputRecord back = from_input(message);
    EXPECT_EQ(back.cycle, 1234);
    EXPECT_EQ(back.channel, 2);
    ASSERT_EQ(back.content.index(), row.content.index());
    const input_t again = to_input(back, {.utime = 5, .cycle = 1234, .seq = 9});
    EXPECT_EQ(again.method, row.method);
    EXPECT_EQ(again.number, row.number);
    EXPECT_EQ(again.value, row.value);
    EXPECT_EQ(again.value_2, row.value_2);
    EXPECT_EQ(text_of(again.text), row.text);
  }
  // All but UnknownInput, the last one.
  EXPECT_EQ(alternatives, (std::size_t{1} << (std::variant_size_v<InputContent> - 1)) - 1);
}

// Logs may come from anywhere.
TEST(InputRecordTest, WhatThisVersionDoesNotKnowIsSaidToBeUnknown) {
  const auto is_unknown = [](int kind, int method, int number) {
    input_t message = to_input({.content = LostInputs{}}, {});
    message.kind = static_cast<std::int8_t>(kind);
    message.method = method;
    message.number = number;
    return std::holds_alternative<UnknownInput>(from_input(message).content);
  };
  EXPECT_TRUE(is_unknown(0, -1, 0));
  EXPECT_TRUE(is_unknown(0, static_cast<int>(std::variant_size_v<OperatorCommand>), 0));
  EXPECT_TRUE(is_unknown(0, 256, 0)) << "it is not action 0";
  EXPECT_TRUE(is_unknown(1, 0, 0));
  EXPECT_TRUE(is_unknown(3, -1, 0));
  EXPECT_TRUE(is_unknown(3, Signals::digital_count + Signals::analog_count, 0));
  EXPECT_TRUE(is_unknown(5, 0, 3));
  EXPECT_TRUE(is_unknown(5, -1, 0));
  EXPECT_TRUE(is_unknown(8, 0, 0));
  EXPECT_FALSE(is_unknown(5, 0, 2));
}

}  // namespace
}  // namespace stanok::recording
