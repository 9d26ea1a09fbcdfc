// M902 and M903 on the machine: spindles that are axes for a while.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "channels/machine/machine.h"
#include "tests/support/machine/machine_bench.h"

namespace stanok::channels {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::lathe_C;
using testing::MachineBench;

// Way of C from one cycle to the next, the short way round.
double step_of_c(double before, double now) {
  return std::remainder(now - before, 360.0);
}

TEST(SpindleAxis, TurnsAsASpindleThenGoesWhereItIsProgrammed) {
  MachineBench bench(testing::turning_machine());
  bench.program("p.nc", "G94 G8\nS600 M3\nG4 P0.5\nM902\nG1 C90 F600\nC-45\nM903\nM30\n");
  bench.run(1, "p.nc");
  double fastest_spindle = 0.0;
  double fastest_axis = 0.0;
  double before = 0.0;
  bench.run_to_end([&](const CycleOutput& output) {
    const AxisSetpoint& c = output.channels[0].axes[lathe_C];
    const bool is_spindle = output.channels[0].drives[lathe_C].follows_velocity;
    double& fastest = is_spindle ? fastest_spindle : fastest_axis;
    fastest = std::max(fastest, std::abs(c.velocity));
    if (is_spindle) {
      EXPECT_GE(c.position, 0.0);
      EXPECT_LT(c.position, 360.0);
    }
    // The setpoint is where the velocity says, whatever C is.
    EXPECT_NEAR(step_of_c(before, c.position), 1e-3 * c.velocity, 0.01);
    before = c.position;
  });
  EXPECT_THAT(bench.alarm_codes(), IsEmpty());
  EXPECT_EQ(fastest_spindle, 3600.0);     // 600 rev/min = 3600 deg/s
  EXPECT_NEAR(fastest_axis, 10.0, 1e-9);  // F600 deg/min
  EXPECT_NEAR(step_of_c(bench.channel(1).axes[lathe_C].position, -45.0), 0.0, 1e-9);
  EXPECT_TRUE(bench.channel(1).drives[lathe_C].follows_velocity);
}

TEST(SpindleAxis, BeginsWhereTheSpindleCameToRest) {
  MachineBench bench(testing::turning_machine());
  // 600 rev/min at 1500 rev/min/s: 0.4 s and 2 revolutions each way. 0.3 s more are 3 revolutions.
  bench.program("p.nc",
                "G94 S600 M3\nG4 P0.3\nM902\nnum at = $pos[C];\nG91 G0 C10\nG90\n"
                "if (at < 0 || at >= 360) { terminate (1001, \"not within a turn\"); }\nM0\nM30\n");
  bench.run(1, "p.nc");
  double resting = -1.0;
  double end = 0.0;
  bench.run_to_end([&](const CycleOutput& output) {
    const bool is_axis = !output.channels[0].drives[lathe_C].follows_velocity;
    if (is_axis && resting < 0.0) resting = output.channels[0].axes[lathe_C].position;
    if (is_axis) end = output.channels[0].axes[lathe_C].position;
  });
  EXPECT_THAT(bench.alarm_codes(), IsEmpty());
  EXPECT_NEAR(end, resting + 10.0, 1e-9);
}

TEST(SpindleAxis, EndAndResetMakeItASpindleAgain) {
  for (const char* const text : {"M902\nM30\n", "M902\nG4 P100\nM30\n"}) {
    MachineBench bench(testing::turning_machine());
    bench.program("p.nc", text);
    bench.run(1, "p.nc");
    for (int n = 0; n < 100; ++n) bench.cycle();
    bench.ask(OperatorAction::program_reset, 1);
    bench.run_to_end();
    EXPECT_TRUE(bench.channel(1).drives[lathe_C].follows_velocity) << text;
    bench.program("q.nc", "S100 M3\nM5\nM30\n");
    bench.run(1, "q.nc");
    bench.run_to_end();
    EXPECT_THAT(bench.alarm_codes(), IsEmpty()) << text;
  }
}

TEST(SpindleAxis, ManyTimesInAProgramLosesNoAngle) {
  MachineBench bench(testing::turning_machine());
  bench.program(
      "p.nc",
      "G94\nfor (num turn = 1; turn <= 20; turn++) {\n  M902\n  G90 G0 C=10*turn\n  M903\n"
      "  S300 M3\n  G4 P0.05\n  M5\n}\nM902\nG0 C0\nM0\nM30\n");
  bench.run(1, "p.nc");
  double last = 1.0;
  bench.run_to_end([&](const CycleOutput& output) {
    if (!output.channels[0].drives[lathe_C].follows_velocity)
      last = output.channels[0].axes[lathe_C].position;
  });
  EXPECT_THAT(bench.alarm_codes(), IsEmpty());
  EXPECT_EQ(last, 0.0);
}

// With drives that answer.
class SpindleAxisDrive : public ::testing::Test {
 protected:
  SpindleAxisDrive() : bench(testing::turning_machine()), drives(3) {
    for (AxisFeedback& drive : drives)
      drive = {.valid = true, .enabled = true, .referenced = true, .brake_closed = false};
    bench.program("p.nc", "M902\nG94 G91 G0 C5\nM0\nM30\n");
  }
  void run() {
    bench.feedback(drives);
    bench.run(1, "p.nc");
    bench.run_to_end([&](const CycleOutput& output) {
      if (!output.channels[0].drives[lathe_C].follows_velocity)
        last = output.channels[0].axes[lathe_C].position;
    });
  }
  [[nodiscard]] std::string alarm() {
    const auto alarms = bench.machine().alarms();
    return alarms.empty() ? "" : alarms[0].diagnostic.code + " " + alarms[0].diagnostic.message;
  }

  MachineBench bench;
  std::vector<AxisFeedback> drives;
  double last = -1.0;
};

TEST_F(SpindleAxisDrive, TellsWhereTheAxisBegins) {
  drives[lathe_C].position = 123.456;
  run();
  EXPECT_EQ(alarm(), "");
  EXPECT_NEAR(last, 128.456, 1e-9);
}

TEST_F(SpindleAxisDrive, ThatGoesOnTurningIsRefusedAfterATime) {
  drives[lathe_C].velocity = 30.0;
  run();
  EXPECT_THAT(alarm(), HasSubstr("E5206"));
  EXPECT_TRUE(bench.channel(1).drives[lathe_C].follows_velocity);
}

TEST_F(SpindleAxisDrive, WithoutReferenceIsRefused) {
  drives[lathe_C].referenced = false;
  run();
  EXPECT_THAT(alarm(), HasSubstr("E5207"));
  EXPECT_TRUE(bench.channel(1).drives[lathe_C].follows_velocity);
}

}  // namespace
}  // namespace stanok::channels
