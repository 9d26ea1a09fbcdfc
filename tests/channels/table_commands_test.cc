// Tools and work offsets changed by an operator: between programs, in range, and what exists.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/machine/machine_bench.h"

namespace stanok::channels {
namespace {

using testing::MachineBench;

class TableCommands : public ::testing::Test {
 protected:
  explicit TableCommands(MachineConfig config = testing::two_channel_machine())
      : bench(std::move(config)) {}

  std::string set_tool(int number, const char* key, double value, int edge = 0) {
    return asked(
        commands::ToolSet{.key = ShortText(key), .value = value, .tool = number, .edge = edge});
  }
  std::string set_offset(const char* place, double value) {
    return asked(commands::OffsetSet{.place = ShortText(place), .value = value});
  }
  std::string asked(const OperatorCommand& command) {
    OperatorEvent event;
    event.command = command;
    bench.ask(event);
    bench.cycle();
    const OperatorReply& reply = bench.replies().back();
    return reply.ok ? "ok" : std::string(reply.code.view());
  }
  [[nodiscard]] double offset(const std::string& name, const std::string& axis) {
    return bench.machine().tables().offsets[name][axis];
  }

  MachineBench bench;
};

TEST_F(TableCommands, ChangeWhatTheNextProgramUses) {
  EXPECT_EQ(set_offset("G54 X", 12.5), "ok");
  EXPECT_EQ(set_offset("G54.1 P7 Y", -3.0), "ok");
  EXPECT_EQ(offset("G54", "X"), 12.5);
  EXPECT_EQ(offset("G54.1 P7", "Y"), -3.0);
  EXPECT_EQ(set_tool(4, "length", 77.0), "ok");
  bench.program("p.nc", "G54 G0 X0 Y0\nT4 M6 G43 H4\nG0 Z0\nM30\n");
  bench.run(1, "p.nc");
  bench.run_to_end();
  EXPECT_EQ(bench.alarm_codes(), std::vector<std::string>{});
  EXPECT_NEAR(bench.channel(1).axes[0].position, 12.5, 1e-9);
  EXPECT_NEAR(bench.channel(1).axes[2].position, 77.0, 1e-9);
}

TEST_F(TableCommands, AreRefusedWhereThereIsNoSuchEntryOrValue) {
  EXPECT_EQ(set_offset("G54 Q", 1.0), "E5021");
  EXPECT_EQ(set_offset("G60 X", 1.0), "E5021");
  EXPECT_EQ(set_offset("G54.1 P0 X", 1.0), "E5021");
  EXPECT_EQ(set_offset("G54.1 P301 X", 1.0), "E5021");
  EXPECT_EQ(set_offset("G54", 1.0), "E5021");
  EXPECT_EQ(set_tool(4, "colour", 1.0), "E5021");
  EXPECT_EQ(set_tool(4000, "length", 1.0), "E5021");
  EXPECT_EQ(set_tool(4, "radius", -1.0), "E5020");
  EXPECT_EQ(set_tool(4, "length", 1.0, 5.0), "E5021");
}

// Of a table that names tools, those that it does not name are free places.
class TableOfNamedTools : public TableCommands {
 protected:
  TableOfNamedTools() : TableCommands(machine()) {}

