// Drives with maps of their own over a real connection, written with each of the functions.
#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

#include "drives/cia402.h"
#include "tests/plant/loopback.h"

namespace stanok::plant {
namespace {

using drives::DriveState;
using drives::RequestStyle;

// Scattered fields, low word first, another scale for every quantity, no heartbeat.
drives::AxisDriveConfig scattered(int unit, RequestStyle style) {
  const int words = style == RequestStyle::write_single ? 1 : 2;
  const double scale = words == 1 ? 100.0 : 4096.0;
  const drives::RegisterField target{
      .words = words, .is_signed = true, .order = drives::WordOrder::low_first, .scale = scale};
  drives::AxisDriveConfig drive{.axis = "A" + std::to_string(unit),
                                .unit = unit,
                                .map = {},
                                .requests = style,
                                .velocity_max = 400.0};
  const auto at = [](drives::RegisterField field, int address) {
    field.address = address;
    return field;
  };
  drive.map.control_word = {.address = 0x1000};
  drive.map.target_position = at(target, 0x1010);
  drive.map.target_velocity = at(target, 0x1012);
  drive.map.status_word = {.address = 0x1100};
  drive.map.position = {.address = 0x1102,
                        .words = 2,
                        .order = drives::WordOrder::low_first,
                        .scale = -1000.0,
                        .offset = 7.0};
  drive.map.temperature = {.address = 0x0005, .scale = 10.0, .offset = 400.0};
  return drive;
}

class RegisterMapLoopback : public ::testing::TestWithParam<RequestStyle> {};

TEST_P(RegisterMapLoopback, TakesTheDriveToItsTarget) {
  drives::BusConfig bus{.kind = drives::BusKind::modbus_tcp, .poll_ms = 2};
  bus.axes = {scattered(1, GetParam()), bus_of(2).axes[1]};
  const std::vector<double> start = {10.0, -20.0};
  ModbusServer server({}, drives_of(bus, start));
  server.start();
  CycleSide cycle(bus, server.port());
  ASSERT_TRUE(cycle.switch_on());
  EXPECT_EQ(cycle.feedback[0].position, 10.0);
  EXPECT_EQ(cycle.feedback[0].temperature_c, 22.0);
  EXPECT_TRUE(cycle.feedback[0].referenced) << "an absolute encoder without a bit for it";
  cycle.targets[0].position = 10.25;
  cycle.targets[1].position = -20.25;
  EXPECT_TRUE(cycle.until(
      [&] { return cycle.feedback[0].position == 10.25 && cycle.feedback[1].position == -20.25; }));
  EXPECT_EQ(cycle.feedback[0].target_position, 10.25);
}

std::string function_name(const ::testing::TestParamInfo<RequestStyle>& style) {
  constexpr std::array<const char*, 3> names = {"Fc23", "Fc16", "Fc06"};
  return names[static_cast<std::size_t>(style.param)];
}

INSTANTIATE_TEST_SUITE_P(Functions, RegisterMapLoopback,
                         ::testing::Values(RequestStyle::write_and_read,
                                           RequestStyle::write_multiple,
                                           RequestStyle::write_single),
                         function_name);

}  // namespace
}  // namespace stanok::plant
