// Values that are not likely are asked about, and taken when they are confirmed.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/daemon/daemon_bench.h"

namespace stanok::daemon {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

class EntryDoubt : public ::testing::Test {
 protected:
  // "": done; else the code of the refusal.
  std::string code_of(const std::string& method, const json& parameters) {
    answer = *bench.answer(method, parameters);
    return answer ? "" : answer.error().code;
  }
  std::string set_tool(const char* key, double value, int confirmed = 0) {
    return code_of("tool.set",
                   {{"number", 3}, {"key", key}, {"value", value}, {"confirmed", confirmed}});
  }
  std::string set_offset(const char* axis, double value, int confirmed = 0) {
    return code_of("offset.set",
                   {{"offset", "G55"}, {"axis", axis}, {"value", value}, {"confirmed", confirmed}});
  }
  std::string load(const std::string& text, int confirmed = 0) {
    return code_of("tool.load", {{"tables", text}, {"confirmed", confirmed}});
  }
  double tool_value(const std::string& key) {
    return bench.answer("tool.get", {{"number", 3}})->value()[key];
  }
  double offset(const std::string& axis) {
    return bench.answer("offset.list")->value()["offsets"]["G55"][axis];
  }

  DaemonBench bench;
  CommandResult answer = json();
};

TEST_F(EntryDoubt, IsAboutEachValueOfATool) {
  const struct {
    const char* key;
    double wrong, right;
  } cases[] = {{"length", -5.0, 80.0},       {"length", 99999.0, 90.0},
               {"length_x", -501.0, -25.0},  {"length_y", 501.0, 0.5},
               {"radius", 5000.0, 6.0},      {"wear_length", 80.0, 0.5},
               {"wear_radius", -80.0, -0.5}, {"overhang", 99999.0, 40.0}};
  for (const auto& each : cases) {
    const std::string key = each.key;
    EXPECT_EQ(set_tool(each.key, each.right), "") << key;
    EXPECT_EQ(set_tool(each.key, each.wrong), "E6095") << key;
    EXPECT_THAT(answer.error().message, HasSubstr("tool 3, " + key + ": ")) << key;
    EXPECT_EQ(tool_value(key), each.right) << "nothing was changed";
    EXPECT_EQ(set_tool(each.key, each.wrong, 1), "") << key;
    EXPECT_EQ(tool_value(key), each.wrong);
    EXPECT_EQ(set_tool(each.key, each.right, 1), "") << key;
  }
}

TEST_F(EntryDoubt, IsAboutAWorkOffsetBeyondTheTravel) {
  EXPECT_EQ(set_offset("Y", 99999.0), "E6095");
  EXPECT_THAT(answer.error().message, HasSubstr("G55 Y: 99999 mm is more than"));
  EXPECT_THAT(answer.error().message, HasSubstr("(offset_max)"));
  EXPECT_EQ(offset("Y"), 0.0);
  EXPECT_EQ(set_offset("R", 361.0), "E6095");
  EXPECT_EQ(set_offset("Y", 99999.0, 1), "");
  EXPECT_EQ(offset("Y"), 99999.0);
}

// From 0 nothing is known yet: a first value may be any plausible one.
TEST_F(EntryDoubt, IsAboutALargeChangeOfWhatWasSet) {
  EXPECT_EQ(set_tool("length", 180.0), "");
  EXPECT_EQ(set_tool("length", 80.0), "") << "100 mm are permitted";
  EXPECT_EQ(set_tool("length", 180.5), "E6095");
  EXPECT_THAT(answer.error().message,
              HasSubstr("tool 3, length: from 80 to 180.5 mm is a change of more than 100 mm "
                        "(change_max)"));
  EXPECT_EQ(set_tool("length", 180.5, 1), "");
  EXPECT_EQ(set_offset("Y", 250.0), "");
  EXPECT_EQ(set_offset("Y", -250.0), "E6095");
  EXPECT_EQ(offset("Y"), 250.0);
}

TEST_F(EntryDoubt, NamesEveryRowOfATextAndLoadsNothingOfIt) {
  const std::string text =
      "[[tool]]\nnumber = 3\nlength = -5\nradius = 4\n"
      "[[tool]]\nnumber = 4\nlength = 50\nwear_length = 80\n"
      "[offset.G55]\nY = 99999\n";
  EXPECT_EQ(set_tool("radius", 2.0), "");
  EXPECT_EQ(load(text), "E6095");
  for (const char* row : {"tool 3, length: -5 mm", "tool 4, wear_length: 80 mm", "G55 Y: 99999 mm"})
    EXPECT_THAT(answer.error().message, HasSubstr(row));
  EXPECT_EQ(tool_value("radius"), 2.0);
  EXPECT_EQ(load(text, 1), "");
  EXPECT_EQ(tool_value("length"), -5.0);
  EXPECT_EQ(load(text), "") << "what is there already is no question";
  EXPECT_EQ(answer.value()["values"], 0);
}

TEST_F(EntryDoubt, OfVeryManyRowsNamesTwenty) {
  std::string text;
  for (int tool = 1; tool <= 25; ++tool)
    text += "[[tool]]\nnumber = " + std::to_string(tool) + "\nlength = -5\n";
  EXPECT_EQ(load(text), "E6095");
  EXPECT_THAT(answer.error().message, HasSubstr("tool 20, length"));
  EXPECT_THAT(answer.error().message, HasSubstr("; and 5 more"));
}

// No confirmation makes a value of what is none.
TEST_F(EntryDoubt, CannotBeOvercomeWhereAValueIsAbsurd) {
  for (const char* value : {"nan", "inf", "-inf"}) {
    EXPECT_EQ(load("[offset.G55]\nY = " + std::string(value) + "\n", 1), "E9014") << value;
    EXPECT_EQ(load("[[tool]]\nnumber = 3\nlength = " + std::string(value) + "\n", 1), "E9014");
  }
  EXPECT_EQ(load("[offset.G55]\nY = 1e308\n", 1), "E5020");
  EXPECT_EQ(load("[[tool]]\nnumber = 3\nlength = 1e308\n", 1), "E5020");
  EXPECT_EQ(set_offset("Y", 1e308, 1), "E9003");
  EXPECT_EQ(set_tool("length", 1e308, 1), "E9003");
  EXPECT_EQ(set_tool("radius", -1.0, 1), "E5020");
  EXPECT_EQ(offset("Y"), 0.0);
}

}  // namespace
}  // namespace stanok::daemon
