// Subprograms and macros: lookup over files, macro arguments, user codes of the machine file.
#include <random>

#include "lang/block/macro_arguments.h"
#include "lang/words/channel_dialect.h"
#include "tests/lang/program_support.h"

namespace stanok::lang::testing {
namespace {

class Subprograms : public ProgramTest {
 protected:
  void map(std::string_view code, std::string_view meaning) {
    const auto read = read_user_code(code, meaning);
    ASSERT_TRUE(read) << read.error();
    channel.user_codes.push_back(*read);
  }
};

TEST_F(Subprograms, SwitchAnOutputThatHasACodeAndWaitForItsFeedback) {
  map("M11", "output 4 on, input 7 within 2.5 s");
  map("M110", "output 5 off");
  run("M11\nM110\nM30\n");
  EXPECT_EQ(error.code, "");
  const auto outputs = all<OutputCommand>();
  ASSERT_EQ(outputs.size(), 2u);
  EXPECT_EQ(outputs[0].number, 4);
  EXPECT_EQ(outputs[0].value, 1.0);
  EXPECT_EQ(outputs[1].number, 5);
  EXPECT_EQ(outputs[1].value, 0.0);
  const auto requests = all<ProgramRequest>();
  ASSERT_EQ(requests.size(), 1u);
  EXPECT_EQ(requests[0].kind, RequestKind::input_wait);
  EXPECT_EQ(requests[0].number, 7);
  EXPECT_EQ(requests[0].index, 3);  // while on, as L3 of M66
  EXPECT_EQ(requests[0].seconds, 2.5);
}

// M51 to M58 and M61 to M68 of Haas are the user's (mill operator's manual), M70 to M72 the
// builder's on most controls.
TEST_F(Subprograms, MaySwitchOutputsWithCodesThatOnlyLinuxcncHas) {
  map("M51", "output 4 on");
  map("M61", "output 4 off");
  map("M72", "output 5 on");
  for (const char* const first : {"", "(dialect haas)\n", "(dialect fanuc)\n"}) {
    run(std::string(first) + "M51\nM61\nM72\nM30\n");
    EXPECT_EQ(error.code, "") << first;
    const auto outputs = all<OutputCommand>();
    ASSERT_EQ(outputs.size(), 3u) << first;
    EXPECT_EQ(outputs[0].number, 4);
    EXPECT_EQ(outputs[0].value, 1.0);
    EXPECT_EQ(outputs[1].value, 0.0);
    EXPECT_EQ(outputs[2].number, 5);
  }
  EXPECT_FALSE(read_user_code("M60", "output 4 on"));
  EXPECT_FALSE(read_user_code("M69.1", "output 4 on"));
}

TEST_F(Subprograms, EndWhereTheFeedbackOfAnOutputDoesNotCome) {
  map("M10", "output 4 off, input 7 within 2 s");
  answering = [](const ProgramRequest& request) {
    Answer answer;
    answer.ok = request.kind != RequestKind::input_wait;
    return answer;
  };
  run("G0 X1\nM10\nX2\nM30\n");
  EXPECT_EQ(error.code, "E5030");
  EXPECT_EQ(error.place.line, 2);
  EXPECT_EQ(error.message, "input 7 did not turn off within 2 s");
  EXPECT_EQ(all<Move>().size(), 1u);
  run("M66 P7 L3 Q1\nX2\nM30\n");  // a result, no error
  EXPECT_EQ(error.code, "");
}

TEST_F(Subprograms, RefuseOutputsThatAreNone) {
  for (const char* meaning :
       {"output 4", "output x on", "output 4 up", "output 99 on", "output 1.5 on",
        "output 4 on, input 7", "output 4 on, input 7 within 0 s",
        "output 4 on, input 7 within 2 m", "output -1 on", "output 4 on, input 99 within 2 s"}) {
    EXPECT_FALSE(read_user_code("M11", meaning)) << meaning;
  }
  EXPECT_FALSE(read_user_code("M8", "output 4 on"));
  EXPECT_FALSE(read_user_code("G200", "output 4 on"));
  map("M11", "output 4 on");
  EXPECT_EQ(error_code("M11 P1\nM30\n"), "E4003");
}

TEST_F(Subprograms, RefusesWhatStandsInTwoIncludedFiles) {
  files.texts["a.nc"] = "O5\nM99\nO<drill> sub\nO<drill> endsub\n";
  files.texts["b.nc"] = files.texts["a.nc"];
  const std::string both = "#include \"a.nc\"\n#include \"b.nc\"\n";
  EXPECT_EQ(error_code(both + "M98 P5\nM30\n"), "E7006");
  EXPECT_EQ(error_code(both + "O<drill> call\nM30\n"), "E7006");
  EXPECT_EQ(error_code("#include \"a.nc\"\n#include \"a.nc\"\nM98 P5\nO<drill> call\nM30\n"), "");
  EXPECT_EQ(
      error_code(both + "M98 P5\nO<drill> call\nM30\nO5\nM99\nO<drill> sub\nO<drill> endsub\n"),
      "");
}

TEST_F(Subprograms, RefusesNamesOfTwoIncludedFilesUnlessItHasThemItself) {
  files.texts["a.nc"] = "num height () { return 1; }\nconst num SAFE_Z = 1;\n";
  files.texts["b.nc"] = "num height () { return 2; }\nconst num SAFE_Z = 2;\n";
  const std::string both = "#include \"a.nc\"\n#include \"b.nc\"\n";
  EXPECT_EQ(error_code(both + "G0 X=height ()\nM30\n"), "E7006");
  EXPECT_EQ(error_code(both + "G0 X=SAFE_Z\nM30\n"), "E7006");
  EXPECT_EQ(error.notes.at(0).text, "in a.nc and b.nc");
  EXPECT_EQ(error_code(both + "G0 X1\nM30\n"), "");
  EXPECT_EQ(messages(both + "num height () { return 3; }\nconst num SAFE_Z = 4;\n"
                            "msg (str (height ()) + str (SAFE_Z));\nM30\n"),
            Texts{"34"});
}

TEST_F(Subprograms, FindsFilesOfANumberInOrder) {
  files.texts["O0007.nc"] = "(MSG,first)\nM99\n";
  files.texts["7.nc"] = "(MSG,second)\nM99\n";
  files.texts["o8.nc"] = "(MSG,third)\nM99\n";
  EXPECT_EQ(messages("M98 P7\nM98 P8\nM30\n"), (Texts{"first", "third"}));
  files.texts.erase("O0007.nc");
  EXPECT_EQ(messages("M98 P7\nM30\n"), Texts{"second"});
}

TEST_F(Subprograms, GivesAFileItsOwnVariablesEachTime) {
  files.texts["7.nc"] = "num count;\ncount += 1;\nmsg (str (count + #1));\n#1=5\nM99\n";
  EXPECT_EQ(messages("#1=10\nM98 P7\nM98 P7\nM30\n"), (Texts{"11", "6"}));
  EXPECT_EQ(messages("#include \"7.nc\"\n#1=10\ncall (\"7.nc\");\ncall (\"7.nc\");\nM30\n"),
            (Texts{"1", "1"}));
}

TEST_F(Subprograms, KeepsGlobalNamesFromRunToRun) {
  interpreter = std::make_unique<Interpreter>(channel, tables, files);
  for (const char* const text : {"#<_parts>=1 #<local>=1\nM30\n",
                                 "#<other>=2 #<_parts>=[#<_parts> + EXISTS[#<local>] + 2]\nM30\n",
                                 "(DEBUG,%d#<_parts>)\nM30\n"}) {
    files.texts["main.nc"] = text;
    const auto program = compile("main.nc", files, &channel, warnings);
    ASSERT_TRUE(program);
    commands.clear();
    interpreter->start(*program, {});
    drain();
  }
  EXPECT_EQ(all<Message>().at(0).text, "3");
}

TEST_F(Subprograms, StopsRunawayCallsOfAllKinds) {
  EXPECT_EQ(error_code("O1 call\nM30\nO1 sub\nO1 call\nO1 endsub\n"), "E8001");
  EXPECT_EQ(error.stack.size(), 64u);
  EXPECT_EQ(error.stack.back(), "in O1, called at main.nc:1:1");
  EXPECT_EQ(error_code("M98 P1\nM30\nO1\nG65 P1\nM99\n"), "E8001");
}

TEST_F(Subprograms, ReturnsFromWithinLoopsAndFunctions) {
  EXPECT_EQ(
      messages("void leave () { M99 }\nO1 call\nmsg (\"back\");\nM98 P2\nmsg (\"again\");\nM30\n"
               "O1 sub\nO2 while [1]\nleave ();\nO2 endwhile\nO1 endsub\n"
               "O2\nwhile (true) { while (true) { M99\n} }\n"),
      (Texts{"back", "again"}));
}

// Table I of the argument specification, Fanuc Macro B.
TEST_F(Subprograms, GivesG65WordsTheirParameters) {
  const std::pair<char, int> table[] = {
      {'A', 1},  {'B', 2},  {'C', 3},  {'D', 7},  {'E', 8},  {'F', 9},  {'H', 11},
      {'I', 4},  {'J', 5},  {'K', 6},  {'M', 13}, {'Q', 17}, {'R', 18}, {'S', 19},
      {'T', 20}, {'U', 21}, {'V', 22}, {'W', 23}, {'X', 24}, {'Y', 25}, {'Z', 26}};
  int listed = 0;
  for (char letter = 'A'; letter <= 'Z'; ++letter) {
    if (parameter_of_argument(letter) != 0) ++listed;
  }
  EXPECT_EQ(listed, 21);
  for (const auto& [letter, number] : table) {
    const std::string text = std::string("#") + std::to_string(number) + "=1\nG65 P1 " + letter +
                             "7\n(DEBUG,%d#" + std::to_string(number) + ")\nM30\nO1\n(DEBUG,%d#" +
                             std::to_string(number) + ")\nM99\n";
    EXPECT_EQ(messages(text), (Texts{"7", "1"})) << letter;
  }
}

TEST_F(Subprograms, RepeatsG65WithFreshArguments) {
  EXPECT_EQ(messages("#5=3\nG65 P1 L2 X[#5 * 2] z-.5\nM30\n"
                     "O1\n(DEBUG,%.1f#24 #26 #5)\n#24=0 #5=9\nM99\n"),
            (Texts{"6.0 -0.5 0.0", "6.0 -0.5 0.0"}));
  EXPECT_EQ(error_code("G65 P1 G0 X1\nM30\n"), "E4013");
  EXPECT_EQ(error_code("G65 X1\nM30\n"), "E4007");
  EXPECT_EQ(error_code("G65 P1 $1\nM30\n"), "E4003");
  EXPECT_EQ(error_code("G65 P3\nM30\n"), "E7005");
}

TEST_F(Subprograms, CallsMacrosOfTheMachineFile) {
  files.texts["groove.nc"] =
      "if (has_arg (\"R\")) { msg (\"R\" + str (arg (\"R\"))); }\nG0 X=arg (\"X\") Y#26\nM99\n";
  files.texts["change.nc"] = "num lift () { return arg (\"T\"); }\nT=lift () M6\nM99\n";
  files.texts["lib.nc"] = "void wash () { msg (\"wash\"); M120 }\n";
  map("G200", "groove.nc");
  map("M6", "change.nc");
  map("M150", "lib.nc:wash");
  map("M120", "before wait");
  tables.tools[5] = {5, {}, 0.0};
  EXPECT_EQ(messages("G200 X5 Z3 R2\nM150\nT5 M6\nG=200 X1 Z1\nM30\n"), (Texts{"R2", "wash"}));
  const auto list = all<Move>();
  ASSERT_EQ(list.size(), 2u);
  EXPECT_EQ(list[0].end[0], 5.0);
  EXPECT_EQ(list[0].end[1], 3.0);
  EXPECT_EQ(all<ToolChange>().at(0).tool, 5);
  EXPECT_EQ(all<MachineFunction>().at(0).code, 120);
  EXPECT_EQ(all<ProgramRequest>().size(), 1u);
  EXPECT_EQ(error_code("G200 Z3\nM30\n"), "E3019");
  EXPECT_EQ(error.stack.size(), 1u);
  EXPECT_EQ(error_code("G200 X1 G1\nM30\n"), "E4013");
  EXPECT_EQ(error_code("num xx_ = arg (\"X\");\nM30\n"), "E3019");
  EXPECT_EQ(error_code("G201 X1\nM30\n"), "E4004");
}

// The way every CAM system writes a tool change; with a T of its own in the program it stays so.
TEST_F(Subprograms, TakesTheToolOfItsBlockBeforeAProgramForM6) {
  files.texts["change.nc"] = "G53 G0 Z100\nM6\nmsg (str (arg (\"T\")));\nM99\n";
  map("M6", "change.nc");
  tables.tools[5] = {5, {}, 0.0};
  tables.tools[7] = {7, {}, 0.0};
  EXPECT_EQ(messages("T5 M6\nM6 T7\nT5\nG0 X1\nM6 T7\nM30\n"), (Texts{"5", "7", "7"}));
  std::vector<int> prepared;
  std::vector<int> changed;
  for (const ToolPrepare& one : all<ToolPrepare>()) prepared.push_back(one.tool);
  for (const ToolChange& one : all<ToolChange>()) changed.push_back(one.tool);
  EXPECT_EQ(prepared, (std::vector<int>{5, 7, 5, 7}));
  EXPECT_EQ(changed, (std::vector<int>{5, 7, 7}));
  ASSERT_GE(commands.size(), 3u);
  EXPECT_TRUE(std::holds_alternative<ToolPrepare>(commands[0].payload));
  EXPECT_TRUE(std::holds_alternative<Move>(commands[1].payload));
  EXPECT_TRUE(std::holds_alternative<ToolChange>(commands[2].payload));
  EXPECT_EQ(error_code("T6 M6\nM30\n"), "E5021");
  EXPECT_EQ(error.place.line, 1);
  EXPECT_EQ(error_code("M6\nM30\n"), "E4051");
}

TEST_F(Subprograms, TakesTheSpeedOfItsBlockBeforeAProgramForM3) {
  files.texts["start.nc"] = "M3\nM99\n";
  map("M3", "start.nc");
  run("S500 M3\nM30\n");
  EXPECT_EQ(error.code, "") << to_text(error);
  const auto list = all<SpindleCommand>();
  ASSERT_GE(list.size(), 2u);
  EXPECT_EQ(list[0].action, SpindleAction::set_speed);
  EXPECT_EQ(list[1].action, SpindleAction::clockwise);
  EXPECT_EQ(list[1].speed_rev_per_min, 500.0);
}

// Where the T word itself changes the tool, the program must come first.
TEST_F(Subprograms, LeavesTheToolToAProgramForM6WhereTChangesIt) {
  files.texts["change.nc"] = "G0 X9\nT=arg (\"T\")\nM99\n";
  map("M6", "change.nc");
  channel.kind = ChannelKind::lathe;
  channel.axes = {{"X", false, 0.0, 0}, {"Z", false, 0.0, 2}};
  tables.tools[5] = {5, {}, 0.0};
  run("T5 M6\nM30\n");
  ASSERT_GE(commands.size(), 2u);
  EXPECT_TRUE(std::holds_alternative<Move>(commands[0].payload));
  EXPECT_TRUE(std::holds_alternative<ToolPrepare>(commands[1].payload));
}

TEST_F(Subprograms, SendsMachineFunctionsInTheOrderOfTheirClass) {
  map("M101", "after");
  map("M102", "before");
  map("M103", "with_motion");
  run("M101 M103 M102 G1 X1 F5 P7 M8\nM30\n");
  std::vector<int> order;
  for (const Command& command : commands) {
    if (const auto* one = std::get_if<MachineFunction>(&command.payload))
      order.push_back(one->code);
    if (std::holds_alternative<Move>(command.payload)) order.push_back(0);
    if (std::holds_alternative<CoolantCommand>(command.payload)) order.push_back(8);
  }
  EXPECT_EQ(order, (std::vector<int>{8, 102, 103, 0, 101, 8}));
  EXPECT_EQ(all<MachineFunction>().at(0).p, 7.0);
}

TEST_F(Subprograms, NamesAMissingMacroFileWhereItIsCalled) {
  map("G200", "missing.nc");
  map("G201", "lib.nc:wash");
  files.texts["lib.nc"] = "num wash () { return 1; }\n";
  EXPECT_EQ(error_code("G0 X1\nG200 X1\nM30\n"), "E7001");
  EXPECT_EQ(error.place.line, 2);
  EXPECT_EQ(error_code("G201\nM30\n"), "E7005");
}

TEST_F(Subprograms, ReadsOnlySensibleUserCodes) {
  for (const char* const code : {"G0", "G3", "G17", "G40", "G53", "G65", "G91", "M0", "M30", "M98",
                                 "M99", "M902", "X5", "G", "G1.23", "M5000"}) {
    EXPECT_FALSE(read_user_code(code, "a.nc")) << code;
  }
  for (const char* const meaning : {"groove", "", "before now", "beside"}) {
    EXPECT_FALSE(read_user_code("M120", meaning)) << meaning;
  }
  EXPECT_FALSE(read_user_code("M6", "before"));
  EXPECT_FALSE(read_user_code("M900", "before"));
  EXPECT_FALSE(read_user_code("G200", "after"));
  EXPECT_EQ(read_user_code("G43.4", "tip.nc")->number, 434);
}

TEST_F(Subprograms, UnderstandsLettersForNamedAddresses) {
  channel.address_alias = {{'E', "X2"}};
  channel.axes[4] = {"X2", false, 0.0, -1};
  const auto list = moves("G1 F10 X1 E0.5\nE=2*2\nE[3]\nG=1 X1\nM30\n");
  ASSERT_EQ(list.size(), 4u);
  EXPECT_EQ(list[0].end[4], 0.5);
  EXPECT_EQ(list[1].end[4], 4.0);
  EXPECT_EQ(list[2].end[4], 3.0);
  EXPECT_EQ(error_code("G1 F10 E1 X2=3\nM30\n"), "E4001");
}

// Cycles read a contour as plain text, which knows no such letters: they must not be lost there.
TEST_F(Subprograms, RefuseALetterForANamedAddressInAContour) {
  channel.kind = ChannelKind::lathe;
  channel.axes = {{"X", false, 0.0, 0}, {"Z", false, 0.0, 2}, {"X2", false, 0.0, -1}};
  const std::string cycle = "G0 X50 Z2 F0.2\nG70 P10 Q20\nN10 G0 X20\n";
  EXPECT_EQ(error_code(cycle + "N20 G1 Z-10\nM30\n"), "");
  channel.address_alias = {{'E', "X2"}};
  EXPECT_EQ(error_code(cycle + "N20 G1 Z-10 E3\nM30\n"), "E4068");
}

}  // namespace
}  // namespace stanok::lang::testing
