// Axes that two channels have: claimed by schemes, waited for or refused, never moved by two.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "channels/machine/machine.h"
#include "tests/support/machine/machine_bench.h"

namespace stanok::channels {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::MachineBench;

constexpr std::size_t shared_C = 1;       // in both channels
constexpr double step_max = 0.12 + 1e-9;  // deg per cycle at 120 deg/s

class SharedAxis : public ::testing::Test {
 protected:
  SharedAxis() : bench(testing::machine_with_a_shared_axis()) {}

  void run(int channel, const std::string& text) {
    const std::string name = "p" + std::to_string(channel) + ".nc";
    bench.program(name, text);
    bench.run(channel, name);
  }
  // To the end; both channels show the same C, and it never jumps.
  void to_end() {
    bench.run_to_end([&](const CycleOutput& output) { look(output); });
  }
  void cycles(int count) {
    for (int n = 0; n < count; ++n) look(bench.cycle());
  }
  void look(const CycleOutput& output) {
    const double here = output.channels[0].axes[shared_C].position;
    EXPECT_EQ(output.channels[1].axes[shared_C].position, here);
    EXPECT_EQ(output.channels[1].drives[shared_C].enabled,
              output.channels[0].drives[shared_C].enabled);
    EXPECT_LE(std::abs(here - before), step_max);
    before = here;
  }
  [[nodiscard]] std::string alarm() {
    const auto alarms = bench.machine().alarms();
    return alarms.empty() ? "" : alarms.back().diagnostic.message;
  }

  MachineBench bench;
  double before = 0.0;
};

TEST_F(SharedAxis, IsClaimedBySchemesOneAfterTheOther) {
  run(1, "#kinematics (2, 1)\nG0 C30\n#kinematics (1, 1)\nM30\n");
  to_end();
  EXPECT_THAT(bench.alarm_codes(), IsEmpty());
  run(2,
      "#kinematics (2, 2)\nif ($pos[C] != 30) { terminate (1001, \"not 30\"); }\nG91 G0 C5\nM30\n");
  to_end();
  EXPECT_THAT(bench.alarm_codes(), IsEmpty());
  EXPECT_NEAR(bench.channel(1).axes[shared_C].position, 35.0, 1e-9);
}

TEST_F(SharedAxis, OfARunningChannelIsRefusedByName) {
  run(1, "#kinematics (2, 1)\nG1 C30 F300\nG4 P10\nM30\n");
  cycles(500);
  run(2, "#kinematics (2, 2)\nM30\n");
  cycles(100);
  EXPECT_THAT(bench.alarm_codes(), Contains("E5203"));
  EXPECT_THAT(alarm(), HasSubstr("axis C belongs to channel 1, which is running or held"));
  EXPECT_EQ(bench.channel(2).scheme, 1);
}

TEST_F(SharedAxis, CannotBeTakenFromASchemeThatIsAboutToHaveIt) {
  run(1, "#kinematics (2, 1)\nG0 C30\nM30\n");
  run(2, "#kinematics (2, 2)\nG0 C-30\nM30\n");
  to_end();
  EXPECT_THAT(bench.alarm_codes(), Contains("E5203"));
  EXPECT_NEAR(bench.channel(1).axes[shared_C].position, 30.0, 1e-9);
  EXPECT_EQ(bench.channel(2).scheme, 1);
}

TEST_F(SharedAxis, OfAHeldChannelIsRefused) {
  run(1, "#kinematics (2, 1)\nG1 C300 F3000\nM30\n");
  cycles(500);
  bench.ask(OperatorAction::program_hold, 1);
  cycles(500);
  run(2, "#kinematics (2, 2)\nM30\n");
  cycles(100);
  EXPECT_THAT(bench.alarm_codes(), Contains("E5203"));
}

TEST_F(SharedAxis, OutsideTheSchemeOfARunningChannelIsFree) {
  run(1, "#kinematics (2, 1)\nG0 C30\n#kinematics (1, 1)\nG1 X100 F600\nM30\n");
  cycles(1500);
  EXPECT_TRUE(bench.channel(1).moving);
  run(2, "#kinematics (2, 2)\nG0 C40\nM30\n");
  cycles(1000);
  EXPECT_THAT(bench.alarm_codes(), IsEmpty());
  EXPECT_NEAR(bench.channel(2).axes[shared_C].position, 40.0, 1e-9);
  to_end();
  EXPECT_EQ(bench.channel(1).axes[0].position, 100.0);
}

TEST_F(SharedAxis, GoesBackToAChannelThatStartsWithItsScheme) {
  run(1, "#kinematics (2, 1)\nG0 C30\nM30\n");
  to_end();
  run(2, "#kinematics (2, 2)\nG0 C50\nM30\n");
  to_end();
  run(1, "G91 G0 C1\nM30\n");
  to_end();
  EXPECT_THAT(bench.alarm_codes(), IsEmpty());
  EXPECT_NEAR(bench.channel(1).axes[shared_C].position, 51.0, 1e-9);
}

TEST_F(SharedAxis, KeepsAProgramFromStartingWhileAnotherChannelRunsWithIt) {
  run(1, "#kinematics (2, 1)\nM30\n");
  to_end();
  run(2, "#kinematics (2, 2)\nG1 C300 F3000\nM30\n");
  cycles(1000);
  run(1, "G0 X1\nM30\n");
  cycles(100);
  ASSERT_FALSE(bench.replies().empty());
  EXPECT_EQ(bench.replies().back().code.view(), "E5203");
  EXPECT_FALSE(bench.channel(1).running);
}

TEST_F(SharedAxis, CannotBeProgrammedOutsideTheScheme) {
  run(1, "G0 C1\nM30\n");
  to_end();
  EXPECT_THAT(bench.alarm_codes(), Contains("E5102"));
}

TEST_F(SharedAxis, SaysWhichChannelHasIt) {
  run(2, "#kinematics (2, 2)\nM30\n");
  to_end();
  run(1, "if ($axis_channel[C] != 2) { terminate (1001, \"not 2\"); }\nM30\n");
  to_end();
  EXPECT_THAT(bench.alarm_codes(), IsEmpty());
}

}  // namespace
}  // namespace stanok::channels
