// Plain ISO programs: modal state, positions, order of effects.
#include <cmath>
#include <string>

#include "tests/lang/program_support.h"

namespace stanok::lang::testing {
namespace {

class PlainProgram : public ProgramTest {};

TEST_F(PlainProgram, BeginsWithFrameAndToolLengthOfTheDefaultState) {
  tables.offsets[1] = {100.0, 200.0, 300.0};
  files.texts["main.nc"] = "M30\n";
  const auto program = compile("main.nc", files, &channel, warnings);
  ASSERT_TRUE(program);
  Interpreter one(channel, tables, files);
  one.start(*program, {});
  Command command;
  ASSERT_EQ(one.next(command), Step::command);
  EXPECT_EQ(std::get<FrameChange>(command.payload).offset[1], 200.0);
  ASSERT_EQ(one.next(command), Step::command);
  EXPECT_EQ(std::get<ToolLength>(command.payload).mode, LengthMode::off);
  ASSERT_EQ(one.next(command), Step::command);
  EXPECT_EQ(std::get<ProgramEnd>(command.payload).kind, ProgramEndKind::end_and_rewind);
  EXPECT_EQ(one.next(command), Step::ended);
}

TEST_F(PlainProgram, KeepsAbsoluteWordsToTheBit) {
  const auto list = moves("G0 X33.3 Y-0.1 Z.7\nG1 B33.3 F100\nG20 X0.1\nM30\n");
  ASSERT_EQ(list.size(), 3u);
  EXPECT_EQ(list[0].end[0], 33.3);
  EXPECT_EQ(list[0].end[1], -0.1);
  EXPECT_EQ(list[0].end[2], 0.7);
  EXPECT_EQ(list[0].words, 0b111);
  EXPECT_EQ(list[1].end[3], 33.3);
  EXPECT_EQ(list[1].end[0], 33.3);
  EXPECT_EQ(list[1].words, 0b1000);
  EXPECT_EQ(list[2].end[0], 0.1 * 25.4);
}

TEST_F(PlainProgram, ConvertsFeedsToMillimetres) {
  const auto list = moves("G1 X1 F100\nG20 X1\nX2 F10\nB10\nG93 X3 F2\nG94 G21 F50 X1\nM30\n");
  ASSERT_EQ(list.size(), 6u);
  EXPECT_EQ(list[0].feed, 100.0);
  EXPECT_EQ(list[1].feed, 100.0);
  EXPECT_EQ(list[2].feed, 254.0);
  EXPECT_EQ(list[3].feed, 10.0);  // deg/min without linear words
  EXPECT_EQ(list[4].feed, 2.0);
  EXPECT_EQ(list[4].feed_mode, FeedMode::inverse_time);
  EXPECT_EQ(list[5].feed, 50.0);
}

TEST_F(PlainProgram, AddsIncrementalWords) {
  const auto list = moves("G0 X10\nG91 X5\nX-2.5 Y1\nG90 X1\nM30\n");
  ASSERT_EQ(list.size(), 4u);
  EXPECT_EQ(list[1].end[0], 15.0);
  EXPECT_EQ(list[2].end[0], 12.5);
  EXPECT_EQ(list[2].end[1], 1.0);
  EXPECT_EQ(list[3].end[0], 1.0);
}

TEST_F(PlainProgram, TurnsModuloAxesTheShortestWay) {
  const auto list = moves("G0 C350\nC10\nC-170.5\nB350\nB10\nM30\n");
  ASSERT_EQ(list.size(), 5u);
  EXPECT_EQ(list[0].end[4], -10.0);
  EXPECT_EQ(list[1].end[4], 10.0);
  EXPECT_EQ(list[2].end[4], 189.5);
  EXPECT_EQ(list[3].end[3], 350.0);
  EXPECT_EQ(list[4].end[3], 10.0);
}

TEST_F(PlainProgram, CountsBlocksAndLines) {
  run("(title)\n\nG90\nG0 X1\n; remark\nN40 Y2 // remark\nN50\nM30\n");
  ASSERT_GE(commands.size(), 3u);
  EXPECT_EQ(commands[0].origin.line, 4u);
  EXPECT_EQ(commands[0].block, 2u);
  EXPECT_EQ(commands[1].origin.line, 6u);
  EXPECT_EQ(commands[1].block, 3u);
  EXPECT_EQ(commands.back().block, 4u);
  EXPECT_EQ(interpreter->blocks(), 4u);
}

TEST_F(PlainProgram, ReadsAllLineEndsAndFrames) {
  const auto list = moves("\xEF\xBB\xBF% part 7\r\nG0 X1\rX2\nX3\r\n%\nX4 garbage (((");
  ASSERT_EQ(list.size(), 3u);
  EXPECT_EQ(list[2].end[0], 3.0);
  EXPECT_EQ(commands[2].origin.line, 4u);
}

TEST_F(PlainProgram, WarnsWhenTheEndIsMissing) {
  run("G0 X1\n");
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0].code, "W211");
  EXPECT_EQ(all<ProgramEnd>().at(0).kind, ProgramEndKind::end_of_text);
}

