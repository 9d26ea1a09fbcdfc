// An exception in the thread of the bus, or of the simulated drives, is a loss of contact: the
// process lives, the drives stop, nothing resumes by itself.
#include <gtest/gtest.h>
#include <modbus/modbus.h>

#include <atomic>
#include <new>
#include <stdexcept>

#include "drives/cia402.h"
#include "tests/plant/loopback.h"
#include "tests/support/no_allocation.h"

namespace stanok::plant {
namespace {

using drives::DriveState;
using drives::ExchangeError;

enum class Thrown : std::uint8_t { nothing, bad_alloc, broken_claim, no_exception };

// A link that throws while it is told to.
class FaultyLink : public drives::ModbusLink {
 public:
  using ModbusLink::ModbusLink;
  std::optional<ExchangeError> exchange(int unit, std::span<const drives::ModbusRequest> requests,
                                        std::span<std::uint16_t> image) override {
    switch (thrown.load()) {
      case Thrown::nothing:
        break;
      case Thrown::bad_alloc:
        throw std::bad_alloc();
      case Thrown::broken_claim:
        throw std::logic_error("drives/exchange_plan.cc:7: broken claim: count > 0");
      case Thrown::no_exception:
        throw 42;
    }
    return ModbusLink::exchange(unit, requests, image);
  }
  using ModbusLink::exchange;

  static inline std::atomic<Thrown> thrown = Thrown::nothing;
};

// The state of a drive, asked over a connection of its own. Reading feeds no watchdog.
class Onlooker {
 public:
  explicit Onlooker(int port) : context_(modbus_new_tcp("127.0.0.1", port)) {
    EXPECT_EQ(modbus_connect(context_), 0);
  }
  ~Onlooker() {
    modbus_close(context_);
    modbus_free(context_);
  }
  Onlooker(const Onlooker&) = delete;
  Onlooker& operator=(const Onlooker&) = delete;

  std::optional<DriveState> state(const drives::AxisDriveConfig& drive) {
    std::uint16_t word = 0;
    modbus_set_slave(context_, drive.unit);
    if (modbus_read_registers(context_, drive.map.status_word.address, 1, &word) != 1)
      return std::nullopt;
    return drives::state_of(word);
  }

 private:
  modbus_t* context_;
};

class RootOfTheBusThread : public ::testing::TestWithParam<Thrown> {
 protected:
  void SetUp() override {
    FaultyLink::thrown = Thrown::nothing;
    server.start();
  }
  void TearDown() override { FaultyLink::thrown = Thrown::nothing; }

  ModbusServer server{{}, drives_of(bus_of(3), std::vector<double>{10.0, -20.0, 30.0})};
};

TEST_P(RootOfTheBusThread, TurnsAnExceptionIntoALossOfContact) {
  CycleSide cycle(bus_of(3), server.port(), std::type_identity<FaultyLink>());
  ASSERT_TRUE(cycle.switch_on());
  FaultyLink::thrown = GetParam();
  ASSERT_TRUE(cycle.until([&] {
    return std::ranges::none_of(cycle.feedback, [](const auto& axis) { return axis.valid; });
  }));
  for (const drives::DriveFeedback& axis : cycle.feedback) EXPECT_EQ(axis.losses, 1U);
  EXPECT_GE(cycle.errors(ExchangeError::own_fault), 1U);
  EXPECT_FALSE(cycle.bus.status().own_fault.empty());

  // It throws on, so nothing tells the drives to stop: their own watchdogs do.
  Onlooker onlooker(server.port());
  for (const drives::AxisDriveConfig& drive : bus_of(3).axes) {
    ASSERT_TRUE(cycle.until([&] { return onlooker.state(drive) == DriveState::fault; }));
  }

  // Contact comes back, motion does not.
  FaultyLink::thrown = Thrown::nothing;
  ASSERT_TRUE(cycle.until([&] { return cycle.all_valid(); }));
  const std::uint32_t sequence = cycle.feedback[0].sequence;
  ASSERT_TRUE(cycle.until([&] {
    EXPECT_NE(cycle.feedback[0].state, DriveState::operation_enabled);
    return cycle.feedback[0].sequence > sequence + 50;
  }));
}

TEST_P(RootOfTheBusThread, EndsWithTheBusInSpiteOfIt) {
  CycleSide cycle(bus_of(3), server.port(), std::type_identity<FaultyLink>());
  ASSERT_TRUE(cycle.until([&] { return cycle.all_valid(); }));
  FaultyLink::thrown = GetParam();
  cycle.bus.stop();
  EXPECT_GE(cycle.errors(ExchangeError::own_fault), 1U) << "the farewell throws, too";
}

// One round that throws is enough to stop the axes, and the drives hear of it.
TEST_P(RootOfTheBusThread, StopsTheDrivesAfterASingleException) {
  CycleSide cycle(bus_of(3), server.port(), std::type_identity<FaultyLink>());
  ASSERT_TRUE(cycle.switch_on());
  FaultyLink::thrown = GetParam();
  ASSERT_TRUE(cycle.until([&] { return cycle.errors(ExchangeError::own_fault) > 0; }));
  FaultyLink::thrown = Thrown::nothing;
  ASSERT_TRUE(cycle.until([&] {
    return std::ranges::all_of(cycle.feedback, [](const auto& axis) {
      return axis.losses == 1 && axis.valid && axis.state != DriveState::operation_enabled;
    });
  }));
}

INSTANTIATE_TEST_SUITE_P(Thrown, RootOfTheBusThread,
                         ::testing::Values(Thrown::bad_alloc, Thrown::broken_claim,
                                           Thrown::no_exception));

TEST(RootOfTheServerThread, HangsUpWhenMemoryEndsAndServesAgain) {
  ModbusServer server({}, drives_of(bus_of(3), {}));
  server.start();
  CycleSide cycle(bus_of(3), server.port());
  ASSERT_TRUE(cycle.switch_on());
  {
    const testing::NoMemoryElsewhere guard;
    ASSERT_TRUE(cycle.until([&] {
      return testing::NoMemoryElsewhere::count() > 0 &&
             std::ranges::all_of(cycle.feedback, [](const auto& axis) { return axis.losses == 1; });
    }));
  }
  ASSERT_TRUE(cycle.until([&] { return cycle.all_valid(); }));
}

}  // namespace
}  // namespace stanok::plant
