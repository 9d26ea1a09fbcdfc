// Tables that are saved and loaded: the same to the bit, all or nothing for wrong texts, refused
// while a program runs.
#include <gtest/gtest.h>

#include <random>

#include "tests/daemon/daemon_bench.h"

namespace stanok::daemon {
namespace {

using nlohmann::json;

class TableLoading : public ::testing::Test {
 protected:
  std::string saved() { return bench.answer("tool.save")->value()["tables"]; }
  // "": done; else the code of the refusal. Values are confirmed: any are.
  std::string load(const std::string& text) {
    answer = *bench.answer("tool.load", {{"tables", text}, {"file", "t.toml"}, {"confirmed", 1}});
    return answer ? "" : answer.error().code;
  }
  double value_of(int tool, const std::string& key) {
    return bench.answer("tool.get", {{"number", tool}})->value()[key];
  }

  DaemonBench bench;
  CommandResult answer = json();
};

TEST_F(TableLoading, ChangesWhatTheTextNames) {
  bench.demand("tool.set", {{"number", 7}, {"key", "radius"}, {"value", 3.0}});
  EXPECT_EQ(load("[[tool]]\nnumber = 7\nlength = 81.25\nradius = 3.0\n"
                 "[offset.G55]\nX = -12.5\nR = 30\n"
                 "[offset.\"G54.1 P2\"]\nZ = 4\n"),
            "");
  EXPECT_EQ(answer.value()["values"], 4) << "the radius is there already";
  EXPECT_EQ(value_of(7, "length"), 81.25);
  EXPECT_EQ(value_of(7, "radius"), 3.0);
  EXPECT_EQ(load("[[tool]]\nnumber = 7\nlength = 80\n"), "");
  EXPECT_EQ(value_of(7, "radius"), 3.0) << "what a row leaves out stays";
  const json offsets = bench.answer("offset.list")->value()["offsets"];
  EXPECT_EQ(offsets["G55"]["X"], -12.5);
  EXPECT_EQ(offsets["G55"]["R"], 30.0);
  EXPECT_EQ(offsets["G54.1 P2"]["Z"], 4.0);
}

TEST_F(TableLoading, RefusesAnotherReferencePoint) {
  bench.demand("tool.set", {{"number", 7}, {"key", "radius"}, {"value", 3.0}});
  EXPECT_EQ(load("[reference_point.1.G28]\nX = 0\n"), "") << "it is so already";
  EXPECT_EQ(load("[[tool]]\nnumber = 7\nlength = 9\n[reference_point.1.G28]\nX = 3\n"), "E9015");
  EXPECT_EQ(value_of(7, "length"), 0.0) << "nothing of it is loaded";
}

TEST_F(TableLoading, RefusesAKeyOfVeryManyPartsBeforeItIsParsed) {
  std::string key = "a";
  for (int part = 1; part < 50'000; ++part) key += ".a";
  for (const std::string& text : {key + " = 1\n", "[" + key + "]\n", "x = {" + key + " = 1}\n"}) {
    EXPECT_EQ(load(text), "E9014");
    EXPECT_EQ(answer.error().place.line, 1);
  }
  EXPECT_EQ(load("x = " + std::string(100'000, '[')), "E9014");
}

// Random values through a saved text and back.
TEST_F(TableLoading, OfASavedTextBringsEveryBitBack) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> length(-900.0, 900.0);
  for (int tool = 1; tool <= 20; ++tool) {
    for (const char* key : {"length", "wear_length", "length_x"}) {
      bench.demand("tool.set",
                   {{"number", tool}, {"key", key}, {"value", length(random)}, {"confirmed", 1}});
    }
  }
  for (const char* offset : {"G54", "G59.3", "G54.1 P300"})
    bench.demand("offset.set",
                 {{"offset", offset}, {"axis", "Y"}, {"value", length(random)}, {"confirmed", 1}});
  const std::string before = saved();
  for (int tool = 1; tool <= 20; ++tool)
    bench.demand("tool.set",
                 {{"number", tool}, {"key", "length"}, {"value", 1.0}, {"confirmed", 1}});
  bench.demand("offset.set", {{"offset", "G54"}, {"axis", "Y"}, {"value", 1.0}, {"confirmed", 1}});
  ASSERT_NE(saved(), before);
  EXPECT_EQ(load(before), "");
  EXPECT_EQ(answer.value()["values"], 21);
  EXPECT_EQ(saved(), before);
  EXPECT_EQ(load(before), "");
  EXPECT_EQ(answer.value()["values"], 0);
}

TEST_F(TableLoading, OfAWrongTextChangesNothing) {
  const std::string before = saved();
  EXPECT_EQ(load("[[tool]]\nnumber = 4\nlength = 5\n[[tool]]\nnumber = 5\nlenght = 5\n"), "E9014");
  EXPECT_EQ(answer.error().place.file, "t.toml");
  EXPECT_EQ(answer.error().place.line, 6);
  EXPECT_EQ(load("[offset.G12]\nX = 1\n"), "E9014");
  EXPECT_EQ(load("not a table"), "E9014");
  EXPECT_EQ(load("[[tool]]\nnumber = 4\nlength = 5\nkind = \"taper\"\n"), "E9015");
  EXPECT_EQ(saved(), before);
}

TEST_F(TableLoading, IsRefusedWhileAProgramRuns) {
  bench.program("long.nc", "G90 G1 X400 F600\nM30\n");
  bench.demand("machine.on");
  bench.demand("program.run", {{"program", "long.nc"}});
  const std::string before = saved();
  EXPECT_EQ(load("[[tool]]\nnumber = 4\nlength = 5\n"), "E6003");
  EXPECT_EQ(saved(), before);
}

// A tool that has no row and none of the 99 that need none.
TEST_F(TableLoading, TellsHowFarItCame) {
  EXPECT_EQ(load("[[tool]]\nnumber = 4\nlength = 5\n[[tool]]\nnumber = 12345\nlength = 5\n"),
            "E5021");
  EXPECT_NE(answer.error().message.find("1 of 2 values had been written"), std::string::npos)
      << answer.error().message;
}

}  // namespace
}  // namespace stanok::daemon