TEST_F(PlainProgram, ExecutesABlockInFixedOrder) {
  tables.tools[3] = {3, {0, 0, 50}, 2};
  run("M0 X10 G1 M8 M3 M6 T3 S1200 F300 G4 P0.5\nM30\n");
  std::vector<std::size_t> kinds;
  for (const Command& command : commands) kinds.push_back(command.payload.index());
  const Payload order[] = {SpindleCommand{}, ToolPrepare{},    ToolChange{},     SpindleCommand{},
                           CoolantCommand{}, Dwell{},          Move{},           ProgramStop{},
                           ProgramRequest{}, SpindleCommand{}, CoolantCommand{}, ProgramEnd{}};
  std::vector<std::size_t> expected;
  for (const Payload& payload : order) expected.push_back(payload.index());
  EXPECT_EQ(kinds, expected) << to_text(error);
}

TEST_F(PlainProgram, MovesInMachineCoordinates) {
  tables.offsets[1] = {100.0, 0.0, 0.0};
  tables.reading.zero = {7.0, 0.0, 1000.0};
  const auto list = moves("G0 G53 X500\nG91 X1\nG90 G53 Z0\nM30\n");
  ASSERT_EQ(list.size(), 3u);
  EXPECT_TRUE(list[0].machine_coordinates);
  EXPECT_EQ(list[0].end[0], 500.0);
  EXPECT_EQ(list[1].end[0], 500.0 - 7.0 - 100.0 + 1.0);
  EXPECT_EQ(list[2].end[2], 0.0);
}

// A turret in front of the workpiece: its X axis points the other way, M = -(B + L) + zero.
TEST_F(PlainProgram, MovesInMachineCoordinatesOfAnAxisThatPointsTheOtherWay) {
  tables.reading.zero = {7.0, 0.0, 0.0};
  tables.reading.per_mm[0] = -1.0;
  const auto list = moves("G0 G53 X-128\nG91 X1\nG28.1\nM30\n");
  ASSERT_EQ(list.size(), 2u);
  EXPECT_EQ(list[0].end[0], -128.0);
  EXPECT_EQ(list[1].end[0], 128.0 + 7.0 + 1.0);
  EXPECT_EQ(tables.reference[1][0], -128.0 - 1.0);
}

// An axis that counts diameters: in M it is twice as far, whatever words the program has.
TEST_F(PlainProgram, MovesInMachineCoordinatesOfAnAxisThatCountsDiameters) {
  tables.reading.zero = {6.0, 0.0, 0.0};
  tables.reading.per_mm[0] = 2.0;
  const auto list = moves("G0 G53 X50\nG91 X1\nM30\n");
  ASSERT_EQ(list.size(), 2u);
  EXPECT_EQ(list[0].end[0], 100.0);
  EXPECT_EQ(list[1].end[0], (100.0 - 6.0) / 2.0 + 1.0);
}

// A parked axis has no tool on it.
TEST_F(PlainProgram, LengthsAreOnAxesOfTheSchemeOnly) {
  tables.tools[1].length_mm = {0.0, 0.0, 90.0};
  tables.in_scheme = 0b11;
  run("G43 H1\nG28.1\nM30\n");
  EXPECT_EQ(tables.reference[1][2], 0.0);
  tables.in_scheme = 0b111;
  const auto list = moves("G43 H1\nG91 G0 Z1\nM30\n");
  ASSERT_EQ(list.size(), 1u);
  EXPECT_EQ(list[0].end[2], -90.0 + 1.0);
}

// A fourth axis of the channel would turn the workpiece away from the tip.
TEST_F(PlainProgram, LeadsTheTipOnlyWhereTheSchemeKnowsEveryRotaryAxis) {
  for (const char* code : {"G43.4 H0", "G43.5 H0"}) {
    SCOPED_TRACE(code);
    tables.led = 0;
    run(std::string(code) + "\nG1 B90 F1000\nM30\n");
    EXPECT_EQ(error.code, "E4353");
    EXPECT_EQ(error.place.line, 1);
    EXPECT_NE(error.message.find("B into account"), std::string::npos) << error.message;
    tables.in_scheme = 0b111;  // the rotary axes are parked
    run(std::string(code) + "\nM30\n");
    EXPECT_EQ(error.code, "");
    tables.in_scheme = tables.led = static_cast<AxisSet>(~0U);
    run(std::string(code) + "\nM30\n");
    EXPECT_EQ(error.code, "");
  }
}

