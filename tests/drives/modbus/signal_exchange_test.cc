// Signals of programs: the requests they take, and their bits and values on the wire.
#include "drives/modbus/signal_exchange.h"

#include <gtest/gtest.h>

namespace stanok::drives {
namespace {

constexpr BusTime signal_timeout = std::chrono::milliseconds{250};

SignalConfig digital(SignalKind kind, int number, int unit, SignalTable table, int address,
                     int bit = 0) {
  return {.kind = kind,
          .number = number,
          .unit = unit,
          .table = table,
          .bit = bit,
          .field = {.address = address}};
}

TEST(SignalExchange, NeighboursOfAUnitGoInOneRequest) {
  using enum SignalKind;
  using enum SignalTable;
  SignalExchange exchange(
      {digital(digital_input, 5, 20, discrete_input, 3),
       digital(digital_input, 6, 20, discrete_input, 4),
       digital(digital_input, 7, 20, discrete_input, 9), digital(digital_output, 0, 20, coil, 5),
       digital(digital_input, 1, 21, discrete_input, 5)},
      signal_timeout);
  ASSERT_EQ(exchange.blocks().size(), 4U);
  EXPECT_EQ(exchange.blocks()[0].table, coil);
  EXPECT_TRUE(exchange.blocks()[0].is_output);
  EXPECT_EQ(exchange.blocks()[1].first, 3);
  EXPECT_EQ(exchange.blocks()[1].bits.size(), 2U);
  EXPECT_EQ(exchange.blocks()[2].first, 9);
  EXPECT_EQ(exchange.blocks()[3].unit, 21);
}

TEST(SignalExchange, OutputsShareTheirRegister) {
  using enum SignalKind;
  SignalConfig inverted = digital(digital_output, 63, 7, SignalTable::holding_register, 100, 15);
  inverted.is_inverted = true;
  SignalExchange exchange(
      {digital(digital_output, 0, 7, SignalTable::holding_register, 100, 1),
       digital(digital_output, 1, 7, SignalTable::holding_register, 100, 4),
       inverted,
       {.kind = analog_output,
        .number = 2,
        .unit = 7,
        .table = SignalTable::holding_register,
        .field = {.address = 101, .words = 2, .order = WordOrder::low_first, .scale = 1000.0}}},
      signal_timeout);
  Signals outputs;
  outputs.set(1, true);
  outputs.analog[2] = -70.0;  // -70000 = FFFE EE90 hex
  exchange.fill_outputs(outputs);
  ASSERT_EQ(exchange.blocks().size(), 1U);
  EXPECT_EQ(exchange.blocks()[0].words, (std::vector<std::uint16_t>{0x8010, 0xEE90, 0xFFFE}));
  outputs.set(63, true);
  exchange.fill_outputs(outputs);
  EXPECT_EQ(exchange.blocks()[0].words[0], 0x0010);
}

TEST(SignalExchange, InputsComeFromBitsAndRegisters) {
  using enum SignalKind;
  SignalConfig broken = digital(digital_input, 3, 7, SignalTable::discrete_input, 10);
  broken.is_inverted = true;
  SignalExchange exchange(
      {broken,
       digital(digital_input, 40, 7, SignalTable::input_register, 6, 9),
       {.kind = analog_input,
        .number = 15,
        .unit = 7,
        .table = SignalTable::input_register,
        .field = {.address = 7, .is_signed = true, .scale = 100.0, .offset = -50.0}}},
      signal_timeout);
  ASSERT_EQ(exchange.blocks().size(), 2U);
  exchange.blocks()[0].bits = {0};
  exchange.blocks()[1].words = {0x0200, 0xFFFF};
  for (const SignalBlock& block : exchange.blocks()) exchange.take(block);
  Signals wanted;
  wanted.set(3, true);
  wanted.set(40, true);
  wanted.analog[15] = 0.49;  // (-1 + 50) / 100
  EXPECT_EQ(exchange.inputs(), wanted);
  exchange.blocks()[0].bits = {1};
  exchange.take(exchange.blocks()[0]);
  EXPECT_FALSE(exchange.inputs().is_on(3));
}

TEST(SignalExchange, ASilentUnitIsLeftAloneForTheTimeoutAndTheOthersAreNot) {
  using enum SignalKind;
  SignalExchange exchange({digital(digital_input, 0, 20, SignalTable::discrete_input, 0),
                           digital(digital_input, 1, 21, SignalTable::discrete_input, 0)},
                          signal_timeout);
  const BusTime now = std::chrono::seconds{5};
  exchange.fail(exchange.blocks()[0], now);
  EXPECT_FALSE(exchange.is_due(exchange.blocks()[0], now + signal_timeout - BusTime{1}));
  EXPECT_TRUE(exchange.is_due(exchange.blocks()[1], now));
  EXPECT_TRUE(exchange.is_due(exchange.blocks()[0], now + signal_timeout));
}

}  // namespace
}  // namespace stanok::drives
