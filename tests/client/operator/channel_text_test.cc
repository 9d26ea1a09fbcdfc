// The status of a channel as an operator reads it.
#include "client/operator/channel_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "client/operator/result_text.h"

namespace stanok::client {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

const Terminal into_a_pipe(Screen::none);

json mill_status() {
  return {
      {"id", 1},
      {"name", "work"},
      {"words", {"X", "Y", "B"}},
      {"axis_names", {"X2", "Y", "B"}},
      {"state", "Active"},
      {"program_status", "Running"},
      {"held_by", nullptr},
      {"alarm", nullptr},
      {"program", "part.nc"},
      {"line", 12},
      {"block", 34},
      {"scheme", 1},
      {"position", {{"B", 0.0}, {"X", 1.5}, {"Y", -0.00001}}},
      {"to_go", {{"B", 0.0}, {"X", -12.25}, {"Y", 3.0}}},
      {"axes",
       {{"B", {{"position", 90.0}, {"enabled", false}, {"brake", true}, {"takes_part", false}}},
        {"X2", {{"position", 301.5}, {"enabled", true}, {"brake", false}, {"takes_part", true}}},
        {"Y", {{"position", 40.0}, {"enabled", true}, {"verified", false}}}}},
      {"feed_mm_s", 25.0},
      {"speed_mm_s", 24.0},
      {"g_codes", {"G1", "G95"}},
      {"m_codes", {"M3"}},
      {"feed_mm_rev", 0.25},
      {"override", {{"feed", 80.0}, {"rapid", 50.0}, {"spindle", 110.0}}},
      {"tool", {{"number", 5}, {"edge", 2}, {"name", "mill 10"}}},
      {"spindles",
       {{{"id", 1},
         {"direction", "counter-clockwise"},
         {"commanded_rev_min", -6000.0},
         {"actual_rev_min", -5998.4}}}},
      {"remaining_s", 249.0},
      {"new_member", "is shown"}};
}

TEST(ChannelText, ShowsWhatAnOperatorReads) {
  EXPECT_EQ(
      channel_text(mill_status(), into_a_pipe),
      "channel 1   work  Active  Running\n"
      "program     part.nc:12  block 34  4:09 left\n"
      "codes       G1 G95 M3\n"
      "feed        1500.0 mm/min programmed (0.2500 mm/rev), 1440.0 mm/min now, override 80 %, "
      "rapid 50 %\n"
      "spindle     S1 counter-clockwise, 6000 rev/min commanded, 5998 measured, override 110 %\n"
      "tool        T5 mill 10, edge 2\n"
      "kinematics  scheme 1\n"
      "new_member  is shown\n"
      "\n"
      "axis    position  to go     machine   drive\n"
      "X = X2    1.5000  -12.2500  301.5000  on\n"
      "Y         0.0000    3.0000   40.0000  on, position not verified\n"
      "B         0.0000    0.0000   90.0000  parked, off, brake\n");
}

TEST(ChannelText, ShowsWhereAWordComesFrom) {
  json answer = {{"channel", 1},
                 {"diameter", {"X"}},
                 {"axes", {{{"word", "X"}, {"axis", "X1"}, {"machine", 20.0}, {"shown", 100.0}}}}};
  EXPECT_EQ(result_text("channel.position", answer, into_a_pipe),
            "word  shown     machine\n"
            "X Ø   100.0000  20.0000\n");
  answer["axes"][0]["terms"] = {{{"term", "machine"},
                                 {"name", "machine position of X1"},
                                 {"amount", 20.0},
                                 {"value", 20.0},
                                 {"fixed", true}},
                                {{"term", "scheme_zero"},
                                 {"name", "zero of scheme 1 (lathe)"},
                                 {"amount", 30.0},
                                 {"value", 50.0},
                                 {"fixed", true}},
                                {{"term", "diameter"},
                                 {"name", "diameter (G7)"},
                                 {"amount", 50.0},
                                 {"value", 100.0},
                                 {"fixed", false}}};
  EXPECT_EQ(result_text("channel.position", answer, into_a_pipe),
            "X Ø                       adds     result\n"
            "machine position of X1    20.0000   20.0000\n"
            "zero of scheme 1 (lathe)  30.0000   50.0000\n"
            "diameter (G7)             50.0000  100.0000  at the present axis positions\n");
}

TEST(ChannelText, TellsWhyAChannelIsHeldAndWhatIsForeseen) {
  json status = mill_status();
  status["held_by"] = "feed hold by an operator";
  EXPECT_THAT(channel_text(status, into_a_pipe), ::testing::Not(HasSubstr("tap ")));
  status["tap_in_hole"] = true;
  status["alarm"] = {{"code", "A2001"}, {"text", "drive fault"}};
  status["foreseen"] = {{"code", "E5101"}, {"text", "too far"}, {"file", "a.nc"}, {"line", 3}};
  const std::string text = channel_text(status, into_a_pipe);
  EXPECT_THAT(text, HasSubstr("held by     feed hold by an operator\n"));
  EXPECT_THAT(text,
              HasSubstr("tap         was left in its hole; `stanok mdi \"G30 P99\"` takes it"));
  EXPECT_THAT(text, HasSubstr("expected    a.nc:3: E5101 too far\n"));
  EXPECT_THAT(text, HasSubstr("alarm       A2001 drive fault\n"));
}

TEST(ChannelText, TakesAStatusWithoutAnything) {
  EXPECT_THAT(channel_text(json::object(), into_a_pipe), HasSubstr("program     -\n"));
  EXPECT_EQ(position_text(json::object()), "-");
}

TEST(ChannelText, PutsChannelsAndAxesInTheirOrder) {
  const json channels = {{"10", {{"id", 10}}}, {"2", {{"id", 2}}}};
  EXPECT_EQ(channels_in_order(channels).front()["id"], 2);
  EXPECT_EQ(position_text(mill_status()), "X 1.5000  Y 0  B 0");
  const auto ordered = in_machine_order(mill_status());
  EXPECT_EQ(ordered["position"].dump(), R"({"X":1.5,"Y":-1e-05,"B":0.0})");
  EXPECT_EQ(ordered["axes"].begin().key(), "X2");
}

TEST(OffsetsText, IsATableOfNumbers) {
  const json result = {{"axes", {"X", "B"}},
                       {"offsets", {{"G54", {{"B", 0.0}, {"X", 12.5}}}, {"G55", {{"X", 0.0}}}}}};
  EXPECT_EQ(result_text("offset.list", result, into_a_pipe),
            "offset  X        B\n"
            "G54     12.5000  0\n"
            "G55           0  0\n");
}

// A lathe in G7, in a file that the program calls.
TEST(ChannelText, MarksDiametersAndTheFileOfTheLine) {
  const json status{{"words", {"X", "Z"}}, {"position", {{"X", 100.0}, {"Z", -2.0}}},
                    {"diameter", {"X"}},   {"program", "part.nc"},
                    {"file", "groove.nc"}, {"line", 12}};
  EXPECT_EQ(position_text(status), "X Ø 100  Z -2");
  EXPECT_NE(channel_text(status, into_a_pipe).find("part.nc in groove.nc:12"), std::string::npos);
}

}  // namespace
}  // namespace stanok::client
