#include "jobs/logs/log_fields.h"

#include <gtest/gtest.h>

#include "jobs/logs/situation_fields.h"
#include "protocol/contract/fields_json.h"

namespace stanok::jobs {
namespace {

recording::LogContents contents_of_a_log() {
  recording::LogContents contents;
  contents.events = 3;
  contents.utime_first = 1'000'000;
  contents.utime_last = 2'000'000;
  contents.channels["SETPOINT_1"] = {.type = "setpoint_t", .messages = 3, .bytes = 900};
  return contents;
}

TEST(LogFields, OfALogThatDoesNotDescribeItsMachine) {
  const auto json = protocol::fields_json(log_fields(contents_of_a_log()));
  EXPECT_TRUE(json.at("machine").is_null());
  EXPECT_FALSE(json.contains("axes"));
  EXPECT_EQ(json.at("end"), "unknown") << "without checks";
  EXPECT_EQ(json.at("channels").at(0).at("name"), "SETPOINT_1");
  EXPECT_EQ(json.at("channels").at(0).at("messages"), 3);
  EXPECT_EQ(json.at("damage").size(), 0U);
}

// Axes that the log does not describe have numbers.
TEST(SituationFields, AreByTheWordsOfTheAxes) {
  situation_t situation{};
  situation.utime = 1'500'000;
  situation.channel = 1;
  situation.axis_count = 2;
  situation.work_offset[1] = 7.5;
  situation.work_offset_number = 2;
  situation.overhang_axis = -1;
  situation.length_row = 100;
  const auto json = protocol::fields_json(situation_fields(situation, contents_of_a_log()));
  EXPECT_EQ(json.at("time_s"), 0.5);
  EXPECT_EQ(json.at("work_offset"), "G55");
  EXPECT_EQ(json.at("terms").at("work_offset"),
            nlohmann::ordered_json::parse(R"({"A1": 0.0, "A2": 7.5})"));
  EXPECT_TRUE(json.at("terms").at("overhang_axis").is_null());
  EXPECT_EQ(json.at("terms").at("plane_turn").size(), 3U);
  EXPECT_EQ(json.at("length").at("row"), "unknown") << "of a damaged log";
}

}  // namespace
}  // namespace stanok::jobs
