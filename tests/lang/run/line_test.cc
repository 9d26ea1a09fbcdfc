// Single lines of an operator (MDI): what they may be, what they may call, what lasts between them.
#include <gmock/gmock.h>

#include <fstream>
#include <sstream>

#include "tests/lang/program_support.h"
#include "tests/support/project_folders.h"

namespace stanok::lang {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::Not;

class LineTest : public testing::ProgramTest {
 protected:
  // Runs `line`; its commands without the frame and length at the beginning.
  std::vector<Command> enter(const std::string& line) {
    if (interpreter == nullptr) interpreter = std::make_unique<Interpreter>(channel, tables, files);
    commands.clear();
    error = {};
    warnings.clear();
    auto compiled = compile_line(line, loaded.get(), files, &channel, warnings);
    if (!compiled) {
      ADD_FAILURE() << to_text(compiled.error().front());
      return {};
    }
    interpreter->start_line(*compiled, position_B);
    drain();
    std::erase_if(commands, [](const Command& command) {
      return std::holds_alternative<FrameChange>(command.payload) ||
             std::holds_alternative<ToolLength>(command.payload);
    });
    return commands;
  }
  std::vector<std::string> codes_of(const std::string& line) {
    auto compiled = compile_line(line, loaded.get(), files, &channel, warnings);
    std::vector<std::string> codes;
    if (compiled) return codes;
    for (const Diagnostic& diagnostic : compiled.error()) codes.push_back(diagnostic.code);
    return codes;
  }
  void load(const std::string& text) {
    files.texts["main.nc"] = text;
    auto program = compile("main.nc", files, &channel, warnings);
    ASSERT_TRUE(program) << to_text(program.error().front());
    loaded = *program;
  }
  double end_x() { return all<Move>().back().end[0]; }

