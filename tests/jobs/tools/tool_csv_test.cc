#include "jobs/tools/tool_csv.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/jobs/tools/fault_of_library.h"

namespace stanok::jobs {
namespace {

using ::testing::ElementsAre;

TEST(ToolCsv, HasKeysOfTheTablesFileAsHeadings) {
  const ForeignTools found = read_as("csv",
                                     "Number,edge,name,diameter_inch,length_mm,kind\r\n4,2,\"drill,"
                                     " \"\"8.5\"\"\",0.25,92.4,Drill\r\n");
  ASSERT_EQ(found.tools.size(), 1U);
  const channels::ToolEdge& tool = found.tools[0].edge;
  EXPECT_EQ(tool.number, 4);
  EXPECT_EQ(tool.edge, 2);
  EXPECT_EQ(tool.name, "drill, \"8.5\"");
  EXPECT_EQ(tool.radius, 3.175);  // an inch is 25.4 mm
  EXPECT_EQ(tool.length, 92.4);
  EXPECT_EQ(tool.kind, "drill");
  EXPECT_TRUE(found.remarks.empty());
}

TEST(ToolCsv, MayHaveSemicolonsAndDecimalCommas) {
  const auto tools =
      read_as("csv", "\xEF\xBB\xBFnumber;length;name\n1;77,125;M\xC3\xBCller\n").tools;
  EXPECT_EQ(tools.at(0).edge.length, 77.125);
  EXPECT_EQ(tools.at(0).edge.name, "M\xC3\xBCller");
}

TEST(ToolCsv, GivesNoValueInAnEmptyCell) {
  const auto tools = read_as("csv", "number,length_mm,radius_mm\n1,,3\n\n,,\n").tools;
  ASSERT_EQ(tools.size(), 1U);
  EXPECT_THAT(tools[0].given, ElementsAre("radius"));
}

TEST(ToolCsv, NamesColumnsThatTheTablesDoNotHave) {
  EXPECT_THAT(lost_in(read_as("csv", "number,supplier,name_mm,radius_mm\n1,shop,,3\n2,,x,1\n")),
              ElementsAre("tool 1 supplier shop", "tool 2 name_mm x"));
}

TEST(ToolCsv, IsRefusedWithThePlaceOfItsFault) {
  EXPECT_EQ(fault_as("csv", "name,length\nx,1\n"),
            "library:1:1: the first row has no heading 'number'; it names keys of the tables file, "
            "as in number,name,length_mm,radius_mm");
  EXPECT_EQ(fault_as("csv", "number,length_mm\n1,ten\n2.5,1\n,3\n1,2\n"),
            "library:2:3: 'ten' is not a number (length_mm); write one, as in 6.35\n"
            "library:3:1: '2.5' is not the number of a tool; write a whole number\n"
            "library:4:1: no number of a tool in this row\n"
            "library:5:1: tool 1 appears twice; give each tool a number of its own in the program "
            "that wrote the file");
  EXPECT_EQ(fault_as("csv", "number,name\n1,\"open\n"),
            "library:2:3: a quote that is not closed; write a quote within quotes twice");
  EXPECT_EQ(fault_as("csv", "number,kind\n1,mill,2\n"),
            "library:2:3: there is no kind 'mill'; write one of flat, ball, bull, drill, taper, "
            "insert, probe\n"
            "library:2:8: more cells than headings; a text with a comma needs quotes");
}

TEST(FusionCsv, HasARowForEachPreset) {
  const std::string text =
      "\"Tool Index (tool_index)\",\"Preset Name (preset_name)\",\"Type (tool_type)\",\"Diameter "
      "(tool_diameter)\",\"Number (tool_number)\",\"Unit (tool_unit)\",\"Vendor (tool_vendor)\"\r\n"
      "1,steel,drill,0.25,7,inches,shop\r\n1,brass,drill,0.25,7,inches,shop\r\n";
  const ForeignTools found = read_as("fusion-csv", text);
  ASSERT_EQ(found.tools.size(), 1U);
  EXPECT_EQ(found.tools[0].edge.number, 7);
  EXPECT_EQ(found.tools[0].edge.kind, "drill");
  EXPECT_EQ(found.tools[0].edge.radius, 3.175);
  EXPECT_THAT(lost_in(found), ElementsAre("tool 7 preset_name steel", "tool 7 tool_vendor shop",
                                          "tool 7 preset_name brass"));
  EXPECT_NE(fault_as("fusion-csv", "number,radius\n1,3\n").find("--format csv"), std::string::npos);
}

}  // namespace
}  // namespace stanok::jobs
