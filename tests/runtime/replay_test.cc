// Recorded runs are repeated from their logs, bit for bit, whatever the timing of the preparations
// was and whatever an operator did; a log that was tampered with or cut is found out.
#include "runtime/replay.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <stanok_messages/input_t.hpp>

#include "recording/read/log_contents.h"
#include "tests/runtime/recorded_by_chance.h"
#include "tests/support/sanitized.h"

namespace stanok::runtime {
namespace {

// Operators at random, over drives at random.
class ReplayOfAnything : public ::testing::TestWithParam<int> {};

TEST_P(ReplayOfAnything, IsTheSameBitForBit) {
  const auto seed = static_cast<std::uint64_t>(GetParam());
  RecordedByChance run("mill3.toml", seed % 2 == 0 ? DriveChoice::simulated : DriveChoice::ideal,
                       seed);
  run.program("contour.nc", contour);
  run.run(200);
  for (int n = 0; n < 40; ++n) {
    switch (run.chance(9)) {
      case 0:
      case 1:
      case 2:
        run.ask(OperatorAction::program_run, 1, "contour.nc");
        break;
      case 3:
        run.ask(OperatorAction::program_hold, 1);
        break;
      case 4:
        run.ask(OperatorAction::program_resume, 1);
        break;
      case 5:
        run.ask(OperatorAction::override_feed, 1, "", 0.2 + 0.01 * run.chance(130));
        break;
      case 6:
        run.ask(OperatorAction::program_reset, 1);
        break;
      case 7:
        run.ask(OperatorAction::mdi, 1, "G0 X" + std::to_string(run.chance(50)));
        break;
      default:
        run.ask(OperatorAction::jog, 1, "Z", 20.0, run.chance(2) == 0 ? 3.0 : -3.0);
    }
    run.run(50 + run.chance(500));
  }
  run.close();
  EXPECT_TRUE(run.moved());
  const ReplayResult result = replay(run.path(), {});
  EXPECT_TRUE(result.is_same());
  EXPECT_GT(result.setpoints, 2000);
  if (result.difference) {
    ADD_FAILURE() << "cycle " << result.difference->cycle << " " << result.difference->field << " "
                  << result.difference->recorded << " " << result.difference->repeated;
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, ReplayOfAnything,
                         ::testing::Range(0, stanok::testing::is_sanitized ? 6 : 12));

// The files of the machine are named from its folder, however that was written.
TEST(Replay, FindsTheTablesOfAMachineThatWasNamedByADetour) {
  const std::filesystem::path detour = source_tree / ".." / source_tree.filename();
  RecordedByChance run((detour / "config" / "machines" / "trunnion.toml").string(),
                       DriveChoice::ideal, 1);
  run.run(20);
  run.close();
  EXPECT_TRUE(replay(run.path(), {}).is_same());
}

TEST(Replay, ALogSaysWhichMachineFileItIsOf) {
  RecordedByChance run("mill3.toml", DriveChoice::ideal, 1);
  run.run(10);
  run.close();
  std::ifstream file(source_tree / "config" / "machines" / "mill3.toml", std::ios::binary);
  std::uint64_t fnv1a = 14695981039346656037U;
  for (char byte = 0; file.get(byte);)
    fnv1a = (fnv1a ^ static_cast<unsigned char>(byte)) * 1099511628211U;
  const auto contents = recording::read_contents(run.path());
  ASSERT_TRUE(contents && contents->description);
  EXPECT_EQ(contents->description->config_hash, fnv1a);
}

// As after a daemon that ended elsewhere.
TEST(Replay, OfARunThatBeganWhereTheAxesStoodLast) {
  for (const DriveChoice drives : {DriveChoice::ideal, DriveChoice::simulated}) {
    RecordedByChance run("mill3.toml", drives, 5, {{"X", 31.0 / 3.0}, {"Z", -0.1}});
    run.program("line.nc", "G91\nG1 X3 Y1 F3000\nM30\n");
    run.ask(OperatorAction::program_run, 1, "line.nc");
    run.run(3000);
    run.close();
    EXPECT_TRUE(run.moved());
    EXPECT_TRUE(replay(run.path(), {}).is_same());
  }
}

// Wear and offsets written while a program runs, by an operator and by the program of another
// channel: blocks that are read behind that take them. How far ahead the preparation was is in the
// log.
class ReplayOfTables : public ::testing::TestWithParam<int> {
 protected:
  static constexpr const char* laps =
      "#1=0\nT1 M6\nwhile (#1 < 5000) {\nG54\nG43 H1\n"
      "G1 X[0.5*cos[#1*40]] Y[0.5*sin[#1*40]] Z1 F6000\n#1=[#1+1]\n}\nM30\n";

  // The log of a run in which tables are written at random.
  void record(RecordedByChance& run, int channel) const {
    run.program("laps.nc", laps);
    run.run(20);
    run.ask(OperatorAction::program_run, channel, "laps.nc");
    run.run(10);
    for (int n = 0; n < 30; ++n) {
      run.prepare_every(300 + run.chance(600));  // as one that is held up
      run.run(100 + run.chance(800));
      channels::OperatorEvent event;
      const double value = 0.01 * run.chance(40);
      if (run.chance(2) == 0) {
        event.command = channels::commands::ToolSet{
            .key = channels::ShortText("wear_length"), .value = value, .tool = 1};
      } else {
        event.command =
            channels::commands::OffsetSet{.place = channels::ShortText("G54 X"), .value = value};
      }
      run.ask(event);
    }
    run.run(2000);
    run.close();
    EXPECT_TRUE(run.moved());
  }

  static void expect_to_need_its_takings(const RecordedByChance& run) {
    int takings = 0;
    const auto without = changed<input_t>(run.path(), recording::Topic::input, [&](input_t& input) {
      if (input.kind != 7) return;
      ++takings;
      input.method = 0;  // of a run that never was
    });
    EXPECT_GT(takings, 0);
    EXPECT_FALSE(replay(without, {}).is_same()) << "without the takings it cannot be known";
  }
};

TEST_P(ReplayOfTables, ThatAnOperatorWritesIsTheSameBitForBit) {
  RecordedByChance run("mill3.toml", DriveChoice::ideal, static_cast<std::uint64_t>(GetParam()));
  record(run, 1);
  const ReplayResult result = replay(run.path(), {});
  EXPECT_TRUE(result.is_same());
  EXPECT_GT(result.setpoints, 2000);
  expect_to_need_its_takings(run);
}

TEST_P(ReplayOfTables, ThatAnotherChannelWritesIsTheSameBitForBit) {
  RecordedByChance run("e7106mf4.toml", DriveChoice::ideal, static_cast<std::uint64_t>(GetParam()));
  run.program("laps.nc",
              "#1=0\nwhile (#1 < 5000) {\nG43 H1\nG1 Z0 X[0.5*cos[#1*40]] Y[0.5*sin[#1*40]] F6000\n"
              "#1=[#1+1]\n}\nM30\n");
  run.program("master.nc",
              "#kinematics (1, 1)\nchannel_run (1, \"laps.nc\");\n#1=0\nwhile (#1 < 60) {\n"
              "settable_tool (1, 1, \"wear_length\", 0.01*#1);\nG4 P0.05\n#1=[#1+1]\n}\n"
              "channel_wait (1);\nM30\n");
  run.ask(OperatorAction::program_run, 2, "master.nc");
  run.run(1000);
  for (int n = 0; n < 20; ++n) {
    run.prepare_every(900 + run.chance(1200));
    run.run(1500);
  }
  run.close();
  EXPECT_TRUE(run.moved());
  const ReplayResult result = replay(run.path(), {});
  EXPECT_TRUE(result.is_same());
  if (result.difference) {
    ADD_FAILURE() << "cycle " << result.difference->cycle << " " << result.difference->field << " "
                  << result.difference->recorded << " " << result.difference->repeated;
  }
  expect_to_need_its_takings(run);
}

INSTANTIATE_TEST_SUITE_P(Seeds, ReplayOfTables,
                         ::testing::Range(0, stanok::testing::is_sanitized ? 3 : 10));

// Kinematics that change, a master that starts a worker, marks.
TEST(Replay, OfTwoChannelsAndChangingKinematicsIsTheSame) {
  RecordedByChance run("e7106mf4.toml", DriveChoice::ideal, 7);
  run.program("flat.nc", "G0 X10 Y10 Z20\nG1 X20 F2000\nG0 X0 Y0\nM30\n");
  run.program("turned.nc", "G0 X10 B10 C30\nG1 X20 B20 C60 F2000\nG0 X0 B0 C0\nM30\n");
  run.program("master.nc",
              "#kinematics (1, 1)\nchannel_run (1, \"flat.nc\");\nchannel_wait (1);\n"
              "#kinematics (2, 1)\nchannel_run (1, \"turned.nc\");\nchannel_wait (1);\n"
              "#kinematics (1, 1)\nM30\n");
  run.ask(OperatorAction::program_run, 2, "master.nc");
  run.run(15000);
  run.close();
  EXPECT_TRUE(run.moved());
  const ReplayResult result = replay(run.path(), {});
  EXPECT_TRUE(result.is_same());
  EXPECT_EQ(result.cycles, 15000);
}

// Force control over a simulated cut, with an operator: the repetition has the sensors, not the
// cut.
TEST(Replay, OfForceControlIsTheSameFromItsSensors) {
  for (const DriveChoice drives : {DriveChoice::ideal, DriveChoice::simulated}) {
    RecordedByChance run("lathe.toml", drives, 11);
    run.run(300);
    run.ask(OperatorAction::program_run, 1, "adaptive_steps.nc");
    run.run(12000);
    run.ask(OperatorAction::override_feed, 1, "", 0.8);
    run.run(1500);
    run.ask(OperatorAction::override_feed, 1, "", 1.0);
    run.ask(OperatorAction::program_hold, 1);
    run.run(500);
    run.ask(OperatorAction::program_resume, 1);
    run.run(6000);
    run.close();
    EXPECT_TRUE(run.moved());
    const ReplayResult result = replay(run.path(), {});
    EXPECT_TRUE(result.is_same());
    EXPECT_EQ(result.cycles, 20300);
  }
}

// A channel that a session has to itself: the master's start is refused, then let through. The
// repetition decides the same from the recorded input, and without it does not.
TEST(Replay, OfAChannelThatASessionHadToItselfIsTheSame) {
  constexpr int session = 7;
  RecordedByChance run("e7106mf4.toml", DriveChoice::ideal, 15);
  run.program("flat.nc", "G0 X10 Y10 Z20\nG1 X20 F2000\nG0 X0 Y0\nM30\n");
  run.program("master.nc", "channel_run (1, \"flat.nc\");\nchannel_wait (1);\nM30\n");
  const auto give_to = [&](int who) {
    channels::OperatorEvent event;
    event.command = channels::commands::ChannelControl{who};
    event.channel = 1;
    run.ask(event);
    run.run(100);
  };
  give_to(session);
  run.ask(OperatorAction::program_run, 2, "master.nc");
  run.run(2000);
  EXPECT_FALSE(run.moved()) << "the channel is somebody else's";
  run.ask(OperatorAction::program_reset, 2);
  run.run(100);
  give_to(0);
  run.ask(OperatorAction::program_run, 2, "master.nc");
  run.run(4000);
  run.close();
  EXPECT_TRUE(run.moved());
  const ReplayResult result = replay(run.path(), {});
  EXPECT_TRUE(result.is_same());
  EXPECT_EQ(result.cycles, 6300);

  const auto without = changed<input_t>(run.path(), recording::Topic::input, [](input_t& input) {
    if (input.method == static_cast<int>(OperatorAction::channel_control)) input.number = 0;
  });
  EXPECT_TRUE(replay(without, {}).difference) << "the input is what the refusal depends on";
}

// A log with one bit of one setpoint changed: its cycle, channel and axis are named.
TEST(Replay, FindsOneChangedBit) {
  const RecordedContour run(DriveChoice::ideal, 3, 2000);
  constexpr std::int64_t changed_cycle = 1234;
  const auto copy =
      changed<setpoint_t>(run.path(), recording::Topic::setpoint, [](setpoint_t& one) {
        if (one.cycle == changed_cycle) one.position[1] = std::nextafter(one.position[1], 1e9);
      });
  EXPECT_TRUE(replay(run.path(), {}).is_same());
  const ReplayResult result = replay(copy, {});
  ASSERT_TRUE(result.difference);
  EXPECT_EQ(result.difference->cycle, changed_cycle);
  EXPECT_EQ(result.difference->channel, 1);
  EXPECT_EQ(result.difference->field, "position of Y");
  EXPECT_EQ(result.difference->units_in_last_place, 1U);
}

// Inputs that no machine of this description can have had: told, and nothing worse.
TEST(Replay, OfALogWithForeignInputsIsRefused) {
  const RecordedContour run(DriveChoice::simulated, 6, 500);
  for (const int method : {-1, 200, 256, 1 << 30}) {
    const auto copy = changed<input_t>(run.path(), recording::Topic::input,
                                       [&](input_t& input) { input.method = method; });
    EXPECT_THROW(static_cast<void>(replay(copy, {})), std::runtime_error) << method;
  }
  for (const int axis : {-1, 8, 1 << 30}) {
    const auto copy = changed<feedback_t>(run.path(), recording::Topic::feedback,
                                          [&](feedback_t& feedback) { feedback.axis = axis; });
    EXPECT_THROW(static_cast<void>(replay(copy, {})), std::runtime_error) << axis;
  }
  const auto copy = changed<setpoint_t>(run.path(), recording::Topic::setpoint,
                                        [](setpoint_t& one) { one.axis_count = 1 << 30; });
  static_cast<void>(replay(copy, {}));
}

TEST(Replay, OfWhatIsNoRunIsRefused) {
  const config::TemporaryFiles files;
  const auto path = files.write("empty.lcm", "");
  EXPECT_THROW(static_cast<void>(replay(path, {})), std::runtime_error);
  EXPECT_THROW(static_cast<void>(replay(files.folder() / "none.lcm", {})), std::runtime_error);
}

}  // namespace
}  // namespace stanok::runtime
