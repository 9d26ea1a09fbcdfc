// Tables, signals and system variables of the machine, as programs see them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "channels/machine/machine.h"
#include "tests/support/machine/machine_bench.h"

namespace stanok::channels {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using testing::MachineBench;
using testing::two_channel_machine;

std::vector<std::string> alarms_of(const std::string& text, MachineBench& bench) {
  bench.program("p.nc", text + "M30\n");
  bench.run(1, "p.nc");
  bench.run_to_end();
  return bench.alarm_codes();
}

std::vector<std::string> alarms_of(const std::string& text) {
  MachineBench bench;
  return alarms_of(text, bench);
}

TEST(Tables, WrittenOffsetHoldsFromTheNextBlock) {
  MachineBench bench;
  EXPECT_THAT(alarms_of("G54 G0 X10\nsettable_zs (1, 1, X, 5);\nG0 X10\n", bench), IsEmpty());
  EXPECT_EQ(bench.channel(1).axes[0].position, 15.0);
  EXPECT_EQ(bench.machine().tables().offsets.at("G54").at("X"), 5.0);
}

TEST(Tables, InputByG10HoldsFromTheNextBlock) {
  MachineBench bench;
  EXPECT_THAT(alarms_of("G10 L2 P1 X10\nG0 X5\nG10 L20 P1 Y7\nG0 Y0\n"
                        "G10 L1 P3 Z33\nT3 M6 G43\nG0 Z-50\n"
                        "if (gettable_tool (3, 1, \"length\") != 33) { terminate (1001, \"\"); }\n",
                        bench),
              IsEmpty());
  EXPECT_EQ(bench.channel(1).axes[0].position, 15.0);
  EXPECT_EQ(bench.channel(1).axes[1].position, -7.0);
  EXPECT_EQ(bench.channel(1).axes[2].position, -17.0);
}

TEST(Tables, RotationOfAWorkOffsetTurnsTheWay) {
  MachineBench bench;
  EXPECT_THAT(alarms_of("G10 L2 P1 X10 R90\nG0 X20 Y5\n", bench), IsEmpty());
  EXPECT_NEAR(bench.channel(1).axes[0].position, 5.0, 1e-9);
  EXPECT_NEAR(bench.channel(1).axes[1].position, 20.0, 1e-9);
  EXPECT_EQ(bench.machine().tables().offsets.at("G54").at("R"), 90.0);
}

TEST(Tables, OffsetsAreInProgramUnitsAndReadBackSo) {
  MachineBench bench;
  EXPECT_THAT(alarms_of("G20\nsettable_zs (1, 2, \"Y\", 2);\nsettable_zs (1, 2, B, 30);\n"
                        "if (gettable_zs (1, 2, Y) != 2) { terminate (1001, \"inch\"); }\n"
                        "G21\nif (gettable_zs (1, 2, Y) != 50.8) { terminate (1002, \"mm\"); }\n",
                        bench),
              IsEmpty());
  EXPECT_EQ(bench.machine().tables().offsets.at("G55").at("Y"), 50.8);
  EXPECT_EQ(bench.machine().tables().offsets.at("G55").at("B"), 30.0);
}

TEST(Tables, EntriesThatDoNotExistAreFalseOrAnError) {
  EXPECT_THAT(alarms_of("if (settable_zs (2, 1, X, 5) || settable_zs (1, 400, X, 5) ||\n"
                        "settable_zs (1, 1, \"Q\", 5) || settable_tool (700, 1, \"length\", 5) ||\n"
                        "settable_tool (3, 1, \"weight\", 5) || settable_tool (3, 1, 12, 5) ||\n"
                        "settable_tool (3, 1, \"radius\", -1))\n{ terminate (1001, \"\"); }\n"),
              IsEmpty());
  EXPECT_THAT(alarms_of("settable_zs (1, 400, X, 5);\n"), ElementsAre("E5020"));
  EXPECT_THAT(alarms_of("settable_tool (3, 2, \"length\", 5);\n"), ElementsAre("E5020"));
  EXPECT_THAT(alarms_of("num depth = gettable_zs (1, 400, X);\n"), ElementsAre("E5021"));
}

TEST(Tables, ToolValuesGoByNameOrNumber) {
  MachineBench bench;
  EXPECT_THAT(
      alarms_of("settable_tool (3, 1, \"length\", 80);\nsettable_tool (3, 1, 4, 6.5);\n"
                "if (gettable_tool (3, 1, 1) != 80) { terminate (1001, \"\"); }\n"
                "if (gettable_tool (3, 1, \"radius\") != 6.5) { terminate (1002, \"\"); }\n",
                bench),
      IsEmpty());
  const TablesConfig tables = bench.machine().tables();
  ASSERT_EQ(tables.tools.size(), 1U);
  EXPECT_EQ(tables.tools[0].number, 3);
  EXPECT_EQ(tables.tools[0].length, 80.0);
}

TEST(Tables, RowOfTheToolAtWorkIsShownFromTheCycleThatWritesIt) {
  MachineConfig config = two_channel_machine();
  ToolEdge tool;
  tool.number = 3;
  tool.kind = "bull";
  tool.radius = 4.0;
  tool.corner_radius = 0.5;
  config.tables.tools = {tool};
  MachineBench bench(std::move(config));
  bench.program("p.nc",
                "G1 X10 F6000\nT3 M6\nX20\nsettable_tool (3, 1, \"radius\", 2.5);\nX30\n"
                "G10 L1 P3 Z33 R2\nX40\nT0 M6\nX50\nM30\n");
  bench.run(1, "p.nc");
  bench.run_to_end([](const CycleOutput& output) {
    const ChannelOutput& channel = output.channels[0];
    if (!channel.moving) return;
    const double x = channel.axes[0].position;
    const ToolRow& row = channel.tool_row;
    const bool is_there = x > 10.0 && x <= 40.0;
    EXPECT_EQ(row.number, is_there ? 3 : 0) << x;
    if (!is_there) return;
    EXPECT_EQ(row.kind.view(), "bull");
    EXPECT_EQ(row.corner_radius, 0.5);
    EXPECT_EQ(row.radius, x <= 20.0 ? 4.0 : x <= 30.0 ? 2.5 : 2.0) << x;
    EXPECT_EQ(row.length, x <= 30.0 ? 0.0 : 33.0) << x;
  });
  EXPECT_THAT(bench.alarm_codes(), IsEmpty());
}

TEST(Tables, WriteProtectionOfTheMachineFileHolds) {
  MachineConfig config = two_channel_machine();
  config.tables_write_protected = true;
  MachineBench bench(std::move(config));
  EXPECT_THAT(alarms_of("settable_zs (1, 1, X, 5);\n", bench), ElementsAre("E5020"));
}

// A mill with lengths up to 500 mm, whose linear axes go from -500 to 500.
class ImplausibleEntry : public ::testing::TestWithParam<const char*> {};

TEST_P(ImplausibleEntry, EndsTheProgramAndIsNotWritten) {
  MachineBench bench;
  const std::string fault = GetParam();
  EXPECT_THAT(alarms_of("G17 G90 G94\n" + fault + "\n", bench), ElementsAre("E5022"));
  const TablesConfig tables = bench.machine().tables();
  EXPECT_TRUE(tables.tools.empty());
  EXPECT_TRUE(tables.offsets.empty());
}

INSTANTIATE_TEST_SUITE_P(Programs, ImplausibleEntry,
                         ::testing::Values("G10 L1 P3 Z-5", "G10 L1 P3 Z99999", "G10 L1 P3 R5000",
                                           "G10 L1 P3 X-501", "G10 L10 P3 Z5", "G10 L11 P3 Z5",
                                           "G10 L2 P1 X99999", "G10 L2 P1 R361",
                                           "G10 L20 P1 Y-1001", "G20 G10 L2 P1 X40",
                                           "settable_tool (3, 1, \"wear_length\", 80);",
                                           "settable_tool (3, 1, \"wear_radius\", -2.5);",
                                           "settable_tool (3, 1, \"overhang\", -1);",
                                           "if (settable_tool (3, 1, \"length\", 501)) { M0\n}",
                                           "settable_zs (1, 2, Z, -1001);",
                                           "settable_zs (1, 2, \"R\", 400);"));

TEST(Tables, RefuseWhatVariablesOfADialectWrite) {
  for (const char* write : {"#5221=99999", "#2001=-5", "#2001=99999"}) {
    MachineBench bench;
    bench.program("p.nc", std::string("(dialect fanuc)\n") + write + "\nM30\n");
    bench.run(1, "p.nc");
    bench.run_to_end();
    EXPECT_THAT(bench.alarm_codes(), ElementsAre("E5022")) << write;
  }
}

TEST(Tables, TellWhatIsNotPlausibleAndByWhichKey) {
  MachineBench bench;
  bench.program("p.nc", "G10 L2 P10 X5000\nM30\n");
  bench.run(1, "p.nc");
  bench.run_to_end();
  ASSERT_EQ(bench.machine().alarms().size(), 1U);
  EXPECT_EQ(bench.machine().alarms().front().diagnostic.message,
            "G54.1 P1 X: 5000 mm is more than 1000 mm (offset_max)");
}

TEST(Tables, TakeWhatTheMachineFilePermits) {
  MachineConfig config = two_channel_machine();
  config.entry_limits = {.tool_length_min_mm = -900.0,
                         .tool_length_max_mm = 900.0,
                         .tool_radius_max_mm = 6000.0,
                         .wear_max_mm = 90.0,
                         .offset_max_mm = 99999.0};
  MachineBench bench(std::move(config));
  EXPECT_THAT(alarms_of("G10 L1 P3 Z-5 R5000\nG10 L2 P1 X99999\n"
                        "settable_tool (3, 1, \"wear_length\", 80);\n",
                        bench),
              IsEmpty());
}

TEST(Signals, OutputsSwitchInTheirPlace) {
  MachineBench bench;
  bench.program("p.nc", "G1 X10 F6000\nM64 P3\nM62 P1\nX20\nM68 E2 Q1.5\nM65 P3\nM30\n");
  bench.run(1, "p.nc");
  bench.run_to_end([&](const CycleOutput& output) {
    const double x = output.channels[0].axes[0].position;
    if (x < 10.0) {
      EXPECT_EQ(output.signals.digital, 0U);
    }
    if (x > 11.0 && x < 19.0) {
      EXPECT_EQ(output.signals.digital, 0b1010U);
    }
  });
  EXPECT_THAT(bench.alarm_codes(), IsEmpty());
  EXPECT_EQ(bench.output().signals.digital, 0b0010U);
  EXPECT_EQ(bench.output().signals.analog[2], 1.5);
}

TEST(Signals, OutputWithMotionDoesNotStopThePath) {
  MachineBench bench;
  bench.program("p.nc", "G64 P0.01\nG1 X50 F6000\nM62 P1 X100\nM67 E0 Q2\nX150\nM30\n");
  bench.run(1, "p.nc");
  bench.run_to_end([&](const CycleOutput& output) {
    const AxisSetpoint& axis = output.channels[0].axes[0];
    if (axis.position > 20.0 && axis.position < 130.0) {
      EXPECT_NEAR(axis.velocity, 100.0, 1e-6);
    }
    EXPECT_EQ(output.signals.is_on(1), axis.position > 50.0) << axis.position;
    if (axis.position < 100.0) {
      EXPECT_EQ(output.signals.analog[0], 0.0);
    }
  });
  EXPECT_EQ(bench.output().signals.analog[0], 2.0);
}

TEST(Signals, WaitForAnInputSeesEdgesLevelsAndTime) {
  MachineBench bench(two_channel_machine(),
                     {.on_at_start = true, .stops_go_on = true, .outputs_to_inputs = true});
  bench.program("other.nc", "G4 P0.5\nM64 P7\nG4 P0.5\nM65 P7\nM30\n");
  bench.program("p.nc",
                "M66 P7 L0\nif (#5399 != 0) { terminate (1001, \"now\"); }\n"
                "M66 P7 L1 Q5\nif (#5399 != 1 || $in[7] == false) { terminate (1002, \"rise\"); }\n"
                "M66 P7 L3 Q5\nif (#5399 != 1) { terminate (1003, \"on\"); }\n"
                "M66 P7 L2 Q5\nif (#5399 != 0) { terminate (1004, \"fall\"); }\n"
                "M66 P7 L1 Q0.2\nif (#5399 != -1) { terminate (1005, \"time\"); }\n"
                "M68 E3 Q2.5\nG4 P0.01\nM66 E3\n"
                "if (#5399 != 2.5 || $ain[3] != 2.5) { terminate (1006, \"analog\"); }\nM30\n");
  bench.run(1, "p.nc");
  bench.run(2, "other.nc");
  bench.run_to_end();
  EXPECT_THAT(bench.alarm_codes(), IsEmpty());
}

TEST(Signals, InputsThatChangeAreWrittenDown) {
  MachineBench bench;
  bench.cycle();
  CycleOutput output;
  Signals signals;
  signals.set(5, true);
  bench.machine().cycle({.events = {}, .feedback = {}, .signals = &signals}, output);
  bench.machine().cycle({.events = {}, .feedback = {}, .signals = &signals}, output);
  InputRecord record;
  ASSERT_TRUE(bench.machine().input_records().pop(record));
  EXPECT_EQ(std::get<DigitalInput>(record.content).number, 5);
  EXPECT_TRUE(std::get<DigitalInput>(record.content).is_on);
  EXPECT_FALSE(bench.machine().input_records().pop(record));
}

TEST(Switches, OptionalStopStopsOnlyWhenItIsOn) {
  MachineBench bench;
  bench.program("p.nc", "G1 X1 F6000\nM1\nX2\nM30\n");
  bench.run(1, "p.nc");
  bench.run_to_end();
  EXPECT_EQ(bench.channel(1).axes[0].position, 2.0);
  bench.ask(OperatorAction::optional_stop, 1, "", 0.0, 1);
  bench.run(1, "p.nc");
  bench.run_to_end();
  EXPECT_EQ(bench.channel(1).state, ChannelState::held);
  EXPECT_EQ(bench.channel(1).axes[0].position, 1.0);
}

TEST(Switches, BlockSkipIsTakenOverAtSyncPoints) {
  MachineBench bench;
  bench.program("p.nc",
                "/2 X1 G0\nG4 P0.5\nsync ();\n/2 X3 G0\n"
                "if ($skip[2] == false || $skip[1]) { terminate (1001, \"\"); }\nM30\n");
  bench.run(1, "p.nc");
  for (int n = 0; n < 100; ++n) bench.cycle();
  bench.ask(OperatorAction::block_skip, 1, "", 0.0, 2);
  bench.run_to_end();
  EXPECT_THAT(bench.alarm_codes(), IsEmpty());
  EXPECT_EQ(bench.channel(1).axes[0].position, 1.0);
}

TEST(Switches, FeedHoldWaitsWhereTheProgramDoesNotLetItAct) {
  MachineBench bench;
  bench.program("p.nc", "G4 P0.1\nM53 P0\nG1 X50 F6000\nM53 P1\nG1 X100\nM30\n");
  bench.run(1, "p.nc");
  for (int n = 0; n < 300; ++n) bench.cycle();
  bench.ask(OperatorAction::program_hold, 1);
  bench.run_to_end();
  EXPECT_EQ(bench.channel(1).state, ChannelState::held);
  EXPECT_EQ(bench.channel(1).axes[0].position, 50.0);
}

TEST(SystemVariables, OfTheMachineTellWhatIsNow) {
  MachineConfig config = two_channel_machine();
  config.tables.offsets["G54"] = {{"X", 100.0}};
  MachineBench bench(std::move(config));
  EXPECT_THAT(
      alarms_of("G0 X10 Y20\nS1000 M3\n"
                "if (near ($pos[X], 10) == false) { terminate (1001, str ($pos[X])); }\n"
                "if (near ($pos_mcs[X], 110) == false) { terminate (1002, str ($pos_mcs[X])); }\n"
                "if ($feed_act != 0) { terminate (1003, str ($feed_act)); }\n"
                "if ($speed_act[1] != 1000) { terminate (1004, str ($speed_act[1])); }\n"
                "if ($ovr_feed != 100) { terminate (1005, str ($ovr_feed)); }\n"
                "if ($homed[Y] == false) { terminate (1006, \"\"); }\n"
                "if ($axis_channel[Z] != 1) { terminate (1007, str ($axis_channel[Z])); }\n"
                "if ($kinematics[1] != 1) { terminate (1008, str ($kinematics[1])); }\n"
                "if ($channel != 1 || $prog_pos[Y] != 20) { terminate (1009, \"\"); }\n"
                "num begin = clock ();\nG4 P0.5\n"
                "if (clock () - begin < 0.5) { terminate (1010, \"\"); }\n",
                bench),
      IsEmpty());
}

TEST(SystemVariables, TellAnAxisHomedAsItsDriveDoes) {
  MachineBench bench;
  std::vector<AxisFeedback> drives(5, {.valid = true, .enabled = true, .referenced = true});
  drives[3].referenced = false;  // not of the scheme, so that a program may start
  bench.feedback(drives);
  EXPECT_THAT(alarms_of("if ($homed[Y] == false) { terminate (1001, \"Y\"); }\n"
                        "if ($homed[B]) { terminate (1002, \"B\"); }\n",
                        bench),
              IsEmpty());
}

TEST(ToolOverhang, ChangesTheCounterAndMovesNothing) {
  MachineConfig config = two_channel_machine();
  config.tables.offsets["G54"] = {{"X", 100.0}};
  ToolEdge tool;
  tool.number = 1;
  tool.overhang = 20.0;
  config.tables.tools = {tool};
  MachineBench bench(std::move(config));
  EXPECT_THAT(alarms_of("T1 M6\nG0 X50\n#tool_overhang (35)\n"
                        "if (near ($pos[X], 65) == false) { terminate (1001, str ($pos[X])); }\n"
                        "if ($pos_mcs[X] != 150) { terminate (1002, str ($pos_mcs[X])); }\n"
                        "G0 X50\n"
                        "if ($pos_mcs[X] != 135) { terminate (1003, str ($pos_mcs[X])); }\n"
                        "#tool_overhang ()\n"
                        "if (near ($pos[X], 35) == false) { terminate (1004, str ($pos[X])); }\n",
                        bench),
              IsEmpty());
}

TEST(SystemVariables, OfThingsThatAreNotThereAreErrors) {
  EXPECT_THAT(alarms_of("num speed_now = $speed_act[9];\n"), ElementsAre("E4053"));
  EXPECT_THAT(alarms_of("num scheme_now = $kinematics[9];\n"), ElementsAre("E6001"));
  EXPECT_THAT(alarms_of("if ($in[64]) { M0\n }\n"), ElementsAre("E6028"));
  EXPECT_THAT(alarms_of("if ($skip[10]) { M0\n }\n"), ElementsAre("E6027"));
}

TEST(Messages, AreShownBetweenTheBlocksWhereTheyStand) {
  MachineBench bench;
  bench.program("p.nc",
                "G1 X10 F6000\nmsg (\"one\");\nX20\n(MSG,two) X30\nwarn (\"three\");\nM30\n");
  bench.run(1, "p.nc");
  bench.run_to_end([&](const CycleOutput& output) {
    const double x = output.channels[0].axes[0].position;
    const std::size_t shown = x <= 10.0 ? 0 : x <= 20.0 ? 1 : 2;
    if (!output.channels[0].moving) return;
    EXPECT_EQ(bench.event_codes().size(), shown) << x;
  });
  EXPECT_THAT(bench.event_codes(), ElementsAre("", "", "W0001"));
}

TEST(Workpiece, IsToldWhenMotionReachesItsAnnouncement) {
  MachineBench bench;
  bench.program("p.nc",
                "G1 X10 F6000\n#workpiece (1, 0.5, 1, 80, 20, 60, 0, 0, 30)\nX20\n"
                "#workpiece_pos (1, 2, 3, 10, 20, 30)\nX30\nM30\n");
  bench.run(1, "p.nc");
  bench.run_to_end([](const CycleOutput& output) {
    const ChannelOutput& channel = output.channels[0];
    const double x = channel.axes[0].position;
    EXPECT_EQ(channel.workpiece.announcements, x <= 10.0 ? 0U : x <= 20.0 ? 1U : 2U) << x;
  });
  const Workpiece& workpiece = bench.channel(1).workpiece;
  EXPECT_TRUE(workpiece.has_shape && workpiece.has_position);
  EXPECT_EQ(workpiece.shape.type, 1);
  EXPECT_THAT(workpiece.shape.size_mm, ElementsAre(80.0, 20.0, 60.0));
  EXPECT_THAT(workpiece.position.angles_deg, ElementsAre(10.0, 20.0, 30.0));
}

}  // namespace
}  // namespace stanok::channels
