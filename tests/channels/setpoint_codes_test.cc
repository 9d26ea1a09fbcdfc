// Integer codes and velocity demands in the output of a channel, and position loops closed in the
// cycle.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/machine/machine_bench.h"

namespace stanok::channels {
namespace {

using testing::MachineBench;

TEST(SetpointCodes, AreThePositionAndTheMeanVelocityOfEveryCycle) {
  MachineConfig config = testing::two_channel_machine();
  config.axes[0].resolution = 0.01;
  config.axes[0].kmv = 1e6;
  config.axes[1].resolution = 0.0005;
  config.axes[1].kmv = 1000.0;
  config.axes[1].start = 1.23456;
  MachineBench bench(config);
  bench.program("arc.nc", "G90\nG1 X3 Y-2 F30\nG2 X5 Y0 I2 F1200\nG0 X0 Y7.00033\nM30\n");
  bench.run(1, "arc.nc");
  std::array<double, 2> before{0.0, 1.23456};
  std::array<double, 2> travelled{};
  int cycles = 0;
  bench.run_to_end([&](const CycleOutput& output) {
    ++cycles;
    for (std::size_t k = 0; k < 2; ++k) {
      const AxisSetpoint& setpoint = output.channels[0].axes[k];
      const double z = config.axes[k].resolution;
      const double kmv = config.axes[k].kmv;
      ASSERT_EQ(setpoint.position_code, std::llround(setpoint.position / z));
      const double step = (setpoint.position - before[k]) / z * kmv;
      ASSERT_LE(std::abs(static_cast<double>(setpoint.velocity_code) - step), 0.5 + 1e-6);
      ASSERT_EQ(setpoint.velocity_demand, setpoint.velocity);
      travelled[k] += static_cast<double>(setpoint.velocity_code) / kmv * z;
      before[k] = setpoint.position;
    }
  });
  EXPECT_NEAR(travelled[0], 0.0, 0.5 * 0.01 / 1e6 * cycles);
  EXPECT_NEAR(travelled[1], 7.00033 - 1.23456, 0.5 * 0.0005 / 1e3 * cycles);
}

// Channel 1 with the position loop of X in the cycle; the drives answer what the test says.
class CycleLoop : public ::testing::Test {
 protected:
  static MachineConfig machine() {
    MachineConfig config = testing::two_channel_machine();
    config.axes[0].controller = {.feedback = FeedbackPlace::cycle,
                                 .gains = {.kp = 30.0, .kint = 0.5, .ka = 0.002, .kr = 1e-5}};
    return config;
  }
  // X stands `error` behind what its drive was told.
  double demand(double error) {
    drives[0].setpoint = 0.7;
    drives[0].position = 0.7 - error;
    bench.feedback(drives);
    bench.cycle();
    return bench.channel(1).axes[0].velocity_demand;
  }

  MachineBench bench{machine()};
  std::vector<AxisFeedback> drives{
      machine().axes.size(), AxisFeedback{.valid = true, .enabled = true, .referenced = true}};
};

TEST_F(CycleLoop, AxisThatIsBehindIsDrivenOn) {
  EXPECT_NEAR(demand(0.02), 30.0 * 0.02 + 0.5 * 0.02, 1e-12);
  EXPECT_NEAR(demand(0.01), 30.0 * 0.01 + 0.5 * 0.03, 1e-12);
  EXPECT_EQ(bench.channel(1).axes[1].velocity_demand, 0.0);  // its drive closes the loop itself
}

TEST_F(CycleLoop, NothingIsSummedUpWhileTheDriveDoesNotHoldTheAxis) {
  drives[0].enabled = false;
  for (int n = 0; n < 100; ++n) EXPECT_EQ(demand(0.02), 0.0);
  drives[0].enabled = true;
  EXPECT_NEAR(demand(0.02), 30.0 * 0.02 + 0.5 * 0.02, 1e-12);
}

TEST_F(CycleLoop, MachineThatIsSwitchedOffAsksForNothing) {
  static_cast<void>(demand(0.02));
  bench.ask(OperatorAction::machine_off, 0);
  while (bench.channel(1).drives[0].enabled) static_cast<void>(demand(0.02));
  for (int n = 0; n < 10; ++n) EXPECT_EQ(demand(0.02), 0.0);
}

// On an axis that is where it should be, U is what the coming cycle asks for: at the instant of the
// setpoint and with its derivatives.
TEST_F(CycleLoop, MotionIsFedForward) {
  bench.program("line.nc", "G1 X20 F6000\nM30\n");
  bench.run(1, "line.nc");
  const double t = 0.001;
  double fastest = 0.0;
  for (int n = 0; n < 400; ++n) {
    const double demanded = demand(0.0);
    const AxisSetpoint& x = bench.channel(1).axes[0];
    const double velocity = x.velocity + t / 2.0 * x.acceleration + t * t / 6.0 * x.jerk;
    const double acceleration = x.acceleration + t / 2.0 * x.jerk;
    ASSERT_NEAR(demanded, velocity + 0.002 * acceleration + 1e-5 * x.jerk, 1e-9);
    fastest = std::max(fastest, demanded);
  }
  EXPECT_GE(fastest, 100.0);
}

}  // namespace
}  // namespace stanok::channels
