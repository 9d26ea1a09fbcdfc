#include "jobs/tools/offset_listing.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jobs/tools/tool_conversion.h"
#include "tests/jobs/tools/fault_of_library.h"

namespace stanok::jobs {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

const std::string listing =
    "%\nO9501 (OFFSETS)\nG21 G90\nN10 G10 L10 P4 R92.4 (DRILL 8.5)\nG10L11P4R-.02\n"
    "G10 L12 P4 R8.5\nG10 L13 P4 R0\nM30\n%\n";

TEST(OffsetListing, HasLengthRadiusAndTheirWear) {
  const ForeignTools found = read_as("fanuc", listing, {}, CutterSize::radius);
  const channels::ToolEdge& tool = found.tools.at(0).edge;
  EXPECT_EQ(tool.number, 4);
  EXPECT_EQ(tool.name, "DRILL 8.5");
  EXPECT_EQ(tool.length, 92.4);
  EXPECT_EQ(tool.wear_length, -0.02);
  EXPECT_EQ(tool.radius, 8.5);
  EXPECT_EQ(tool.wear_radius, 0.0);
  EXPECT_TRUE(found.remarks.empty());
}

TEST(OffsetListing, HasRadiiOnFanucAndDiametersOnHaas) {
  EXPECT_EQ(read_as("fanuc", listing).tools.at(0).edge.radius, 8.5);
  EXPECT_EQ(read_as("haas", listing).tools.at(0).edge.radius, 4.25);
  EXPECT_EQ(read_as("haas", listing, {}, CutterSize::radius).tools.at(0).edge.radius, 8.5);
  EXPECT_THAT(read_as("haas", listing).remarks, ElementsAre(HasSubstr("taken as diameters")));
}

TEST(OffsetListing, IsInTheUnitThatItStates) {
  EXPECT_EQ(read_as("fanuc", "G20\nG10 L10 P1 R1.\n", LengthUnit::mm).tools.at(0).edge.length,
            25.4);
  EXPECT_EQ(read_as("fanuc", "G10 L10 P1 R1.\n", LengthUnit::inch).tools.at(0).edge.length, 25.4);
  EXPECT_EQ(read_as("fanuc", "G10 L10 P1 R1.\n").tools.at(0).edge.length, 1.0);
}

TEST(OffsetListing, NamesOffsetsThatAreNotOfTools) {
  const ForeignTools found = read_as("fanuc", "G10 L2 P1 X-350. Y2.\nG10 L10 P7 R81.25\n");
  EXPECT_THAT(lost_in(found), ElementsAre("tool 0 G10 L2 P1 X-350. Y2. "));
}

TEST(OffsetListing, IsRefusedWithThePlaceOfItsFault) {
  EXPECT_EQ(fault_as("fanuc", "%\nG10 L10 P1 R77125\n"),
            "library:2:12: R77125 is not a number with a decimal point; write it with one, as in "
            "R77.125 or R6.");
  EXPECT_THAT(fault_as("fanuc", "G91\nG10 L10 P1 R1.\n"), HasSubstr("library:1:1: G91: values"));
  EXPECT_THAT(fault_as("fanuc", "G10 L10 P1 R1.\nG10 L10 P1 R2.\n"),
              HasSubstr("library:2:9: L10 P1 appears twice"));
  EXPECT_THAT(fault_as("fanuc", "G1 X5. F100\n"),
              HasSubstr("library:1:4: X5. is not part of an offset listing"));
  EXPECT_THAT(fault_as("fanuc", "G10 L10 R5.\n"), HasSubstr("library:1:5: G10 without the number"));
  EXPECT_THAT(fault_as("fanuc", "G10 L10 P1 R#500\n"), HasSubstr("library:1:13: '#500' is not"));
}

TEST(OffsetListing, IsRoundedToTheDecimalsOfAControl) {
  std::vector<channels::ToolEdge> tools(1);
  tools[0].number = 1;
  tools[0].name = "tool (long)";
  tools[0].length = 77.12345;
  tools[0].wear_length = -0.0001;
  const ExportedTools exported =
      export_tools({.tools = tools,
                    .format = tool_format_named("fanuc"),
                    .choice = {.file = "offsets.txt", .unit = LengthUnit::mm, .cutter = {}}});
  EXPECT_EQ(exported.files.at(0).bytes,
            "%\nO9999 (TOOL OFFSETS, MM, CUTTER RADIUS)\nG21\nG90\n"
            "G10 L10 P1 R77.123 (tool [long])\nG10 L11 P1 R0.000\nG10 L12 P1 R0.000\n"
            "G10 L13 P1 R0.000\nM30\n%\n");
  std::vector<std::string> lost;
  for (const NotCarried& one : exported.not_carried) lost.push_back(one.field + " " + one.reason);
  EXPECT_THAT(lost, ElementsAre("name written as tool [long]", "length written as 77.123",
                                "wear_length the format does not have it"));
}

}  // namespace
}  // namespace stanok::jobs
