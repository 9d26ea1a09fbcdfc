#include "jobs/tools/linuxcnc_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "config/text/config_error.h"

namespace stanok::jobs {
namespace {

ForeignTools read(const std::string& text, std::optional<LengthUnit> unit = LengthUnit::mm) {
  return read_linuxcnc_table(
      {.file = "tool.tbl", .bytes = text, .unit = unit, .cutter = {}, .other_file = {}});
}

std::string faults_of(const std::string& text) {
  try {
    static_cast<void>(read(text));
  } catch (const config::ConfigError& error) {
    return error.what();
  }
  return "";
}

TEST(LinuxCncTable, HasLengthsDiameterAndComment) {
  const auto tools = read("T3 P3 X-1.5 Y2 Z+77.125 D+6.0 I93 J35 Q2 ; end mill ; 6 mm \n").tools;
  ASSERT_EQ(tools.size(), 1U);
  const channels::ToolEdge& tool = tools[0].edge;
  EXPECT_EQ(tool.number, 3);
  EXPECT_EQ(tool.length_x, -1.5);
  EXPECT_EQ(tool.length_y, 2.0);
  EXPECT_EQ(tool.length, 77.125);
  EXPECT_EQ(tool.radius, 3.0);
  EXPECT_EQ(tool.angle_front, 93.0);
  EXPECT_EQ(tool.angle_back, 35.0);
  EXPECT_EQ(tool.orientation, 2);
  EXPECT_EQ(tool.kind, "insert");
  EXPECT_EQ(tool.name, "end mill ; 6 mm");
}

// What the file leaves out does not become a zero of the tables.
TEST(LinuxCncTable, GivesOnlyWhatItSays) {
  EXPECT_THAT(read("T3 P3 Z+77.125\n").tools[0].given, ::testing::ElementsAre("length"));
}

// 0.511 inch are 12.9794 mm, 0.125 inch 3.175 mm: exact by the definition of the inch.
TEST(LinuxCncTable, IsInTheUnitOfTheMachine) {
  const channels::ToolEdge tool = read("T1 P1 Z+0.511 D+0.125\n", LengthUnit::inch).tools[0].edge;
  EXPECT_EQ(tool.length, 12.9794);
  EXPECT_EQ(tool.radius, 3.175 / 2.0);
  EXPECT_TRUE(read("T1 P1 Z1\n", LengthUnit::inch).remarks.empty());
  EXPECT_EQ(read("T1 P1 Z1\n", std::nullopt).remarks.size(), 1U);
}

TEST(LinuxCncTable, NamesWhatTheTablesDoNotHave) {
  const auto lost = read("T1 P1 Z1\nT2 P9 Z1 A3 U0 W-0.5\nT99999 P99999 Z0.1\n").not_carried;
  ASSERT_EQ(lost.size(), 4U);
  EXPECT_EQ(lost[0].field + lost[0].value, "P9");
  EXPECT_EQ(lost[1].field + lost[1].value, "A3");
  EXPECT_EQ(lost[2].field + lost[2].value, "W-0.5");
  EXPECT_EQ(lost[3].tool, 99999);
}

TEST(LinuxCncTable, IsRefusedWithAllItsFaults) {
  EXPECT_EQ(faults_of("T1 P1 Z5 D-3\n"),
            "tool.tbl:1:10: radius of tool 1 is -1.5 mm; it must be 0 or more; check the value and "
            "its unit");
  EXPECT_EQ(faults_of(";comment\nT1 P1 Znan\nP2 Z1\nT1 P1\nT2 Z1 Z2\nT1.5 Z1\n"),
            "tool.tbl:2:7: 'Znan' has no number behind Z; write one, as in Z1.5\n"
            "tool.tbl:3:1: no T word; each line begins with the number of its tool, as in T3 P3 D6 "
            "Z77.1 ;end mill\n"
            "tool.tbl:4:1: tool 1 appears twice; give each tool a number of its own in the program "
            "that wrote the file\n"
            "tool.tbl:5:7: a second Z in this line; leave the one that is meant\n"
            "tool.tbl:6:1: T1.5 is not the number of a tool; write a whole number");
  EXPECT_EQ(faults_of("T1 P1 Q1.5\n"),
            "tool.tbl:1:7: orientation of tool 1 is 1.5; it must be 0 to 9; check the value and "
            "its unit");
  EXPECT_EQ(faults_of("T1 P1 Z1 ;ok\nT2 P2 ;\xE9\n"),
            "tool.tbl:2:8: not UTF-8; save the file as UTF-8");
  EXPECT_EQ(faults_of("; nothing\n"),
            "tool.tbl: no tool that can be carried; check the file and --format");
}

}  // namespace
}  // namespace stanok::jobs
