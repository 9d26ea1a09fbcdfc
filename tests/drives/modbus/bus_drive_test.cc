// The parts that a bus is made of, each alone: a drive, a sensor, turns, connection, status.
#include "drives/modbus/bus_drive.h"

#include <gtest/gtest.h>

#include <vector>

#include "drives/modbus/bus_connection.h"
#include "drives/modbus/bus_sensor.h"
#include "drives/modbus/silent_turn.h"
#include "drives/modbus/status_board.h"

namespace stanok::drives {
namespace {

using std::chrono::milliseconds;

constexpr BusTime poll = milliseconds{10};
constexpr BusTime timeout = milliseconds{250};

AxisDriveConfig x_drive() {
  return {.axis = "X",
          .following_error_max = 0.5,
          .velocity_max = 400.0,
          .acceleration_max = 1e3,
          .target_acceleration_max = 1e3};
}

// The drive is switched off, and knows its position.
void answer(BusDrive& drive, const CommandBlock& sent) {
  const RegisterMap map = x_drive().map;
  const auto word = static_cast<std::uint16_t>(state_bits(DriveState::switch_on_disabled) |
                                               standard_bits.referenced);
  drive.image()[static_cast<std::size_t>(map.status_word.address)] = word;
  drive.image()[static_cast<std::size_t>(map.heartbeat_echo.address)] = sent.heartbeat;
}

TEST(BusDrive, IsLookedAtBeforeAnythingIsWritten) {
  BusDrive drive(x_drive(), poll, timeout);
  const auto look = drive.requests_to_look();
  ASSERT_FALSE(look.empty());
  for (const ModbusRequest& request : look) EXPECT_EQ(request.written.count, 0);
  answer(drive, {});
  EXPECT_EQ(drive.take({}, milliseconds{1}, milliseconds{2}), std::nullopt);
  EXPECT_TRUE(drive.requests_to_look().empty());
  EXPECT_TRUE(drive.exchange().feedback().valid);
}

TEST(BusDrive, IsAskedAgainWhenAnAnswerWasMissed) {
  BusDrive drive(x_drive(), poll, timeout);
  EXPECT_FALSE(drive.is_asked_again());
  drive.begin_try(milliseconds{10});
  EXPECT_EQ(drive.take(ExchangeError::timeout, milliseconds{10}, milliseconds{20}),
            ExchangeError::timeout);
  EXPECT_TRUE(drive.is_asked_again());
  EXPECT_GE(drive.again_at(), milliseconds{10});
  drive.exchange().lose_contact();
  EXPECT_FALSE(drive.is_asked_again()) << "who is given up waits for its turn";
}

TEST(BusSensor, IsLeftAloneForTheTimeOut) {
  BusSensor sensor(VibrationSensorConfig{.count = 4, .rate_hz = 100.0}, timeout);
  EXPECT_TRUE(sensor.is_due(BusTime{0}));
  sensor.fail(milliseconds{100});
  EXPECT_FALSE(sensor.is_due(milliseconds{349}));
  EXPECT_TRUE(sensor.is_due(milliseconds{350}));
  VibrationStatus status;
  sensor.tell(status);
  EXPECT_EQ(status.errors, 1U);
}

// The count of samples so far, then the newest four, 10 to a micrometre.
TEST(BusSensor, HandsNewSamplesToTheCycle) {
  BusSensor sensor(VibrationSensorConfig{.count = 4, .rate_hz = 100.0}, timeout);
  sensor.block().words = {4, 10, 20, 30, 40};
  sensor.take();
  sensor.block().words = {6, 30, 40, 50, 60};
  sensor.take();
  std::vector<double> samples(10);
  const std::size_t first = sensor.take_samples(samples);
  ASSERT_GE(first, 2U);
  EXPECT_EQ(samples[first - 2], 5.0);
  EXPECT_EQ(samples[first - 1], 6.0);
  EXPECT_EQ(sensor.take_samples(samples), 0U);
}

TEST(SilentTurn, DrivesThatWereGivenUpTakeTurnsOneATimeOut) {
  SilentTurn turn(timeout);
  const auto is_lost = [](std::size_t drive) { return drive != 1; };
  turn.choose(3, is_lost);
  EXPECT_TRUE(turn.is_turn_of(2, BusTime{0}));
  EXPECT_FALSE(turn.is_turn_of(0, BusTime{0}));
  turn.note_silence(milliseconds{10});
  EXPECT_FALSE(turn.is_turn_of(2, milliseconds{259}));
  turn.choose(3, is_lost);
  EXPECT_TRUE(turn.is_turn_of(0, milliseconds{260}));
  turn.choose(3, [](std::size_t) { return false; });
  turn.choose(0, is_lost);
}

// Nobody listens at port 1: the first pause is none, later ones come to a second.
TEST(BusConnection, IsNotTriedWithoutPauses) {
  const BusConfig config{.kind = BusKind::modbus_tcp, .host = "127.0.0.1", .port = 1};
  BusConnection connection(std::make_unique<ModbusLink>(config), std::chrono::minutes{1});
  const BusClock clock;
  EXPECT_EQ(connection.ensure(clock), BusConnection::Try::failed);
  EXPECT_EQ(connection.ensure(clock), BusConnection::Try::failed);
  int tries = 0;
  while (connection.ensure(clock) != BusConnection::Try::not_yet && tries < 100) ++tries;
  EXPECT_LT(tries, 100);
  EXPECT_FALSE(connection.link().is_connected());
}

TEST(StatusBoard, TellsWhatHappenedOnTheBus) {
  BusConfig config;
  config.axes = {x_drive()};
  StatusBoard board("127.0.0.1:502", config);
  board.count_connection(BusConnection::Try::made);
  board.count_connection(BusConnection::Try::stands);
  board.count_connection(BusConnection::Try::failed);
  board.count_exchange({}, milliseconds{2});
  board.count_exchange(ExchangeError::timeout, milliseconds{10});
  board.count_signal_request();
  board.set_connected(true);
  BusDrive drive(x_drive(), poll, timeout);
  answer(drive, {});
  EXPECT_EQ(drive.take({}, BusTime{0}, BusTime{1}), std::nullopt);
  board.tell_drive(0, drive.exchange());
  const BusStatus status = board.status();
  EXPECT_EQ(status.endpoint, "127.0.0.1:502");
  EXPECT_EQ(status.connections, 1U);
  EXPECT_EQ(status.exchanges, 2U);
  EXPECT_EQ(status.signal_requests, 1U);
  EXPECT_EQ(status.errors[ExchangeError::not_connected], 1U);
  EXPECT_EQ(status.errors[ExchangeError::timeout], 1U);
  EXPECT_TRUE(status.connected);
  ASSERT_EQ(status.axes.size(), 1U);
  EXPECT_EQ(status.axes[0].axis, "X");
  EXPECT_TRUE(status.axes[0].in_contact);
  EXPECT_EQ(status.round_trip.max_us, 2000.0) << "only of answers";
  board.tell_own_fault("out of memory");
  EXPECT_FALSE(board.status().connected);
  EXPECT_FALSE(board.status().axes[0].in_contact);
}

}  // namespace
}  // namespace stanok::drives