  static MachineConfig machine() {
    MachineConfig config = testing::two_channel_machine();
    config.unnamed_tools = false;
    ToolEdge tool;
    tool.number = 4;
    tool.length = 40.0;
    config.tables.tools = {tool};
    return config;
  }
};

TEST_F(TableOfNamedTools, HasFreePlacesThatAnOperatorFills) {
  std::vector<std::string> alarms;
  for (const char* text : {"T7 M6\nM30\n", "G43 H7\nM30\n", "G41 D7\nM30\n", "M61 Q7\nM30\n",
                           "T4 M6\nG43 H5\nM30\n"}) {
    bench.program("p.nc", text);
    bench.run(1, "p.nc");
    bench.run_to_end();
    alarms.emplace_back("E5021");
    EXPECT_EQ(bench.alarm_codes(), alarms) << text;
    bench.ask(OperatorAction::program_reset, 1, "");
    bench.run_to_end();
  }
  bench.program("write.nc",
                "if (settable_tool (7, 1, 1, 5)) { terminate (1000, \"made\"); }\nM30\n");
  bench.run(1, "write.nc");
  bench.run_to_end();
  EXPECT_EQ(bench.alarm_codes(), alarms);
  EXPECT_EQ(bench.machine().tables().tools.size(), 1u);
  EXPECT_EQ(set_tool(7, "length", 0.0), "ok");
  EXPECT_EQ(bench.machine().tables().tools.size(), 2u);
  EXPECT_EQ(set_tool(7, "length", 12.0), "ok");
  bench.program("p.nc", "T7 M6\nG43 G0 Z0\nM30\n");
  bench.run(1, "p.nc");
  bench.run_to_end();
  EXPECT_EQ(bench.alarm_codes(), alarms);
  EXPECT_NEAR(bench.channel(1).axes[2].position, 12.0, 1e-9);
  EXPECT_EQ(bench.channel(1).tool_row.length, 12.0);
  EXPECT_EQ(set_tool(7, "radius", 3.0), "ok");
  bench.cycle();
  EXPECT_EQ(bench.channel(1).tool_row.number, 7);
  EXPECT_EQ(bench.channel(1).tool_row.radius, 3.0);
}

TEST_F(TableCommands, ReferencePointsStandInTheTablesOfTheirChannel) {
  bench.program("p.nc", "G53 G0 X12.5\nG28.1\n#5182=-4.25\nM30\n");
  bench.run(1, "p.nc");
  bench.run_to_end();
  const TablesConfig tables = bench.machine().tables();
  ASSERT_EQ(tables.reference_points.size(), 1U);
  EXPECT_EQ(tables.reference_points.at(1).at("G28").at("X"), 12.5);
  EXPECT_EQ(tables.reference_points.at(1).at("G30 P2").at("Y"), -4.25);
}

TEST_F(TableCommands, CommonVariablesStandInTheTablesOfTheirChannel) {
  bench.program("p.nc", "(dialect fanuc)\n#500=12.5\n#999=#500*2\n#501=#0\nM30\n");
  bench.run(1, "p.nc");
  bench.run_to_end();
  const TablesConfig tables = bench.machine().tables();
  const std::map<int, double> wanted{{500, 12.5}, {999, 25.0}, {3901, 1.0}};
  ASSERT_EQ(tables.variables.size(), 1U);
  EXPECT_EQ(tables.variables.at(1), wanted);
}

TEST_F(TableCommands, ReferencePointsOfTheTablesAreGoneTo) {
  channels::MachineConfig config = testing::two_channel_machine();
  config.tables.reference_points[1]["G30 P3"] = {{"X", 31.5}, {"Z", 5.0}};
  MachineBench started(config);
  started.program("p.nc", "G30 P3\nM30\n");
  started.run(1, "p.nc");
  started.run_to_end();
  EXPECT_EQ(started.alarm_codes(), std::vector<std::string>{});
  EXPECT_NEAR(started.channel(1).axes[0].position, 31.5, 1e-9);
  EXPECT_NEAR(started.channel(1).axes[2].position, 5.0, 1e-9);
}

// While a program runs wear and offsets change by a little, for the blocks that are read behind.
TEST_F(TableCommands, InARunChangeWearAndOffsetsOfBlocksToCome) {
  bench.program("p.nc", "T4 M6\nG43 H4\nG0 X10 Z10\nM0\nG1 X11 F600\nG54 G43 H4\nG0 X0 Z0\nM30\n");
  bench.run(1, "p.nc");
  bench.cycle();
  for (int n = 0; n < 5000 && bench.channel(1).hold_cause == HoldCause::none; ++n) bench.cycle();
  EXPECT_EQ(set_tool(4, "wear_length", 0.2), "ok");
  EXPECT_EQ(set_tool(4, "wear_length", -0.3), "ok");
  EXPECT_EQ(set_offset("G54 X", 0.5), "ok");
  bench.ask(OperatorAction::program_start, 1, "");
  bench.run_to_end();
  EXPECT_EQ(bench.alarm_codes(), std::vector<std::string>{});
  EXPECT_NEAR(bench.channel(1).axes[0].position, 0.5, 1e-9);
  EXPECT_NEAR(bench.channel(1).axes[2].position, -0.3, 1e-9);
}

TEST_F(TableCommands, InARunChangeNothingElseAndNothingByMuch) {
  bench.program("p.nc", "G1 X100 F600\nM30\n");
  bench.run(1, "p.nc");
  for (int n = 0; n < 200; ++n) bench.cycle();
  EXPECT_EQ(set_tool(4, "length", 0.1), "E6101");
  EXPECT_EQ(set_tool(4, "radius", 0.1), "E6101");
  EXPECT_EQ(set_tool(4, "wear_length", 0.51), "E6101");
  EXPECT_EQ(set_tool(4, "wear_radius", -0.51), "E6101");
  EXPECT_EQ(set_offset("G54 X", 0.51), "E6101");
  EXPECT_EQ(set_offset("G54 X", 0.4), "ok");
  EXPECT_EQ(set_offset("G54 X", 0.91), "E6101");
  EXPECT_EQ(set_offset("G54 X", 0.9), "ok");
}

}  // namespace
}  // namespace stanok::channels
