#include "jobs/tools/freecad_tools.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>

#include "jobs/tools/tool_conversion.h"
#include "tests/jobs/tools/fault_of_library.h"

namespace stanok::jobs {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::string bit(const std::string& shape, const std::string& parameters) {
  return R"({"version":2,"name":"bit","shape":")" + shape + R"(.fcstd","parameter":{)" +
         parameters + "}}";
}

channels::ToolEdge tool_of(const std::string& text) {
  return read_as("freecad", text).tools.at(0).edge;
}

TEST(FreeCadBit, HasLengthsWithTheirUnits) {
  const channels::ToolEdge tool = tool_of(bit(
      "bullnose",
      R"("Diameter":"0.5 in","FlatRadius":"1.0000 mm","ShankDiameter":1.2e1,"CuttingEdgeHeight":"2,5 cm")"));
  EXPECT_EQ(tool.kind, "bull");
  EXPECT_EQ(tool.radius, 6.35);
  EXPECT_EQ(tool.corner_radius, 1.0);
  EXPECT_EQ(tool.shank_diameter, 12.0);
  EXPECT_EQ(tool.flute_length, 25.0);
  EXPECT_EQ(tool_of(bit("drill", R"("Diameter":"8 mm","TipAngle":"119.0000 °")")).point_angle,
            119.0);
}

// A V bit has its whole angle and the diameters of both ends; the tables have half of the angle and
// the radius of the tip. 0.2 + 2 * 8 tan 30 = 9.4376.
TEST(FreeCadBit, OfACone) {
  const std::string cone =
      R"("CuttingEdgeAngle":"60 deg","TipDiameter":"0.2 mm","CuttingEdgeHeight":"8 mm")";
  const ForeignTools exact =
      read_as("freecad", bit("v-bit", cone + R"(,"Diameter":"9.437604307 mm")"));
  EXPECT_EQ(exact.tools.at(0).edge.taper_angle, 30.0);
  EXPECT_EQ(exact.tools.at(0).edge.radius, 0.1);
  EXPECT_TRUE(exact.not_carried.empty());
  EXPECT_THAT(lost_in(read_as("freecad", bit("v-bit", cone + R"(,"Diameter":"10 mm")"))),
              ElementsAre("tool 1 Diameter 10"));
}

TEST(FreeCadBit, NamesWhatTheTablesDoNotHave) {
  const std::string text =
      R"({"name":"saw","shape":"slittingsaw.fcstd","parameter":{"Diameter":"63 mm","Length":"20 mm"},)"
      R"("attribute":{"Flutes":20,"Material":""},"extra":[1,2]})";
  EXPECT_THAT(lost_in(read_as("freecad", text)),
              ElementsAre("tool 1 shape slittingsaw.fcstd", "tool 1 Length 20 mm",
                          "tool 1 Flutes 20", "tool 1 extra 2 entries"));
}

TEST(FreeCadLibrary, FindsItsBitsBesideItAndInBit) {
  const std::map<std::string, std::string> files{
      {"library_folder/a.fctb", bit("endmill", R"("Diameter":"6 mm")")},
      {"Bit/b.fctb", bit("drill", R"("Diameter":"5 mm")")}};
  const auto file = [&](const std::filesystem::path& path) -> std::optional<std::string> {
    const auto found = files.find(path.lexically_normal().generic_string());
    return found == files.end() ? std::nullopt : std::optional(found->second);
  };
  const ForeignTools found = read_freecad_tools(
      {.file = "library_folder/tools.fctl",
       .bytes =
           R"({"version":1,"tools":[{"nr":7,"path":"../../etc/a.fctb"},{"nr":3,"path":"b.fctb"}]})",
       .unit = {},
       .cutter = {},
       .other_file = file});
  ASSERT_EQ(found.tools.size(), 2U);
  EXPECT_EQ(found.tools[0].edge.number, 3);
  EXPECT_EQ(found.tools[0].edge.kind, "drill");
  EXPECT_EQ(found.tools[1].edge.radius, 3.0);
}

TEST(FreeCadLibrary, IsRefusedWithItsFaults) {
  EXPECT_THAT(fault_as("freecad", "{\n \"tools\": [nan]}"),
              HasSubstr("library:2:13: not valid JSON here"));
  EXPECT_THAT(fault_as("freecad", R"({"tools":[{"nr":1,"path":"x.fctb"}]})"),
              HasSubstr("tools[0].path: the tool bit x.fctb is neither beside the library"));
  EXPECT_THAT(fault_as("freecad", R"({"tools":[{"nr":1.5,"path":"x.fctb"}]})"),
              HasSubstr("tools[0]: must have a whole number nr"));
  EXPECT_THAT(fault_as("freecad", bit("endmill", R"("Diameter":"6 furlongs")")),
              HasSubstr("parameter.Diameter: is '6 furlongs'; write a number and its unit"));
  EXPECT_THAT(fault_as("freecad", bit("endmill", R"("Diameter":"-6 mm")")),
              HasSubstr("radius of tool 1 is -3 mm; it must be 0 or more"));
  EXPECT_THAT(fault_as("freecad", std::string(100, '[')), HasSubstr("nested deeper than 64"));
  EXPECT_THAT(fault_as("freecad", R"({"parameter":{"Diameter":1e999}})"), HasSubstr("too large"));
}

TEST(FreeCadLibrary, IsRefusedWithThePlaceInItsBit) {
  const auto broken = [](const std::filesystem::path& path) {
    return path.filename() == "b.fctb"
               ? std::optional<std::string>("{\n\n  \"name\": }")
               : std::optional<std::string>(bit("endmill", R"("Diameter":"x")"));
  };
  try {
    static_cast<void>(read_as("freecad",
                              R"({"tools":[{"nr":1,"path":"a.fctb"},{"nr":2,"path":"b.fctb"}]})",
                              {}, {}, broken));
    FAIL();
  } catch (const config::ConfigError& error) {
    EXPECT_STREQ(error.what(),
                 "a.fctb: parameter.Diameter: is 'x'; write a number and its unit, as in \"6.0 "
                 "mm\" or \"0.25 in\"\n"
                 "b.fctb:3:11: not valid JSON here; export the library again, or correct the text");
  }
}

TEST(FreeCadLibrary, IsWrittenWithItsBitsInBit) {
  std::vector<channels::ToolEdge> tools(1);
  tools[0].number = 4;
  tools[0].radius = 3.0;
  const auto files = write_freecad_tools(
      tools, {.file = "Tools/Library/mill.fctl", .unit = LengthUnit::mm, .cutter = {}});
  ASSERT_EQ(files.size(), 2U);
  EXPECT_EQ(files[0].file, "Tools/Bit/mill_T4.fctb");
  EXPECT_EQ(nlohmann::json::parse(files[0].bytes)["parameter"]["Diameter"], "6 mm");
  EXPECT_EQ(nlohmann::json::parse(files[1].bytes)["tools"][0]["path"], "mill_T4.fctb");
  EXPECT_THROW(static_cast<void>(write_freecad_tools(
                   tools, {.file = "one.fctb", .unit = LengthUnit::mm, .cutter = {}})),
               config::ConfigError);
}

}  // namespace
}  // namespace stanok::jobs
