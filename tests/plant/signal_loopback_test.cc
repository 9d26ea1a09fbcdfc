// Signals over a real connection: outputs of the cycle come back through a wired module.
#include <gtest/gtest.h>

#include "tests/plant/loopback.h"

namespace stanok::plant {
namespace {

using drives::SignalConfig;
using drives::SignalKind;
using drives::SignalTable;

drives::BusConfig wired_bus() {
  drives::BusConfig bus = bus_of(1);
  bus.signals = {
      {.kind = SignalKind::digital_output, .number = 3, .unit = 30, .field = {.address = 17}},
      {.kind = SignalKind::digital_input,
       .number = 40,
       .unit = 30,
       .table = SignalTable::discrete_input,
       .field = {.address = 17}},
      {.kind = SignalKind::analog_output,
       .number = 1,
       .unit = 30,
       .table = SignalTable::holding_register,
       .field = {.address = 5, .words = 2, .scale = 1000.0}},
      {.kind = SignalKind::analog_input,
       .number = 2,
       .unit = 30,
       .table = SignalTable::input_register,
       .field = {.address = 5, .words = 2, .scale = 1000.0}}};
  return bus;
}

TEST(SignalLoopback, OutputsComeBackAsInputsAndFallWhenTheCycleIsSilent) {
  ModbusServer server({.modules = {.signals = {30}}}, drives_of(bus_of(1), {}));
  server.start();
  CycleSide cycle(wired_bus(), server.port());
  Signals outputs;
  outputs.set(3, true);
  outputs.analog[1] = -12.345;
  ASSERT_TRUE(cycle.until([&] {
    cycle.bus.write_signals(outputs);
    const Signals inputs = cycle.bus.read_signals();
    return inputs.is_on(40) && inputs.analog[2] == -12.345;
  }));
  EXPECT_TRUE(cycle.until([&] { return cycle.all_valid(); })) << "the drive lives beside it";
  // Nothing is written any more.
  EXPECT_TRUE(eventually([&] {
    const Signals inputs = cycle.bus.read_signals();
    return !inputs.is_on(40) && inputs.analog[2] == 0.0;
  }));
}

TEST(SignalLoopback, AModuleThatIsNotThereDoesNotDisturbTheDrives) {
  ModbusServer server({}, drives_of(bus_of(1), {}));
  server.start();
  CycleSide cycle(wired_bus(), server.port());
  ASSERT_TRUE(cycle.until([&] { return cycle.feedback[0].sequence > 200; }));
  EXPECT_TRUE(cycle.feedback[0].valid);
  EXPECT_EQ(cycle.feedback[0].losses, 0U);
  EXPECT_GT(cycle.errors(drives::ExchangeError::exception), 0U);
}

}  // namespace
}  // namespace stanok::plant
