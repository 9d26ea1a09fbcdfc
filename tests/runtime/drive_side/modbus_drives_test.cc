// Drives on a Modbus bus: simulated ones behind a server of their own, and none where the machine
// file has no bus.
#include "runtime/drive_side/modbus_drives.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "tests/runtime/drive_side/drive_side_bench.h"

namespace stanok::runtime {
namespace {

constexpr int cycles_max = 30000;

class ModbusDrivesTest : public ::testing::Test {
 protected:
  ModbusDrivesTest() {
    bench_.power(channels::Switch::on);
    bench_.side().start();
  }
  // The bus has its own thread: the cycle leaves it time.
  template <class Condition>
  [[nodiscard]] bool comes_to(Condition&& holds) {
    return bench_.cycle_until(
        [&] {
          std::this_thread::sleep_for(std::chrono::milliseconds(1));
          return holds();
        },
        cycles_max);
  }

  DriveSideBench bench_{DriveChoice::embedded};
};

TEST_F(ModbusDrivesTest, AreReachedThroughTheirServer) {
  EXPECT_NE(bench_.file().bus.port, 0) << "the machine file has the bus that the drives are on";
  ASSERT_TRUE(comes_to([&] { return bench_.is_on(); }));
  EXPECT_TRUE(bench_.side().status().connected);
  EXPECT_NEAR(bench_.side().position_of(bench_axis_y, {}), bench_start_y_mm, 0.01);
  bench_.side().stop();
  bench_.side().stop();  // twice is once
}

TEST_F(ModbusDrivesTest, AFaultStandsUntilItIsAcknowledged) {
  ASSERT_TRUE(comes_to([&] { return bench_.is_on(); }));
  EXPECT_FALSE(bench_.side().inject_fault("Q", plant::FaultKind::trip));
  ASSERT_TRUE(bench_.side().inject_fault("X", plant::FaultKind::trip));
  ASSERT_TRUE(comes_to([&] { return bench_.x().fault; }));
  EXPECT_TRUE(bench_.side().reset_drive("X"));
  EXPECT_TRUE(comes_to([&] { return bench_.is_on(); }));
}

TEST(RealDrives, NeedABusInTheMachineFile) {
  EXPECT_THROW(DriveSideBench(DriveChoice::real, ""), config::ConfigError);
}

TEST(RealDrives, AreNotThereUntilTheyAnswer) {
  DriveSideBench bench(DriveChoice::real);
  bench.cycle();
  ASSERT_EQ(bench.side().feedback().size(), 2U);
  EXPECT_FALSE(bench.x().valid);
  EXPECT_FALSE(bench.side().inject_fault("X", plant::FaultKind::stuck)) << "it is no simulation";
  EXPECT_TRUE(bench.side().reset_drive("X"));
}

}  // namespace
}  // namespace stanok::runtime