TEST_F(PlainProgram, KeepsThePointWhileTheWorkOffsetChanges) {
  tables.offsets[1] = {100.0, 0.0, 0.0};
  tables.offsets[2] = {30.0, 5.0, 0.0};
  tables.offsets[12] = {1.0, 1.0, 1.0};
  const auto list = moves("G0 X10 Y1\nG55\nG91 X0 Y0\nG90 G54.1 P3 X2\nM30\n");
  ASSERT_EQ(list.size(), 3u);
  EXPECT_EQ(list[1].end[0], 10.0 + 100.0 - 30.0);
  EXPECT_EQ(list[1].end[1], 1.0 - 5.0);
  const auto frames = all<FrameChange>();
  ASSERT_EQ(frames.size(), 2u);
  EXPECT_EQ(frames[0].work_offset, 2);
  EXPECT_EQ(frames[0].offset[0], 30.0);
  EXPECT_EQ(frames[1].work_offset, 12);
}

TEST_F(PlainProgram, ShiftsTheSystemByG52AndG92) {
  const auto list =
      moves("G0 X10 Y20\nG52 X4\nG91 X0\nG90 G92 X100 Y200\nX101\nG92.2\nG91 X0 Y0\nM30\n");
  ASSERT_EQ(list.size(), 4u);
  EXPECT_EQ(list[1].end[0], 6.0);
  EXPECT_EQ(list[2].end[0], 101.0);
  EXPECT_EQ(list[2].end[1], 200.0);
  EXPECT_EQ(list[3].end[0], 7.0);
  EXPECT_EQ(list[3].end[1], 20.0);
}

TEST_F(PlainProgram, MovesItsOwnPointByTheToolLength) {
  tables.tools[5] = {5, {0.0, 0.0, 80.0}, 3.0};
  const auto list = moves("T5 M6\nG0 Z100\nG43 H5\nG91 Z0\nG90 G49\nG91 Z0\nM30\n");
  ASSERT_EQ(list.size(), 3u);
  EXPECT_EQ(list[1].end[2], 20.0);
  EXPECT_EQ(list[2].end[2], 100.0);
  const auto lengths = all<ToolLength>();
  ASSERT_EQ(lengths.size(), 2u);
  EXPECT_EQ(lengths[0].mode, LengthMode::length);
  EXPECT_EQ(lengths[0].tool, 5);
  EXPECT_EQ(lengths[0].offset_mm[2], 80.0);
  EXPECT_EQ(lengths[1].mode, LengthMode::off);
}

TEST_F(PlainProgram, WaitsForThePositionWhenTipControlBeginsAndEnds) {
  tables.tools[1] = {1, {0.0, 0.0, 60.0}, 0.0};
  answering = [](const ProgramRequest&) {
    Answer answer;
    answer.position_valid = true;
    answer.position_B = {1.0, 2.0, 3.0, 30.0, 40.0};
    return answer;
  };
  const auto list = moves("G43.4 H1\nG91 G0 X1\nG49\nX1\nM30\n");
  ASSERT_EQ(list.size(), 2u);
  EXPECT_EQ(list[0].end[0], 2.0);
  EXPECT_EQ(list[0].end[4], 40.0);
  EXPECT_EQ(list[1].end[0], 2.0);
  const auto requests = all<ProgramRequest>();
  ASSERT_EQ(requests.size(), 2u);
  EXPECT_EQ(requests[0].kind, RequestKind::sync);
}

// The block of G43.4 is divided at the standstill: what follows in it starts from the position that
// the tip has been found at, for programmed axes, for the others and for the next block.
TEST_F(PlainProgram, GoesOnInTheBlockOfTipControlFromThePositionOfTheTip) {
  tables.tools[1] = {1, {0.0, 0.0, 60.0}, 0.0};
  answering = [](const ProgramRequest&) {
    Answer answer;
    answer.position_valid = true;
    answer.position_B = {1.0, 2.0, 3.0, 30.0, 40.0};
    return answer;
  };
  const auto list = moves("G0 X9 Y9\nG43.4 H1 G90 G0 X15 Z50\nG91 X1\nG49 Y-3\nG90 Z0\nM30\n");
  ASSERT_EQ(list.size(), 5u);
  EXPECT_EQ(list[1].end, (AxisValues{15.0, 2.0, 50.0, 30.0, 40.0}));
  EXPECT_EQ(list[2].end, (AxisValues{16.0, 2.0, 50.0, 30.0, 40.0}));
  EXPECT_EQ(list[3].end, (AxisValues{1.0, -1.0, 3.0, 30.0, 40.0}));
  EXPECT_EQ(list[4].end, (AxisValues{1.0, -1.0, 0.0, 30.0, 40.0}));
}

