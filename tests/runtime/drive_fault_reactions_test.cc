// Every fault that a drive can show while its axis moves along a path: how the machine reacts, how
// soon, where it stops, and how an operator gets it going again.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/runtime/drive_bench.h"

namespace stanok::runtime {
namespace {

using channels::ChannelOutput;
using plant::FaultKind;

// Two axes with incremental encoders.
std::vector<AxisPlace> axes() {
  return {{.home_from = 80.0, .home_to = 90.0}, {.home_from = 80.0, .home_to = 90.0}};
}

// In the ratio 2 : 1 from (0, 0), where each move of the program begins and ends.
constexpr const char* slanting =
    "G61\nG1 X0 Y0 F6000\nG4 P0.2\nG1 X60 Y30 F6000\nG1 X-60 Y-30\nG1 X0 Y0\nM30\n";

double distance_from_path(const ChannelOutput& output) {
  return std::abs(output.axes[0].position - 2.0 * output.axes[1].position) / std::sqrt(5.0);
}

struct Reaction {
  const char* name;
  FaultKind fault;
  const char* alarm;  // nullptr: the machine bears it
  // An incremental encoder out of sight may have begun anew: the axis has to be homed again.
  bool forgets_place;
};

class DriveFaultReactions : public ::testing::TestWithParam<Reaction> {
 protected:
  DriveFaultReactions() : bench(axes()) {
    bench.program("slant.nc", slanting);
    EXPECT_EQ(bench.reply_to(bench.ask(OperatorAction::home)), "ok") << bench.text();
    EXPECT_EQ(bench.reply_to(bench.ask(OperatorAction::program_run, "slant.nc")), "ok")
        << bench.text();
    while (bench.output().axes[0].position > 1e-6 || bench.output().axes[0].velocity != 0.0)
      bench.cycle();  // from the home position to the path
    for (int k = 0; k < 500; ++k) bench.cycle();
    EXPECT_NEAR(bench.output().path_speed, 100.0, 1e-6);
  }

  [[nodiscard]] bool sees_fault() const {
    const channels::AxisFeedback& drive = bench.output().feedback[0];
    return !drive.valid || drive.fault || drive.strays;
  }

  // Until the feedback that a cycle acts on shows the fault.
  void wait_for_detection() {
    for (int k = 0; k < 2000 && !sees_fault(); ++k) bench.cycle();
    ASSERT_TRUE(sees_fault());
  }

  // As docs/reference/command-line.md tells: reset, machine on, home what lost its place, start
  // again.
  void recover() {
    EXPECT_EQ(bench.reply_to(bench.ask(OperatorAction::program_reset)), "ok") << bench.text();
    EXPECT_EQ(bench.reply_to(bench.ask(OperatorAction::machine_on)), "ok") << bench.text();
    bench.run(0.5);
    if (GetParam().forgets_place) {
      EXPECT_EQ(bench.reply_to(bench.ask(OperatorAction::program_run, "slant.nc")), "E5208");
      EXPECT_EQ(bench.reply_to(bench.ask(OperatorAction::home)), "ok") << bench.text();
    }
    ASSERT_EQ(bench.reply_to(bench.ask(OperatorAction::program_run, "slant.nc")), "ok")
        << bench.text();
    for (int k = 0; k < 30000 && bench.output().running; ++k) bench.cycle();
    EXPECT_EQ(bench.machine().alarms().size(), 1U);
    EXPECT_NEAR(bench.setpoint(0), 0.0, 1e-9);
    EXPECT_NEAR(bench.output().feedback[0].position, 0.0, 0.05);
  }

  DriveBench bench;
};

TEST_P(DriveFaultReactions, StopAlongThePathWithinTwoCyclesAndWaitForAnOperator) {
  const Reaction& reaction = GetParam();
  bench.fail("X", reaction.fault);
  if (reaction.alarm == nullptr) {
    for (int k = 0; k < 20000 && bench.output().running; ++k) {
      bench.cycle();
      ASSERT_LE(distance_from_path(bench.output()), 1e-9);
    }
    EXPECT_TRUE(bench.machine().alarms().empty());
    EXPECT_FALSE(bench.output().running);
    return;
  }
  wait_for_detection();
  const double speed = bench.output().path_speed;
  bench.cycle();
  bench.cycle();
  EXPECT_LT(bench.output().path_speed, speed);
  double before = bench.output().path_speed;
  for (int k = 0; k < 2000 && before > 0.0; ++k) {
    bench.cycle();
    EXPECT_LE(bench.output().path_speed, before + 1e-9);
    EXPECT_LE(distance_from_path(bench.output()), 1e-9);
    before = bench.output().path_speed;
  }
  EXPECT_EQ(before, 0.0);
  ASSERT_EQ(bench.machine().alarms().size(), 1U);
  EXPECT_EQ(bench.machine().alarms()[0].diagnostic.code, reaction.alarm);
  bench.run(0.1);
  EXPECT_FALSE(bench.output().drives[0].enabled);
  EXPECT_FALSE(bench.output().drives[1].enabled);
  // The drive works again: nothing goes on by itself.
  const double stands_at = bench.setpoint(1);
  bench.fail("X", FaultKind::none);
  bench.run(2.0);
  EXPECT_EQ(bench.setpoint(1), stands_at);
  // What is shown, kept and touched off is what the drive says, not where the channel had stopped.
  EXPECT_TRUE(bench.output().feedback[0].valid);
  EXPECT_NEAR(bench.setpoint(0), bench.output().feedback[0].position, 0.01);
  EXPECT_FALSE(bench.output().running);
  EXPECT_EQ(bench.output().state, channels::ChannelState::alarm);
  recover();
}

INSTANTIATE_TEST_SUITE_P(
    Faults, DriveFaultReactions,
    ::testing::Values(Reaction{"without_power", FaultKind::off, "A3001", true},
                      Reaction{"stuck", FaultKind::stuck, "A3001", true},
                      Reaction{"garbage", FaultKind::garbage, "A3001", true},
                      Reaction{"too_slow", FaultKind::slow, "A3001", true},
                      Reaction{"one_request_in_five_lost", FaultKind::intermittent, nullptr, false},
                      Reaction{"trips", FaultKind::trip, "A3002", false},
                      Reaction{"comes_back_elsewhere", FaultKind::elsewhere, "A3001", true},
                      Reaction{"mangled_frames", FaultKind::mangled, "A3001", true},
                      Reaction{"hangs_up", FaultKind::hang_up, "A3001", true},
                      Reaction{"jammed", FaultKind::jammed, "A3002", false},
                      Reaction{"frozen", FaultKind::frozen, "A3003", false}),
    [](const auto& one) { return std::string(one.param.name); });

}  // namespace
}  // namespace stanok::runtime
