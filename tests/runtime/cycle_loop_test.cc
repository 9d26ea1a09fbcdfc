// Position loops closed in the cycle, from the program to the simulated drives and back.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "config/files/machine_file.h"
#include "runtime/assembly.h"
#include "tests/config/temporary_files.h"
#include "tests/support/project_folders.h"

namespace stanok::runtime {
namespace {

// mill3 with velocity drives on a bus that is polled every `poll_ms`.
config::MachineFile mill(const motion::ControllerGains& gains, int poll_ms) {
  config::MachineFile file =
      config::read_machine_file(std::filesystem::path(stanok::testing::source_folder()) / "config" /
                                "machines" / "mill3.toml");
  file.bus.poll_ms = poll_ms;
  for (channels::AxisConfig& axis : file.machine.axes) {
    axis.controller = {.feedback = channels::FeedbackPlace::cycle,
                       .gains = gains,
                       .demand_held_s = poll_ms * 1e-3};
    axis.following_error_max = 2.0;
  }
  return file;
}

// The gains that invert the simulated drives of the machine file (docs/developer/motion.md).
motion::ControllerGains inverting(double kp) {
  const config::SimulationConfig drive;
  const double w = 2.0 * std::numbers::pi * drive.servo_frequency_hz;
  const double r = 2.0 * std::numbers::pi * drive.resonance_frequency_hz;
  return {.kp = kp, .ka = 2.0 * drive.servo_damping / w, .kr = 1.0 / (w * w) + 1.0 / (r * r)};
}

struct Followed {
  bool ok = false;
  std::vector<double> errors;      // of X, at the instants of the drive
  std::vector<double> velocities;  // of its setpoint in the same cycles
};

class CycleLoop : public ::testing::Test {
 protected:
  [[nodiscard]] Followed run(const config::MachineFile& file, const std::string& program) {
    files_.write("part.nc", program);
    Assembly assembly({.file = file,
                       .drives = DriveChoice::simulated,
                       .program_roots = {files_.folder()},
                       .machine = {.on_at_start = true, .stops_go_on = true},
                       .output_capacity = 0});
    channels::OperatorEvent start;
    start.command = channels::commands::ProgramRun{channels::ShortText("part.nc")};
    start.channel = 1;
    for (int n = 0; n < 100; ++n) assembly.cycle({});  // the drives are switched on
    Followed followed;
    cycle(assembly, {&start, 1}, followed);
    for (int n = 0; n < 20000 && !assembly.machine().is_idle(); ++n) cycle(assembly, {}, followed);
    followed.ok = assembly.machine().is_idle() && assembly.machine().alarms().empty();
    return followed;
  }

 private:
  static void cycle(Assembly& assembly, std::span<const channels::OperatorEvent> events,
                    Followed& followed) {
    while (assembly.machine().prepare(0) != channels::Progress::blocked) {
    }
    const channels::CycleOutput& output = assembly.cycle(events);
    const channels::AxisFeedback& x = assembly.feedback()[0];
    followed.errors.push_back(x.setpoint - x.position);
    followed.velocities.push_back(output.channels[0].axes[0].velocity);
  }

  config::TemporaryFiles files_;
};

double worst(const std::vector<double>& errors) {
  double worst = 0.0;
  for (const double error : errors) worst = std::max(worst, std::abs(error));
  return worst;
}

const std::string circle = "G17 G21 G90 G94\nG1 X20 F3000\nG2 I-20 F6000\nG1 Y10\nM30\n";

// Positions and targets are whole micrometres, and the loop passes the rounding on.
TEST_F(CycleLoop, AxesFollowACircleAndItsRampsWithinMicrometres) {
  const Followed followed = run(mill(inverting(40.0), 1), circle);
  ASSERT_TRUE(followed.ok);
  EXPECT_GT(worst(followed.velocities), 99.0);
  EXPECT_LE(worst(followed.errors), 0.003);
}

// Without what is fed forward the loop lags by v / kp.
TEST_F(CycleLoop, ProportionalLoopLagsByVelocityOverGain) {
  const Followed followed = run(mill({.kp = 40.0, .kv = 0.0}, 1), "G1 X30 F1200\nM30\n");
  ASSERT_TRUE(followed.ok);
  EXPECT_NEAR(worst(followed.errors), 20.0 / 40.0, 0.0015);
}

// Ten cycles in which no drive is asked, with U made for all of them.
TEST_F(CycleLoop, BusPolledEveryTenCyclesIsFollowedToo) {
  const Followed followed = run(mill(inverting(20.0), 10), circle);
  ASSERT_TRUE(followed.ok);
  EXPECT_LE(worst(followed.errors), 0.05);
}

TEST_F(CycleLoop, GivesTheSameBitsEveryRun) {
  const Followed first = run(mill(inverting(40.0), 1), circle);
  const Followed second = run(mill(inverting(40.0), 1), circle);
  EXPECT_EQ(first.errors, second.errors);
}

}  // namespace
}  // namespace stanok::runtime
