// Simulated drives on the clock of the cycle, without a machine that commands them.
#include "runtime/drive_side/direct_drives.h"

#include <gtest/gtest.h>

#include "tests/runtime/drive_side/drive_side_bench.h"
#include "tests/support/no_allocation.h"

namespace stanok::runtime {
namespace {

TEST(DirectDrivesTest, AreSwitchedOnAndFollowTheirTargets) {
  DriveSideBench bench(DriveChoice::simulated);
  bench.power(channels::Switch::on);
  ASSERT_TRUE(bench.cycle_until([&] { return bench.is_on(); }));
  EXPECT_TRUE(bench.x().valid);
  EXPECT_TRUE(bench.x().referenced) << "the machine is on from the first cycle";
  double& target_x = bench.output().channels[0].axes[bench_axis_x].position;
  for (int n = 0; n < 500; ++n) {  // 10 mm/s
    target_x += 0.01;
    bench.cycle();
  }
  EXPECT_TRUE(bench.cycle_until([&] { return std::abs(bench.x().position - target_x) < 0.001; }));
  EXPECT_NEAR(bench.side().position_of(bench_axis_x, {}), target_x, 0.001);
  EXPECT_NEAR(bench.side().position_of(bench_axis_y, {}), bench_start_y_mm, 0.001);
}

TEST(DirectDrivesTest, AFaultStandsUntilItIsAcknowledged) {
  DriveSideBench bench(DriveChoice::simulated);
  bench.power(channels::Switch::on);
  ASSERT_TRUE(bench.cycle_until([&] { return bench.is_on(); }));
  EXPECT_FALSE(bench.side().inject_fault("Q", plant::FaultKind::trip));
  ASSERT_TRUE(bench.side().inject_fault("X", plant::FaultKind::trip));
  ASSERT_TRUE(bench.cycle_until([&] { return bench.x().fault; }));
  bench.cycle({asked(channels::commands::ProgramReset{}, 2)});  // of another channel
  EXPECT_FALSE(bench.cycle_until([&] { return !bench.x().fault; }, 500));
  bench.cycle({asked(channels::commands::ProgramReset{}, 1)});
  EXPECT_TRUE(bench.cycle_until([&] { return bench.is_on(); }));
}

TEST(DirectDrivesTest, AFaultOfOneDriveIsAcknowledgedByItsName) {
  DriveSideBench bench(DriveChoice::simulated);
  bench.power(channels::Switch::on);
  ASSERT_TRUE(bench.cycle_until([&] { return bench.is_on(); }));
  ASSERT_TRUE(bench.side().inject_fault("X", plant::FaultKind::trip));
  ASSERT_TRUE(bench.cycle_until([&] { return bench.x().fault; }));
  EXPECT_FALSE(bench.side().reset_drive("Q"));
  EXPECT_TRUE(bench.side().reset_drive("X"));
  EXPECT_TRUE(bench.cycle_until([&] { return bench.is_on(); }));
}

TEST(DirectDrivesTest, AreExchangedWithoutMemory) {
  DriveSideBench bench(DriveChoice::simulated);
  bench.power(channels::Switch::on);
  const std::vector events{asked(channels::commands::MachineOn{}, 0)};
  const stanok::testing::NoAllocation guard;
  for (int n = 0; n < 100; ++n) bench.cycle(events);
}

}  // namespace
}  // namespace stanok::runtime
