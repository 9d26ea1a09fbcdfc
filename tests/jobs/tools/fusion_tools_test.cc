#include "jobs/tools/fusion_tools.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jobs/tools/zip_members.h"
#include "tests/jobs/tools/fault_of_library.h"

namespace stanok::jobs {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::string library(const std::string& tools) {
  return "{\"data\":[" + tools + "],\"version\":7}";
}

TEST(FusionTools, HaveGeometryInTheirUnit) {
  const ForeignTools found = read_as("fusion", library(R"({"type":"bull nose end mill",
    "unit":"inches","description":"1/2 R1/16","geometry":{"DC":0.5,"RE":0.0625,"LCF":1,"SFDM":0.5,
    "LB":1.5,"assemblyGaugeLength":4,"NOF":0},"post-process":{"number":3,"length-offset":3},
    "holder":{"unit":"millimeters","segments":[{"height":40,"lower-diameter":32,"upper-diameter":32},
    {"height":20.5,"lower-diameter":32,"upper-diameter":32}]}})"));
  const channels::ToolEdge& tool = found.tools.at(0).edge;
  EXPECT_EQ(tool.number, 3);
  EXPECT_EQ(tool.kind, "bull");
  EXPECT_EQ(tool.name, "1/2 R1/16");
  EXPECT_EQ(tool.radius, 6.35);
  EXPECT_EQ(tool.corner_radius, 1.5875);
  EXPECT_EQ(tool.flute_length, 25.4);
  EXPECT_EQ(tool.shank_diameter, 12.7);
  EXPECT_EQ(tool.overhang, 38.1);
  EXPECT_EQ(tool.length, 101.6);
  EXPECT_EQ(tool.holder_diameter, 32.0);
  EXPECT_EQ(tool.holder_length, 60.5);
  EXPECT_TRUE(found.not_carried.empty()) << found.not_carried[0].field;
}

TEST(FusionTools, OfConesHaveTheRadiusOfTheTip) {
  const ForeignTools chamfer =
      read_as("fusion", library(R"({"type":"chamfer mill","unit":"millimeters",
    "geometry":{"DC":10,"tip-diameter":0.5,"TA":45},"post-process":{"number":1}})"));
  EXPECT_EQ(chamfer.tools.at(0).edge.radius, 0.25);
  EXPECT_EQ(chamfer.tools.at(0).edge.taper_angle, 45.0);
  EXPECT_THAT(lost_in(chamfer), ElementsAre("tool 1 type chamfer mill", "tool 1 DC 10"));
  const ForeignTools tapered = read_as("fusion", library(R"({"type":"tapered mill",
    "geometry":{"DC":2,"RE":1,"tip-diameter":0,"TA":5},"post-process":{"number":1}})"));
  EXPECT_EQ(tapered.tools.at(0).edge.radius, 1.0);
}

TEST(FusionTools, NameWhatTheTablesDoNotHave) {
  const ForeignTools found = read_as("fusion", library(R"({"type":"flat end mill","vendor":"shop",
    "geometry":{"DC":6,"NOF":3,"CSP":false},"post-process":{"number":2,"diameter-offset":12,"turret":0},
    "holder":{"vendor":"x","segments":[{"height":40,"lower-diameter":30,"upper-diameter":32}]},
    "start-values":{"presets":[{"n":1}]}}, {"type":"holder","description":"spare"})"));
  EXPECT_THAT(lost_in(found), ElementsAre("tool 2 NOF 3", "tool 2 holder.segments 1 entry",
                                          "tool 2 holder.vendor x", "tool 2 diameter-offset 12",
                                          "tool 2 vendor shop", "tool 2 start-values 1 member",
                                          "tool 0 data[1] spare"));
}

TEST(FusionTools, AreRefusedWithTheirFaults) {
  EXPECT_THAT(fault_as("fusion", library(R"({"geometry":{"DC":6}})")),
              HasSubstr("data[0].post-process.number: the tool has no whole number"));
  EXPECT_THAT(fault_as("fusion", library(R"({"unit":"cubits","post-process":{"number":1}})")),
              HasSubstr("data[0].unit: is 'cubits'; it must be millimeters or inches"));
  EXPECT_THAT(fault_as("fusion", library(R"({"geometry":{"DC":"6"},"post-process":{"number":1}})")),
              HasSubstr("data[0].geometry.DC: is 6; it must be a number"));
  const std::string one = R"({"geometry":{"DC":6},"post-process":{"number":1}})";
  EXPECT_THAT(fault_as("fusion", library(one + "," + one)), HasSubstr("tool 1 appears twice"));
  EXPECT_THAT(fault_as("fusion", "[]"), HasSubstr("must be an object"));
  EXPECT_THAT(fault_as("fusion", "{\"data\":[\n  {]"),
              HasSubstr("library:2:4: not valid JSON here"));
}

TEST(FusionTools, ArePackedInAZipFile) {
  const std::string text = library(R"({"geometry":{"DC":6},"post-process":{"number":1}})");
  const std::string packed = zip_of({"tools.json", text});
  EXPECT_EQ(packed, zip_of({"tools.json", text})) << "equal libraries give equal files";
  EXPECT_EQ(read_as("fusion", packed).tools.at(0).edge.radius, 3.0);
  const auto members = zip_members(packed, ".json");
  ASSERT_TRUE(members);
  ASSERT_EQ(members->size(), 1U);
  EXPECT_EQ((*members)[0].bytes, text);
  EXPECT_THAT(fault_as("fusion", zip_of({"readme.txt", text})), HasSubstr("no .json in this ZIP"));
}

// 80 MiB of blanks take some 80 kB in a ZIP file.
TEST(FusionTools, AreRefusedWithThePlaceInTheirMember) {
  EXPECT_THAT(fault_as("fusion", zip_of({"tools.json", "{\n x"})),
              HasSubstr("library/tools.json:2:2: not valid JSON here"));
}

TEST(FusionTools, ThatUnpackToTooMuchAreRefused) {
  const std::string packed = zip_of({"tools.json", std::string(80UL << 20, ' ')});
  EXPECT_LT(packed.size(), 1UL << 20);
  EXPECT_THAT(fault_as("fusion", packed), HasSubstr("unpacks to more than 64 MiB"));
}

TEST(FusionTools, ThatAreCutOffAreRefused) {
  const std::string packed =
      zip_of({"tools.json", library(R"({"geometry":{"DC":6},"post-process":{"number":1}})")});
  for (std::size_t length = 4; length < packed.size(); ++length) {
    EXPECT_THAT(fault_as("fusion", packed.substr(0, length)), HasSubstr("library: ")) << length;
  }
}

}  // namespace
}  // namespace stanok::jobs