  std::shared_ptr<const Program> loaded;
  AxisValues position_B{};
};

TEST_F(LineTest, ABlockIsExecutedWithoutAnEndOfProgram) {
  enter("G1 X10 F500");
  EXPECT_EQ(end_x(), 10.0);
  EXPECT_EQ(all<ProgramEnd>().at(0).kind, ProgramEndKind::end_of_line);
  EXPECT_THAT(warnings, IsEmpty()) << "a line needs no M30";
}

// G47 of Haas is a call of a function in a file that the line includes by itself: L is 06 00 40 on
// a grid of 4 by 6, the next letter begins 6 further on.
TEST_F(LineTest, EngravesWithG47) {
  channel.rules.dialect = Dialect::haas;
  std::ifstream file(stanok::testing::source_folder() + "/programs/cycles/mill/engrave.nc");
  std::stringstream text;
  text << file.rdbuf();
  files.texts["mill/engrave.nc"] = text.str();
  enter("G47 P0 X0 Y0 J6. R5. Z-.2 F100. (L)");
  EXPECT_EQ(error.code, "");
  std::vector<std::array<double, 3>> cut;
  for (const Move& move : all<Move>()) {
    if (move.kind == MoveKind::line) cut.push_back({move.end[0], move.end[1], move.end[2]});
  }
  EXPECT_THAT(cut, ElementsAre(std::array{0.0, 6.0, -0.2}, std::array{0.0, 0.0, -0.2},
                               std::array{4.0, 0.0, -0.2}));
  EXPECT_EQ(end_x(), 6.0);
  EXPECT_THAT(codes_of("G47 P0 J6. Z-.2 (L) ; G0 X1"), Not(IsEmpty()));
  EXPECT_THAT(codes_of("#include \"mill/engrave.nc\""), ElementsAre("E2092"));
}

TEST_F(LineTest, ModalStateLastsFromLineToLine) {
  enter("G91 G1 F500");
  enter("X10");
  position_B[0] = 10.0;
  enter("X10");
  EXPECT_EQ(end_x(), 20.0);
  EXPECT_EQ(all<Move>().back().feed, 500.0);
}

TEST_F(LineTest, AFeedLawLastsFromLineToLine) {
  enter("S_n=60 dS=1 dl=1");
  EXPECT_EQ(all<FeedLawChange>().size(), 1U);
  enter("G1 X10");
  EXPECT_EQ(all<Move>().back().feed, 60.0);
  EXPECT_THAT(all<FeedLawChange>(), IsEmpty()) << "its way goes on";
  enter("M30");
  EXPECT_EQ(all<FeedLawChange>().at(0).law, FeedLaw{});
}

TEST_F(LineTest, ALineBeginsWhereTheAxesStandNow) {
  enter("G91");
  position_B[0] = 7.0;
  enter("G0 X1");
  EXPECT_EQ(end_x(), 8.0);
}

TEST_F(LineTest, AProgramBetweenBringsTheDefaultStateBack) {
  enter("G91 G20");
  files.texts["other.nc"] = "G1 X1 F100\nM30\n";
  auto program = compile("other.nc", files, &channel, warnings);
  interpreter->start(*program, position_B);
  drain();
  position_B[0] = 5.0;
  enter("G0 X1");
  EXPECT_EQ(end_x(), 1.0);
}

// LinuxCNC, M-Codes: M2 sets G54 and leaves G92; nothing else ends either (Coordinate Systems, G92
// persistence). X7 is where it stood when G92 X7 was typed.
TEST_F(LineTest, AProgramOfLinuxcncBeginsInTheOffsetsOfBefore) {
  tables.offsets[2] = AxisValues{100.0};
  files.texts["cnc.ngc"] = "(dialect linuxcnc)\nG0 X7\nM2\n";
  files.texts["shift.ngc"] = "(dialect linuxcnc)\nG0 X7\nG92 X1\nM2\n";
  files.texts["stanok.nc"] = "G0 X7\nM2\n";
  const auto end_of = [&](const std::string& name) {
    auto program = compile(name, files, &channel, warnings);
    interpreter->start(*program, position_B);
    commands.clear();
    drain();
    return all<FrameChange>().front().offset[0] + end_x();
  };
  enter("G55");
  enter("G92 X7");
  EXPECT_EQ(end_of("cnc.ngc"), 0.0);
  EXPECT_EQ(end_of("cnc.ngc"), -100.0) << "G54 and the shift of -107";
  EXPECT_EQ(interpreter->standing().terms->frame.offset[0], -107.0);
  enter("G0 X7");
  EXPECT_EQ(interpreter->standing().terms->frame.offset[0], -107.0);
  position_B[0] = -100.0;
  EXPECT_EQ(end_of("shift.ngc"), -100.0);
  EXPECT_EQ(end_of("cnc.ngc"), -94.0) << "X1 stands at -100";
  EXPECT_EQ(end_of("stanok.nc"), 7.0);
  EXPECT_EQ(end_of("cnc.ngc"), 7.0) << "the program of another dialect has ended the shift";
  enter("G92 X1");
  interpreter->reset({});
  EXPECT_EQ(end_of("cnc.ngc"), 7.0);
}

// What was read ahead and not executed shifts nothing.
TEST_F(LineTest, AProgramOfLinuxcncThatIsBrokenOffLeavesTheShiftOfBefore) {
  files.texts["shift.ngc"] = "(dialect linuxcnc)\nG92 X50\nG1 X7\nM2\n";
  enter("G92 X7");
  auto program = compile("shift.ngc", files, &channel, warnings);
  interpreter->start(*program, position_B);
  drain();
  EXPECT_NE(error.code, "") << "G1 without a feed";
  interpreter->break_off();
  EXPECT_EQ(interpreter->standing().terms->frame.offset[0], -7.0);
}

TEST_F(LineTest, AResetBringsTheDefaultStateBack) {
  enter("G91 G20");
  interpreter->reset({});
  position_B[0] = 5.0;
  enter("G0 X1");
  EXPECT_EQ(end_x(), 1.0);
}

TEST_F(LineTest, SpindleAndCoolantGoOnBehindTheLine) {
  enter("M3 S1000");
  EXPECT_EQ(all<SpindleCommand>().back().action, SpindleAction::clockwise);
  enter("M8");
  EXPECT_THAT(all<SpindleCommand>(), IsEmpty());
  enter("M30");
  EXPECT_EQ(all<SpindleCommand>().back().action, SpindleAction::stop);
  EXPECT_FALSE(all<CoolantCommand>().back().flood);
}

TEST_F(LineTest, M99IsTheEndOfTheLine) {
  enter("M99");
  EXPECT_EQ(all<ProgramEnd>().at(0).kind, ProgramEndKind::end_of_line);
}

TEST_F(LineTest, FunctionsOfTheLoadedProgramAndItsIncludesCanBeCalled) {
  files.texts["lib.nc"] = "num twice (num value) { return 2 * value; }\n";
  load("#include \"lib.nc\"\nvoid go_to (num place) { G0 X=place\n }\nG0 X99\nM30\n");
  enter("go_to (3);");
  EXPECT_EQ(end_x(), 3.0);
  EXPECT_EQ(all<Move>().size(), 1u) << "the program itself is not executed";
  enter("G0 X=twice (4)");
  EXPECT_EQ(end_x(), 8.0);
}

// As by MDI on LinuxCNC.
TEST_F(LineTest, OSubprogramsOfFilesAndOfTheLoadedProgramCanBeCalled) {
  files.texts["mac.ngc"] = "O<mac> sub\nG91 G0 X#1\nG90\nO<mac> endsub\nM2\n";
  files.texts["100.ngc"] = "O100 sub\nG0 X100\nO100 endsub\n";
  enter("O<mac> call [3]");
  EXPECT_EQ(error.code, "");
  EXPECT_EQ(end_x(), 3.0);
  EXPECT_EQ(all<ProgramEnd>().at(0).kind, ProgramEndKind::end_of_line);
  enter("o100 CALL");
  EXPECT_EQ(end_x(), 100.0);
  load("O<own> sub\nG0 X7\nO<own> endsub\nG0 X99\nM30\n");
  enter("o<own> call");
  EXPECT_EQ(end_x(), 7.0);
  EXPECT_THAT(codes_of("O<no> call"), ElementsAre("E7005"));
  EXPECT_THAT(codes_of("O<mac> call [1] G0 X1"), Not(IsEmpty()));
  EXPECT_THAT(codes_of("O<mac> call [1]\nG0 X1"), Not(IsEmpty()));
}

TEST_F(LineTest, TheTextsAreThoseOfTheLoad) {
  load("void go () { G0 X1\n }\nM30\n");
  files.texts["main.nc"] = "void go () { G0 X2\n }\nM30\n";
  enter("go ();");
  EXPECT_EQ(end_x(), 1.0);
}

TEST_F(LineTest, ParametersOfTheChannelLast) {
  enter("#<_depth> = 4");
  enter("G0 X#<_depth>");
  EXPECT_EQ(end_x(), 4.0);
}

TEST_F(LineTest, BlocksOfCodeAreOneStatement) {
  enter("for (num hole = 0; hole < 3; hole = hole + 1) { call (\"hole.nc\"); }");
  EXPECT_EQ(error.code, "E7005");
  EXPECT_EQ(error.place.file, "MDI");
}

TEST_F(LineTest, MoreOrLessThanOneStatementIsRefused) {
  EXPECT_THAT(codes_of("G0 X1\nX2"), ElementsAre("E2091"));
  EXPECT_THAT(codes_of("sync (); sync ();"), ElementsAre("E2091"));
  EXPECT_THAT(codes_of(""), ElementsAre("E2091"));
  EXPECT_THAT(codes_of("  (nothing)"), ElementsAre("E2091"));
  EXPECT_THAT(codes_of("if (true) {"), ElementsAre("E2003"));
}

TEST_F(LineTest, WhatBelongsIntoAProgramIsRefused) {
  files.texts["lib.nc"] = "M99\n";
  EXPECT_THAT(codes_of("#include \"lib.nc\""), ElementsAre("E2092"));
  EXPECT_THAT(codes_of("void hole () { }"), ElementsAre("E2092"));
  EXPECT_THAT(codes_of("O100 sub"), ::testing::Contains("E2092"));
  EXPECT_THAT(codes_of("O100 if [1]"), ::testing::Contains("E2092"));
  EXPECT_THAT(codes_of("channel_wait (2);"), ElementsAre("E2092"));
  EXPECT_THAT(codes_of("if (channel_wait (2)) { M0\n }"), ::testing::Contains("E2091"));
}

TEST_F(LineTest, ErrorsNameTheLineAsMdi) {
  const auto compiled = compile_line("G1 X10 Q5 W3", nullptr, files, &channel, warnings);
  ASSERT_FALSE(compiled);
  EXPECT_EQ(compiled.error().front().place.file, "MDI");
  EXPECT_EQ(compiled.error().front().place.line, 1u);
}

TEST_F(LineTest, AFailedLineDoesNotSpoilTheNext) {
  enter("G1 X10");
  EXPECT_NE(error.code, "") << "no feed yet";
  enter("G1 X10 F100");
  EXPECT_EQ(error.code, "");
  EXPECT_EQ(end_x(), 10.0);
}

}  // namespace
}  // namespace stanok::lang
