// Bus and simulated drives over a real Modbus connection on loopback: exchange, faults, return.
#include <gtest/gtest.h>
#include <modbus/modbus.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <deque>
#include <random>

#include "drives/cia402.h"
#include "tests/plant/loopback.h"
#include "tests/support/no_allocation.h"

namespace stanok::plant {
namespace {

using drives::DriveState;
using drives::ExchangeError;

class ModbusLoopback : public ::testing::Test {
 protected:
  static std::vector<SimulatedDriveConfig> simulated() {
    const std::vector<double> start = {10.0, -20.0, 30.0};
    return drives_of(bus_of(3), start);
  }

  void SetUp() override { server.start(); }

  ModbusServer server{{}, simulated()};
};

TEST_F(ModbusLoopback, FeedbackComesFromTheDrives) {
  CycleSide cycle(bus_of(3), server.port());
  ASSERT_TRUE(cycle.until([&] { return cycle.all_valid(); }));
  EXPECT_EQ(cycle.feedback[0].position, 10.0);
  EXPECT_EQ(cycle.feedback[1].position, -20.0);
  EXPECT_EQ(cycle.feedback[2].position, 30.0);
  EXPECT_TRUE(cycle.feedback[1].referenced);
  EXPECT_NE(cycle.feedback[2].state, DriveState::operation_enabled);
}

TEST_F(ModbusLoopback, DrivesGoToTheirTargets) {
  CycleSide cycle(bus_of(3), server.port());
  ASSERT_TRUE(cycle.switch_on());
  cycle.targets[0].position = 10.4;
  cycle.targets[1].position = -20.4;
  EXPECT_TRUE(cycle.until(
      [&] { return cycle.feedback[0].position == 10.4 && cycle.feedback[1].position == -20.4; }));
  EXPECT_EQ(cycle.feedback[2].position, 30.0);
  cycle.targets[0].enabled = false;
  EXPECT_TRUE(
      cycle.until([&] { return cycle.feedback[0].state == DriveState::ready_to_switch_on; }));
}

TEST_F(ModbusLoopback, StatusCountsExchangesAndRoundTrips) {
  CycleSide cycle(bus_of(3), server.port());
  ASSERT_TRUE(cycle.until([&] { return cycle.feedback[2].sequence > 20; }));
  const drives::BusStatus status = cycle.bus.status();
  EXPECT_TRUE(status.connected);
  EXPECT_EQ(status.connections, 1U);
  EXPECT_GE(status.exchanges, 60U);
  EXPECT_GT(status.round_trip.p50_us, 0.0);
  EXPECT_LE(status.round_trip.p50_us, status.round_trip.max_us);
  EXPECT_TRUE(status.axes[1].in_contact);
  EXPECT_EQ(status.axes[1].axis, "A2");
}

// Ten drives, each in every poll; how long that takes is measured by
// benchmarks/drive_exchange_figures.
TEST(TenDrives, AreExchangedWithInEveryPollWithoutAnError) {
  drives::BusConfig bus = bus_of(10);
  bus.poll_ms = 10;
  bus.timeout_ms = 30000;  // the threads of the drives may have to wait for a processor
  ModbusServer server({}, drives_of(bus, {}));
  server.start();
  CycleSide cycle(bus, server.port());
  ASSERT_TRUE(cycle.until([&] { return cycle.feedback[9].sequence >= 100; }));
  cycle.bus.stop();
  const drives::BusStatus status = cycle.bus.status();
  std::uint64_t answers = 0;
  for (const drives::AxisBusStatus& axis : status.axes) {
    EXPECT_EQ(axis.errors, 0U) << axis.axis;
    EXPECT_LE(axis.answers - status.axes[9].answers, 1U) << axis.axis;
    answers += axis.answers;
  }
  EXPECT_EQ(status.connections, 1U);
  EXPECT_LE(status.exchanges - answers, 10U) << "the farewell of each drive";
}

TEST_F(ModbusLoopback, CycleSideAllocatesNothing) {
  CycleSide cycle(bus_of(3), server.port());
  ASSERT_TRUE(cycle.until([&] { return cycle.all_valid(); }));
  const testing::NoAllocation guard;
  cycle.run();
}

TEST_F(ModbusLoopback, ReconnectsAfterTheServerWasAwayAndResumesNothing) {
  CycleSide cycle(bus_of(3), server.port());
  ASSERT_TRUE(cycle.switch_on());
  server.stop();
  ASSERT_TRUE(cycle.until([&] { return !cycle.all_valid(); }));
  ASSERT_TRUE(cycle.until([&] { return cycle.feedback[0].losses == 1; }));
  server.start();
  ASSERT_TRUE(cycle.until([&] { return cycle.all_valid(); }));
  EXPECT_GE(cycle.bus.status().connections, 2U);
  EXPECT_TRUE(cycle.feedback[0].referenced);
  ASSERT_TRUE(
      cycle.until([&] { return cycle.feedback[0].state != DriveState::operation_enabled; }));
  const std::uint32_t sequence = cycle.feedback[0].sequence;
  ASSERT_TRUE(cycle.until([&] {
    EXPECT_NE(cycle.feedback[0].state, DriveState::operation_enabled);
    return cycle.feedback[0].sequence > sequence + 50;
  }));
}

TEST_F(ModbusLoopback, ASilentDriveIsInvalidAndTheOthersLive) {
  CycleSide cycle(bus_of(3), server.port());
  ASSERT_TRUE(cycle.switch_on());
  server.inject(1, FaultKind::off);
  ASSERT_TRUE(cycle.until([&] { return !cycle.feedback[1].valid; }));
  EXPECT_GE(cycle.errors(ExchangeError::timeout), 1U);
  // A second of life of the others beside the dead drive: their answers keep coming.
  const std::uint32_t sequence = cycle.feedback[0].sequence;
  ASSERT_TRUE(cycle.until([&] { return cycle.feedback[0].sequence > sequence + 100; }));
  EXPECT_EQ(cycle.feedback[0].losses, 0U);
  EXPECT_EQ(cycle.feedback[2].losses, 0U);
  EXPECT_FALSE(cycle.feedback[1].valid);
  server.inject(1, FaultKind::none);
  EXPECT_TRUE(cycle.until([&] { return cycle.feedback[1].valid; }));
}

TEST_F(ModbusLoopback, GarbageIsNeverTakenForValues) {
  CycleSide cycle(bus_of(3), server.port());
  ASSERT_TRUE(cycle.until([&] { return cycle.all_valid(); }));
  server.inject(0, FaultKind::garbage);
  ASSERT_TRUE(cycle.until([&] {
    EXPECT_EQ(cycle.feedback[0].position, 10.0);
    return !cycle.feedback[0].valid;
  }));
  EXPECT_GE(cycle.errors(ExchangeError::stuck) + cycle.errors(ExchangeError::implausible), 10U);
}

TEST_F(ModbusLoopback, AStuckDriveIsFoundByItsEcho) {
  CycleSide cycle(bus_of(3), server.port());
  ASSERT_TRUE(cycle.until([&] { return cycle.all_valid(); }));
  server.inject(2, FaultKind::stuck);
  ASSERT_TRUE(cycle.until([&] { return !cycle.feedback[2].valid; }));
  EXPECT_GE(cycle.errors(ExchangeError::stuck), 10U);
  EXPECT_TRUE(cycle.feedback[0].valid);
}

TEST_F(ModbusLoopback, BrokenFramesAreCountedAndTheConnectionIsMadeAnew) {
  CycleSide cycle(bus_of(3), server.port());
  ASSERT_TRUE(cycle.until([&] { return cycle.all_valid(); }));
  server.inject(1, FaultKind::mangled);
  ASSERT_TRUE(cycle.until([&] { return !cycle.feedback[1].valid; }));
  EXPECT_GE(cycle.errors(ExchangeError::mangled) + cycle.errors(ExchangeError::timeout), 1U);
  EXPECT_GE(cycle.bus.status().connections, 2U);
  EXPECT_EQ(cycle.feedback[1].position, -20.0);
}

TEST_F(ModbusLoopback, AServerThatHangsUpIsCalledAgain) {
  CycleSide cycle(bus_of(3), server.port());
  ASSERT_TRUE(cycle.until([&] { return cycle.all_valid(); }));
  server.inject(0, FaultKind::hang_up);
  ASSERT_TRUE(cycle.until([&] { return cycle.errors(ExchangeError::disconnected) >= 3; }));
  server.inject(0, FaultKind::none);
  EXPECT_TRUE(cycle.until([&] { return cycle.all_valid(); }));
}

TEST_F(ModbusLoopback, LateAnswersAreNotTakenForOthers) {
  CycleSide cycle(bus_of(3), server.port());
  ASSERT_TRUE(cycle.until([&] { return cycle.all_valid(); }));
  server.inject(0, FaultKind::slow);
  ASSERT_TRUE(cycle.until([&] {
    EXPECT_EQ(cycle.feedback[0].position, 10.0);
    EXPECT_EQ(cycle.feedback[1].position, -20.0);
    return !cycle.feedback[0].valid;
  }));
  server.inject(0, FaultKind::none);
  EXPECT_TRUE(cycle.until([&] { return cycle.feedback[0].valid; }));
}

TEST_F(ModbusLoopback, AnUnknownUnitIsAnExceptionAndKeepsTheConnection) {
  drives::BusConfig bus = bus_of(3);
  bus.axes[1].unit = 99;
  CycleSide cycle(bus, server.port());
  ASSERT_TRUE(cycle.until([&] { return cycle.errors(ExchangeError::exception) >= 3; }));
  EXPECT_EQ(cycle.bus.status().connections, 1U);
  ASSERT_TRUE(cycle.until([&] { return cycle.feedback[0].valid; }));
  EXPECT_FALSE(cycle.feedback[1].valid);
}

TEST_F(ModbusLoopback, ATrippedDriveShowsItsFaultAndIsReset) {
  CycleSide cycle(bus_of(3), server.port());
  ASSERT_TRUE(cycle.switch_on());
  server.inject(2, FaultKind::trip);
  ASSERT_TRUE(cycle.until([&] { return cycle.feedback[2].state == DriveState::fault; }));
  EXPECT_EQ(cycle.feedback[2].fault_code, drives::fault_code::over_current);
  EXPECT_TRUE(cycle.feedback[2].valid);
  cycle.targets[2].enabled = false;
  cycle.targets[2].fault_reset = true;
  EXPECT_TRUE(cycle.until([&] { return cycle.feedback[2].state != DriveState::fault; }));
}

TEST_F(ModbusLoopback, ADriveThatComesBackElsewhereIsNotReferenced) {
  CycleSide cycle(bus_of(3), server.port());
  ASSERT_TRUE(cycle.switch_on());
  server.inject(0, FaultKind::elsewhere);
  ASSERT_TRUE(cycle.until([&] { return !cycle.feedback[0].valid; }));
  server.inject(0, FaultKind::none);
  ASSERT_TRUE(cycle.until([&] { return cycle.feedback[0].valid; }));
  EXPECT_EQ(cycle.feedback[0].position, 20.0);
  EXPECT_FALSE(cycle.feedback[0].referenced);
}

TEST_F(ModbusLoopback, DrivesStopWhenTheCycleFallsSilent) {
  CycleSide cycle(bus_of(3), server.port());
  ASSERT_TRUE(cycle.switch_on());
  // Only reads: the cycle does not write any more.
  EXPECT_TRUE(eventually([&] {
    cycle.bus.read(cycle.feedback);
    return cycle.feedback[0].state == DriveState::switch_on_disabled;
  }));
  EXPECT_TRUE(cycle.feedback[0].valid);
}

TEST_F(ModbusLoopback, StoppingTheBusStopsTheDrives) {
  CycleSide first(bus_of(3), server.port());
  ASSERT_TRUE(first.switch_on());
  first.bus.stop();
  CycleSide second(bus_of(3), server.port());
  ASSERT_TRUE(second.until([&] { return second.all_valid(); }));
  EXPECT_NE(second.feedback[0].state, DriveState::operation_enabled);
  // And what the first bus holds grows old.
  EXPECT_TRUE(first.until([&] { return !first.all_valid(); }));
}

TEST(ModbusBus, StartsWithoutAnyServer) {
  CycleSide cycle(bus_of(1), 1);  // nobody listens on port 1
  EXPECT_TRUE(cycle.until([&] { return cycle.errors(ExchangeError::not_connected) >= 2; }));
  EXPECT_FALSE(cycle.bus.status().connected);
  EXPECT_FALSE(cycle.feedback[0].valid);
}

// An independent client: the plain functions of libmodbus.
class PlainClient {
 public:
  explicit PlainClient(int port) : context_(modbus_new_tcp("127.0.0.1", port)) {
    EXPECT_EQ(modbus_connect(context_), 0);
  }
  ~PlainClient() {
    modbus_close(context_);
    modbus_free(context_);
  }
  PlainClient(const PlainClient&) = delete;
  PlainClient& operator=(const PlainClient&) = delete;