TEST_F(PlainProgram, SelectsPathModes) {
  const auto list =
      moves("G0 X1\nG61 X2\nG61.1 X3\nG64 P0.02 Q0.01 X4\nG20 G64 P0.1 X1\nG9 X2\nM30");
  ASSERT_EQ(list.size(), 6u);
  EXPECT_EQ(list[0].path.mode, PathMode::continuous);
  EXPECT_LT(list[0].path.tolerance_mm, 0.0);
  EXPECT_EQ(list[1].path.mode, PathMode::exact_path);
  EXPECT_EQ(list[2].path.mode, PathMode::exact_stop);
  EXPECT_EQ(list[3].path.tolerance_mm, 0.02);
  EXPECT_EQ(list[3].path.straightening_mm, 0.01);
  EXPECT_EQ(list[4].path.tolerance_mm, 0.1 * 25.4);
  EXPECT_FALSE(list[4].stop_at_end);
  EXPECT_TRUE(list[5].stop_at_end);
}

TEST_F(PlainProgram, DwellsInSecondsOrRevolutions) {
  run("G4 P0.5\nG4 X2\nG4 F3\nS120\nG4 S4\nM30\n");
  const auto dwells = all<Dwell>();
  ASSERT_EQ(dwells.size(), 4u) << to_text(error);
  EXPECT_EQ(dwells[0].seconds, 0.5);
  EXPECT_EQ(dwells[1].seconds, 2.0);
  EXPECT_EQ(dwells[2].seconds, 3.0);
  EXPECT_EQ(dwells[3].seconds, 2.0);
}

TEST_F(PlainProgram, WritesOffsetsByG10) {
  tables.offsets[2] = {50.0};
  std::vector<ProgramRequest> writes;
  answering = [&](const ProgramRequest& request) {
    writes.push_back(request);
    tables.offsets[request.number][static_cast<std::size_t>(request.index)] = request.value;
    return Answer{};
  };
  const auto list = moves("G55 G0 X1\nG10 L2 P2 X60 Y7\nG91 X0 Y0\nG90 G10 L20 P2 X5\nX6\nM30");
  ASSERT_EQ(writes.size(), 3u);
  EXPECT_EQ(writes[0].kind, RequestKind::offset_table_write);
  EXPECT_EQ(writes[0].text, "X");
  EXPECT_EQ(writes[0].value, 60.0);
  EXPECT_EQ(list[1].end[0], 1.0 + 50.0 - 60.0);
  EXPECT_EQ(list[1].end[1], -7.0);
  // X stands at -9 in the offset 60, i.e. at 51; it becomes 5.
  EXPECT_EQ(writes[2].value, 46.0);
  EXPECT_EQ(all<FrameChange>().back().offset[0], 46.0);
}

TEST_F(PlainProgram, CallsNumberedProgramsBehindItsEnd) {
  const auto list = moves("G0 X1\nM98 P200 L2\nX2\nM30\nO200\nG91 G1 Z-1 F50\nG90\nM99\n");
  ASSERT_EQ(list.size(), 4u);
  EXPECT_EQ(list[1].end[2], -1.0);
  EXPECT_EQ(list[2].end[2], -2.0);
  EXPECT_EQ(list[3].end[0], 2.0);
}

TEST_F(PlainProgram, EndsBehindARequestOfTheSameBlock) {
  tables.tools[1] = {1, {0.0, 0.0, 60.0}, 0.0};
  const auto list = moves("G43.4 H1\nG0 X1\nG49 M30\nX2\n");
  EXPECT_EQ(list.size(), 1u);
  EXPECT_EQ(all<ProgramEnd>().size(), 1u);
}

TEST_F(PlainProgram, TellsTheResetOfTheEndToTheChannel) {
  run("S100 M3 M8 M49\nM2\n");
  EXPECT_EQ(all<SpindleCommand>().back().action, SpindleAction::stop);
  EXPECT_FALSE(all<CoolantCommand>().back().flood);
  EXPECT_TRUE(all<OverrideControl>().back().feed_enabled);
  EXPECT_EQ(all<ProgramEnd>().at(0).kind, ProgramEndKind::end);
}

}  // namespace
}  // namespace stanok::lang::testing
