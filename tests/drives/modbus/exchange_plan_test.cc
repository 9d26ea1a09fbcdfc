// Which requests an exchange takes, for maps with and without gaps.
#include "drives/modbus/exchange_plan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

namespace stanok::drives {
namespace {

using Plan = std::vector<ModbusRequest>;

TEST(ExchangePlan, TheStandardMapTakesOneTrip) {
  EXPECT_EQ(exchange_plan({.axis = "X"}), (Plan{{.function = Function::write_and_read_registers,
                                                 .written = {0, 6},
                                                 .read = {100, 17}}}));
}

// Control word at 8192, speed right behind it; status at 8448, speed at 8451, power at 8460.
AxisDriveConfig inverter_drive() {
  AxisDriveConfig drive{.axis = "S1", .kind = DriveKind::velocity, .map = {}};
  drive.map.control_word = {.address = 8192};
  drive.map.target_velocity = {.address = 8193};
  drive.map.status_word = {.address = 8448};
  drive.map.velocity = {.address = 8451};
  drive.map.power = {.address = 8460};
  return drive;
}

TEST(ExchangePlan, ARunWithoutGapsIsOneRequest) {
  AxisDriveConfig drive = inverter_drive();
  drive.requests = RequestStyle::write_multiple;
  EXPECT_EQ(exchange_plan(drive),
            (Plan{{.function = Function::write_registers, .written = {8192, 2}},
                  {.function = Function::read_registers, .read = {8448, 1}},
                  {.function = Function::read_registers, .read = {8451, 1}},
                  {.function = Function::read_registers, .read = {8460, 1}}}));
}

TEST(ExchangePlan, AReadBridgesTheGapsThatTheDriveBears) {
  AxisDriveConfig drive = inverter_drive();
  drive.requests = RequestStyle::write_single;
  drive.gap_max = 2;
  EXPECT_EQ(exchange_plan(drive),
            (Plan{{.function = Function::write_register, .written = {8193, 1}},
                  {.function = Function::write_register, .written = {8192, 1}},
                  {.function = Function::read_registers, .read = {8448, 4}},
                  {.function = Function::read_registers, .read = {8460, 1}}}));
}

TEST(ExchangePlan, AWriteNeverBridgesAGap) {
  AxisDriveConfig drive = inverter_drive();
  drive.map.target_velocity.address = 8194;
  drive.gap_max = 100;
  EXPECT_EQ(exchange_plan(drive),
            (Plan{{.function = Function::write_registers, .written = {8194, 1}},
                  {.function = Function::write_and_read_registers,
                   .written = {8192, 1},
                   .read = {8448, 13}}}));
}

TEST(ExchangePlan, AStopIsWrittenFirst) {
  AxisDriveConfig drive = inverter_drive();
  drive.map.target_velocity.address = 8190;
  drive.gap_max = 100;
  EXPECT_EQ(exchange_plan(drive, WriteOrder::control_word_first),
            (Plan{{.function = Function::write_registers, .written = {8192, 1}},
                  {.function = Function::write_and_read_registers,
                   .written = {8190, 1},
                   .read = {8448, 13}}}));
}

TEST(ExchangePlan, TheEchoIsReadBehindEveryWrite) {
  AxisDriveConfig drive = inverter_drive();
  drive.map.heartbeat = {.address = 8300};
  drive.map.heartbeat_echo = {.address = 8400};
  EXPECT_EQ(exchange_plan(drive).back().read, (RegisterRun{8400, 1}));
}

// Properties for arbitrary maps: each register of a field is transferred, nothing else is written,
// no value of 32 bits is torn, the limits of the protocol hold, and the last read comes last.
TEST(ExchangePlan, CoversAnyMapAndWritesNothingElse) {
  const unsigned seed = 23;
  std::mt19937 random(seed);
  const auto any = [&](int high) {
    return static_cast<int>(random() % static_cast<unsigned>(high));
  };
  for (int round = 0; round < 2000; ++round) {
    AxisDriveConfig drive{.axis = "X", .map = {}};
    drive.gap_max = any(4) * any(60);
    drive.requests = static_cast<RequestStyle>(any(3));
    int next = any(50);
    const auto place = [&](FieldOfMap field) {
      const int words = drive.requests == RequestStyle::write_single ? 1 : 1 + any(2);
      drive.map.*field = {.address = next, .words = words};
      next += words + any(3) * any(40);
    };
    for (const FieldOfMap field : written_fields) place(field);
    for (const FieldOfMap field : read_fields) place(field);

    std::set<int> written;
    std::set<int> read;
    const Plan plan = exchange_plan(drive);
    for (const ModbusRequest& request : plan) {
      ASSERT_LE(request.written.count, 121);
      ASSERT_LE(request.read.count, 125);
      for (int at = 0; at < request.written.count; ++at) written.insert(request.written.first + at);
      for (int at = 0; at < request.read.count; ++at) read.insert(request.read.first + at);
    }
    std::set<int> wanted;
    for (const FieldOfMap member : written_fields) {
      const RegisterField& field = drive.map.*member;
      for (int at = field.address; at < field.end(); ++at) wanted.insert(at);
    }
    ASSERT_EQ(written, wanted) << "seed " << seed << ", round " << round;
    for (const FieldOfMap member : read_fields) {
      const RegisterField& field = drive.map.*member;
      ASSERT_TRUE(std::ranges::any_of(plan,
                                      [&](const ModbusRequest& request) {
                                        return request.read.first <= field.address &&
                                               field.end() <= request.read.end();
                                      }))
          << "seed " << seed << ", round " << round;
    }
    ASSERT_GT(plan.back().read.count, 0);
    const int echo = drive.map.heartbeat_echo.address;
    const auto is_write = [](const ModbusRequest& request) { return request.written.count > 0; };
    const auto reads_echo = [&](const ModbusRequest& request) {
      return request.read.first <= echo && echo < request.read.end();
    };
    const auto last_write = std::ranges::find_if(plan.rbegin(), plan.rend(), is_write);
    const auto echo_read = std::ranges::find_if(plan, reads_echo);
    ASSERT_LE(last_write.base() - plan.begin() - 1, echo_read - plan.begin())
        << "seed " << seed << ", round " << round;
  }
}

}  // namespace
}  // namespace stanok::drives