  modbus_t* unit(int id) {
    modbus_set_slave(context_, id);
    return context_;
  }

 private:
  modbus_t* context_;
};

TEST_F(ModbusLoopback, AnyClientReadsTheDocumentedRegisters) {
  PlainClient client(server.port());
  std::array<std::uint16_t, 12> status{};
  ASSERT_EQ(modbus_read_registers(client.unit(2), 100, 12, status.data()), 12);
  EXPECT_EQ(status[0] & 0x4F, 0x40);  // switch on disabled
  // -20 mm = -20000 increments = FFFF B1E0 hex.
  EXPECT_EQ(status[1], 0xFFFF);
  EXPECT_EQ(status[2], 0xB1E0);
}

TEST_F(ModbusLoopback, BeyondTheRegistersIsAnIllegalAddress) {
  PlainClient client(server.port());
  std::array<std::uint16_t, 12> status{};
  EXPECT_EQ(modbus_read_registers(client.unit(1), 110, 12, status.data()), -1);
  EXPECT_EQ(errno, EMBXILADD);
  const std::array<std::uint16_t, 2> values{};
  EXPECT_EQ(modbus_write_registers(client.unit(1), 116, 2, values.data()), -1);
  EXPECT_EQ(errno, EMBXILADD);
  EXPECT_EQ(modbus_read_registers(client.unit(77), 0, 1, status.data()), -1);
  EXPECT_EQ(errno, EMBXGTAR);
}

TEST_F(ModbusLoopback, FaultsCanBeInjectedThroughThePanel) {
  PlainClient client(server.port());
  ASSERT_EQ(modbus_write_register(client.unit(fault_panel_unit), 1, 2), 1);  // A2 stuck
  std::array<std::uint16_t, 3> panel{};
  ASSERT_EQ(modbus_read_registers(client.unit(fault_panel_unit), 0, 3, panel.data()), 3);
  EXPECT_EQ(panel, (std::array<std::uint16_t, 3>{0, 2, 0}));
  // No such fault: nothing is injected.
  modbus_write_register(client.unit(fault_panel_unit), 1, 500);
  ASSERT_EQ(modbus_read_registers(client.unit(fault_panel_unit), 1, 1, panel.data()), 1);
  EXPECT_EQ(panel[0], 2);
}

TEST_F(ModbusLoopback, ManyClientsAreServed) {
  std::deque<PlainClient> clients;
  for (int i = 0; i < 50; ++i) {
    clients.emplace_back(server.port());
  }
  for (PlainClient& client : clients) {
    std::uint16_t word = 0;
    EXPECT_EQ(modbus_read_registers(client.unit(1), 100, 1, &word), 1);
    EXPECT_EQ(drives::state_of(word), DriveState::switch_on_disabled);
  }
}

TEST_F(ModbusLoopback, ClientsThatTalkNonsenseDoNotDisturbTheOthers) {
  const unsigned seed = 502;
  std::mt19937 random(seed);
  CycleSide cycle(bus_of(3), server.port());
  ASSERT_TRUE(cycle.until([&] { return cycle.all_valid(); }));
  for (int i = 0; i < 20; ++i) {
    PlainClient nonsense(server.port());
    const int socket = modbus_get_socket(nonsense.unit(1));
    std::vector<std::uint8_t> bytes(random() % 300);
    std::generate(bytes.begin(), bytes.end(), [&] { return static_cast<std::uint8_t>(random()); });
    EXPECT_EQ(send(socket, bytes.data(), bytes.size(), MSG_NOSIGNAL),
              static_cast<ssize_t>(bytes.size()));
    const std::uint32_t sequence = cycle.feedback[2].sequence;
    ASSERT_TRUE(cycle.until([&] { return cycle.feedback[2].sequence > sequence + 2; }))
        << "seed " << seed;
  }
  EXPECT_EQ(cycle.feedback[0].position, 10.0);
}

TEST(ModbusServer, SaysWhatItCannotOpen) {
  ModbusServer first({}, {});
  first.start();
  ModbusServer second({.port = first.port()}, {});
  EXPECT_THROW(second.start(), ServerError);
  ModbusServer serial({.rtu_device = "/dev/no-such-line"}, {});
  EXPECT_THROW(serial.start(), ServerError);
}

}  // namespace
}  // namespace stanok::plant
