// The machine as a whole on a virtual clock: programs in, setpoints out.
#include "channels/machine/machine.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "tests/support/cycle.h"
#include "tests/support/machine/machine_bench.h"
#include "tests/support/no_allocation.h"

namespace stanok::channels {
namespace {

using ::testing::Contains;
using testing::cycle_s;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using testing::MachineBench;

// Fails when an axis steps further in a cycle than its velocity limit allows.
class StepGuard {
 public:
  void operator()(const CycleOutput& output) {
    constexpr double slack = 1e-9;
    const ChannelOutput& channel = output.channels[0];
    const std::array<double, 5> velocity_max{250.0, 250.0, 250.0, 120.0, 120.0};
    for (std::size_t k = 0; k < velocity_max.size() && seen_; ++k) {
      const double step = std::abs(channel.axes[k].position - last_[k]);
      ASSERT_LE(step, velocity_max[k] * cycle_s + slack)
          << "axis " << k << " cycle " << output.cycle;
    }
    for (std::size_t k = 0; k < velocity_max.size(); ++k) last_[k] = channel.axes[k].position;
    seen_ = true;
  }

 private:
  std::array<double, 5> last_{};
  bool seen_ = false;
};

TEST(Machine, EndsAtTheProgrammedPointToTheBit) {
  MachineBench bench;
  bench.program("p.nc", "G21 G90 G54\nG0 X33.3 Y-7.1\nG1 Z-1.7 F600\nX10.1 Y20.2\nM30\n");
  bench.run(1, "p.nc");
  StepGuard guard;
  bench.run_to_end([&](const CycleOutput& output) { guard(output); });
  ASSERT_THAT(bench.alarm_codes(), IsEmpty());
  EXPECT_EQ(bench.channel(1).axes[0].position, 10.1);
  EXPECT_EQ(bench.channel(1).axes[1].position, 20.2);
  EXPECT_EQ(bench.channel(1).axes[2].position, -1.7);
  const auto runs = bench.machine().runs();
  ASSERT_EQ(runs.size(), 1U);
  EXPECT_TRUE(runs[0].ok);
  EXPECT_EQ(runs[0].blocks, 5U);
}

TEST(Machine, DwellLastsTheProgrammedCycles) {
  const auto cycles_of = [](const std::string& text) {
    MachineBench bench;
    bench.program("p.nc", text);
    bench.run(1, "p.nc");
    bench.run_to_end();
    const auto runs = bench.machine().runs();
    return runs.at(0).end_cycle - runs.at(0).start_cycle;
  };
  EXPECT_EQ(cycles_of("G4 P0.25\nM30\n") - cycles_of("M30\n"), 250);
}

TEST(Machine, StandsDuringTheDwellBetweenMoves) {
  MachineBench bench;
  bench.program("p.nc", "G21 G90\nG1 X1 F600\nG4 P0.2\nX2\nM30\n");
  bench.run(1, "p.nc");
  int at_rest = 0;
  bench.run_to_end([&](const CycleOutput& output) {
    if (output.channels[0].axes[0].position == 1.0) ++at_rest;
  });
  EXPECT_GE(at_rest, 200);
  EXPECT_LE(at_rest, 203);
}

TEST(Machine, MasterProgramSwitchesKinematicsAndRunsTheWorker) {
  MachineBench bench;
  bench.program("three.nc", "G21 G90 G54\nG1 X10 Y5 Z-2 F3000\nM30\n");
  bench.program("five.nc",
                "G21 G90 G54\nG43.4 H1\nG1 X5 Y5 Z0 B10 C20 F3000\nX0 B0 C0\nG49\nM30\n");
  bench.program("master.nc",
                "#include \"three.nc\"\n#include \"five.nc\"\n#kinematics (1, 1)//first\n"
                "if(channel_run (1, \"three.nc\") == false)\n{terminate (1006, \"three.nc\");}\n"
                "channel_wait (1); //wait\n#kinematics (2, 1)\n"
                "if(channel_run (1, \"five.nc\") == false)\n{terminate (1006, \"five.nc\");}\n"
                "channel_wait (1);\nM30\n");
  bench.run(2, "master.nc");
  StepGuard guard;
  bool drives_were_off = false;
  bool rotary_moved = false;
  bench.run_to_end([&](const CycleOutput& output) {
    guard(output);
    const ChannelOutput& work = output.channels[0];
    if (work.running && work.scheme == 1) {
      drives_were_off = drives_were_off || !work.drives[3].enabled;
      EXPECT_EQ(work.axes[3].position, 0.0);
      EXPECT_TRUE(work.drives[4].brake_closed);
    }
    if (work.running && work.scheme == 2)
      rotary_moved = rotary_moved || work.axes[4].position > 1.0;
  });
  ASSERT_THAT(bench.alarm_codes(), IsEmpty());
  EXPECT_TRUE(drives_were_off);
  EXPECT_TRUE(rotary_moved);
  EXPECT_EQ(bench.machine().runs().size(), 3U);
}

TEST(Machine, MissingWorkerProgramEndsTheMasterWithItsOwnCode) {
  MachineBench bench;
  bench.program(
      "master.nc",
      "if(channel_run (1, \"absent.nc\") == false)\n{terminate (1006, \"absent.nc\");}\nM30\n");
  bench.run(2, "master.nc");
  bench.run_to_end();
  EXPECT_THAT(bench.alarm_codes(), ElementsAre("U1006"));
  EXPECT_EQ(bench.channel(2).state, ChannelState::alarm);
}

TEST(Machine, PoseOutOfReachStopsTheProgramAtTheBlockBefore) {
  MachineBench bench;
  bench.program("p.nc", "G21 G90\nG1 X10 F6000\nX600\nM30\n");
  bench.run(1, "p.nc");
  bench.run_to_end();
  EXPECT_THAT(bench.alarm_codes(), ElementsAre("E5101"));
  EXPECT_EQ(bench.channel(1).axes[0].position, 10.0);
  ASSERT_EQ(bench.machine().alarms().size(), 1U);
  EXPECT_EQ(bench.machine().alarms()[0].diagnostic.place.line, 3);
}

TEST(Machine, FeedPerRevolutionNeedsATurningSpindle) {
  MachineBench bench;
  bench.program("p.nc", "G21 G90 G94\nG1 X10 F6000\nG95 F0.1\nX20\nM30\n");
  bench.run(1, "p.nc");
  bench.run_to_end();
  EXPECT_THAT(bench.alarm_codes(), ElementsAre("E4021"));
  EXPECT_EQ(bench.channel(1).axes[0].position, 10.0) << "the end of the block before";
  ASSERT_EQ(bench.machine().alarms().size(), 1U);
  EXPECT_EQ(bench.machine().alarms()[0].diagnostic.place.line, 4);
}

TEST(Machine, DoesNotParkAnAxisBeyondItsLimits) {
  MachineConfig config = testing::two_channel_machine();
  config.axes[3].limits.position_min = -30.0;
  config.axes[3].limits.position_max = 30.0;
  config.channels[0].scheme = 2;
  config.channels[0].schemes[0].parking[0].position = 45.0;  // B
  MachineBench bench(config);
  bench.program("p.nc", "#kinematics (1, 1)\nM30\n");
  bench.run(1, "p.nc");
  bench.run_to_end();
  EXPECT_THAT(bench.alarm_codes(), ElementsAre("E5204"));
  EXPECT_EQ(bench.channel(1).axes[3].position, 0.0);
  EXPECT_EQ(bench.channel(1).scheme, 2) << "all or nothing";
}

TEST(Machine, ProgramSwitchesTheKinematicsOfItsOwnChannel) {
  MachineBench bench;
  bench.program("p.nc",
                "#kinematics (2, 1)\nG1 X10 B20 F3000\n#kinematics (1, 1)\nG1 X5 F3000\nM30\n");
  bench.run(1, "p.nc");
  StepGuard guard;
  bench.run_to_end([&](const CycleOutput& output) { guard(output); });
  EXPECT_THAT(bench.alarm_codes(), IsEmpty());
  EXPECT_EQ(bench.channel(1).scheme, 1);
  EXPECT_EQ(bench.channel(1).axes[0].position, 5.0);
  EXPECT_EQ(bench.channel(1).axes[3].position, 0.0) << "B is parked";
  EXPECT_FALSE(bench.channel(1).drives[3].enabled);
}

TEST(Machine, SimulatedRunEndsAtM99OfTheMainProgram) {
  MachineBench bench;
  bench.program("p.nc", "G21 G90\nG1 X10 F6000\nM99\n");
  bench.run(1, "p.nc");
  bench.run_to_end();
  EXPECT_THAT(bench.alarm_codes(), IsEmpty());
  EXPECT_THAT(bench.event_codes(), Contains("W2099"));
  EXPECT_EQ(bench.channel(1).state, ChannelState::ready);
}

TEST(Machine, HoldStandsOnThePathAndResumeReachesTheEnd) {
  MachineBench bench;
  bench.program("p.nc", "G21 G90\nG1 X100 F6000\nM30\n");
  bench.run(1, "p.nc");
  StepGuard guard;
  for (int n = 0; n < 300; ++n) guard(bench.cycle());
  bench.ask(OperatorAction::program_hold, 1);
  for (int n = 0; n < 300; ++n) guard(bench.cycle());
  const double held = bench.channel(1).axes[0].position;
  EXPECT_EQ(bench.channel(1).state, ChannelState::held);
  EXPECT_EQ(bench.channel(1).axes[0].velocity, 0.0);
  EXPECT_GT(held, 1.0);
  EXPECT_LT(held, 99.0);
  guard(bench.cycle());
  EXPECT_EQ(bench.channel(1).axes[0].position, held);
  bench.ask(OperatorAction::program_resume, 1);
  bench.run_to_end([&](const CycleOutput& output) { guard(output); });
  EXPECT_EQ(bench.channel(1).axes[0].position, 100.0);
  EXPECT_EQ(bench.channel(1).axes[1].position, 0.0);
}

TEST(Machine, ResetForgetsThePathAndTheNextProgramRunsFromThere) {
  MachineBench bench;
  bench.program("long.nc", "G21 G90\nG1 X100 F6000\nX0\nX100\nM30\n");
  bench.program("next.nc", "G21 G91\nG1 X1 F600\nM30\n");
  bench.run(1, "long.nc");
  StepGuard guard;
  for (int n = 0; n < 400; ++n) guard(bench.cycle());
  bench.ask(OperatorAction::program_reset, 1);
  bench.run_to_end([&](const CycleOutput& output) { guard(output); });
  EXPECT_EQ(bench.channel(1).state, ChannelState::ready);
  const double stood = bench.channel(1).axes[0].position;
  bench.run(1, "next.nc");
  bench.run_to_end([&](const CycleOutput& output) { guard(output); });
  EXPECT_THAT(bench.alarm_codes(), IsEmpty());
  EXPECT_NEAR(bench.channel(1).axes[0].position, stood + 1.0, 1e-12);
}

TEST(Machine, RefusesToSwitchTheKinematicsOfARunningChannel) {
  MachineBench bench;
  bench.program("work.nc", "G21 G90\nG1 X100 F600\nM30\n");
  bench.program("master.nc", "channel_run (1, \"work.nc\");\n#kinematics (2, 1)\nM30\n");
  bench.run(2, "master.nc");
  bench.run_to_end();
  EXPECT_THAT(bench.alarm_codes(), Contains("E5202"));
  EXPECT_EQ(bench.channel(1).state, ChannelState::held) << "the run of a failed owner is held";
}

TEST(Machine, CycleNeverUsesTheHeap) {
  MachineBench bench;
  bench.program("p.nc", "G21 G90 G64 P0.01\nG1 X10 F6000\nY10\nG2 X20 Y0 I0 J-10\nG4 P0.01\nM30\n");
  bench.run(1, "p.nc");
  for (int n = 0; n < 5; ++n) bench.cycle();
  for (int n = 0; n < 2000; ++n) {
    while (bench.machine().prepare(0) != Progress::blocked) {
    }
    CycleOutput output;
    const testing::NoAllocation guard;
    bench.machine().cycle({}, output);
  }
}

TEST(Machine, SameRunGivesTheSameBits) {
  const auto record = [] {
    MachineBench bench;
    bench.program("p.nc", "G21 G90 G64 P0.01\nG1 X10 F6000\nY10\nX0 Y3\nG3 X5 Y8 I5 J0\nM30\n");
    bench.run(1, "p.nc");
    std::string bytes;
    bench.run_to_end([&](const CycleOutput& output) {
      const auto& axes = output.channels[0].axes;
      bytes.append(reinterpret_cast<const char*>(axes.data()), sizeof(axes));
    });
    return bytes;
  };
  EXPECT_EQ(record(), record());
}

}  // namespace
}  // namespace stanok::channels
