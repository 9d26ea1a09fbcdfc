// Drives that are where they should be.
#include "runtime/drive_side/ideal_drives.h"

#include <gtest/gtest.h>

#include "tests/runtime/drive_side/drive_side_bench.h"

namespace stanok::runtime {
namespace {

TEST(IdealDrivesTest, TellNothingAndRefuseWhatTheyDoNotHave) {
  DriveSideBench bench(DriveChoice::ideal);
  bench.cycle({asked(channels::commands::MachineOn{}, 0)});
  EXPECT_TRUE(bench.side().feedback().empty());
  EXPECT_TRUE(bench.side().sensors().empty());
  EXPECT_FALSE(bench.side().signals().has_value());
  EXPECT_EQ(bench.side().status().exchanges, 0U);
  EXPECT_FALSE(bench.side().reset_drive("X"));
  EXPECT_FALSE(bench.side().inject_fault("X", plant::FaultKind::stuck));
}

TEST(IdealDrivesTest, AnAxisIsWhereItWasSetLastAndBeforeThatAtItsStart) {
  DriveSideBench bench(DriveChoice::ideal);
  EXPECT_EQ(bench.side().position_of(bench_axis_y, {}), bench_start_y_mm);
  bench.output().channels[0].axes[bench_axis_y].position = -7.0;
  EXPECT_EQ(bench.side().position_of(bench_axis_y, bench.output()), -7.0);
}

}  // namespace
}  // namespace stanok::runtime
