// Words and bits of an inverter: 1 stops, 18 runs forward, 34 runs backward, 2 resets; status bits
// 0 and 1 set: running, bit 7: fault.
#include "drives/run_words.h"

#include <gtest/gtest.h>

#include "drives/modbus/axis_exchange.h"

namespace stanok::drives {
namespace {

const RunWords inverter_words{.stop = 1,
                              .run = 18,
                              .run_reverse = 34,
                              .fault_reset = 2,
                              .running = {.mask = 3, .value = 3},
                              .fault = {.mask = 0x80, .value = 0x80}};

TEST(RunWords, DirectionStandsInTheWord) {
  EXPECT_EQ(run_word(inverter_words, PowerRequest::on, 1500.0), 18);
  EXPECT_EQ(run_word(inverter_words, PowerRequest::on, -1500.0), 34);
  EXPECT_EQ(run_word(inverter_words, PowerRequest::on, 0.0), 1);
  EXPECT_EQ(run_word(inverter_words, PowerRequest::off, 1500.0), 1);
  EXPECT_EQ(run_word(inverter_words, PowerRequest::quick_stop, 1500.0), 1);
  EXPECT_EQ(run_word(inverter_words, PowerRequest::reset_fault, 0.0), 2);
}

TEST(RunWords, WithoutAReverseWordTheSignStandsInTheVelocity) {
  const RunWords plain{.stop = 0, .run = 1};
  EXPECT_EQ(run_word(plain, PowerRequest::on, -5.0), 1);
  EXPECT_EQ(run_word(plain, PowerRequest::on, 0.0), 1);
  EXPECT_EQ(run_word(plain, PowerRequest::reset_fault, 0.0), 0);
}

TEST(RunWords, StatusBitsSayWhatTheDriveDoes) {
  EXPECT_EQ(state_of(inverter_words, 0x0003, 18), DriveState::operation_enabled);
  EXPECT_EQ(state_of(inverter_words, 0x0001, 18), DriveState::ready_to_switch_on);
  EXPECT_EQ(state_of(inverter_words, 0x0083, 18), DriveState::fault);
}

TEST(RunWords, AContactorIsBelievedToDoWhatItIsTold) {
  const RunWords contactor{.stop = 0, .run = 1};
  EXPECT_EQ(state_of(contactor, 0, 1), DriveState::operation_enabled);
  EXPECT_EQ(state_of(contactor, 0, 0), DriveState::ready_to_switch_on);
}

TEST(RunWords, AnExchangeWritesMagnitudeAndReadsItBackWithSign) {
  AxisDriveConfig drive{
      .axis = "S1", .spindle = 1, .kind = DriveKind::velocity, .map = {}, .words = inverter_words};
  drive.map.control_word = {.address = 0};
  drive.map.target_velocity = {.address = 1, .scale = 0.5};
  drive.map.status_word = {.address = 2};
  drive.map.velocity = {.address = 3, .scale = 0.5};
  AxisExchange exchange(drive, std::chrono::milliseconds{10}, std::chrono::milliseconds{250});
  DriveTarget target{
      .velocity = -3000.0, .mode = OperationMode::cyclic_synchronous_velocity, .enabled = true};
  const CommandBlock command = exchange.command(target, TargetAge::fresh);
  EXPECT_EQ(command.control_word, 34);
  EXPECT_EQ(command.target_velocity, 1500);
  EXPECT_EQ(exchange.take({.status_word = 3, .velocity = 1490}, BusTime{0}, BusTime{0}),
            std::nullopt)
      << "no echo is asked of a drive without one";
  EXPECT_EQ(exchange.feedback().velocity, -2980.0);
  EXPECT_EQ(exchange.feedback().state, DriveState::operation_enabled);
}

}  // namespace
}  // namespace stanok::drives
