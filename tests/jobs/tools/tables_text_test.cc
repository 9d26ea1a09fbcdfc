#include "jobs/tools/tables_text.h"

#include <gtest/gtest.h>

#include "config/files/tables_file.h"
#include "config/text/config_error.h"

namespace stanok::jobs {
namespace {

ForeignTool tool(int number, double length, double radius) {
  ForeignTool made;
  made.edge.number = number;
  made.edge.length = length;
  made.edge.radius = radius;
  made.given = {"length", "radius"};
  return made;
}

const std::string tables =
    "# measured in May\n"
    "[[tool]]\n"
    "number = 1  # in the first pocket\n"
    "name = \"Фреза 6\"\n"
    "length = 77.125 # with gauge 3\n"
    "flute_length = 20\n"
    "\n"
    "[[tool]]\n"
    "number = 2\n"
    "\n"
    "# first vice\n"
    "[offset.G54]\n"
    "X = 120.5\n";

TEST(TablesText, OfNewToolsHasOnlyWhatWasGiven) {
  const std::vector<ForeignTool> tools{tool(1, 77.125, 3.0), tool(2, 60.0, 4.25)};
  EXPECT_EQ(tables_text(tools),
            "[[tool]]\nnumber = 1\nlength = 77.125\nradius = 3\n\n"
            "[[tool]]\nnumber = 2\nlength = 60\nradius = 4.25\n");
  EXPECT_EQ(config::read_tools_text(tables_text(tools), "t.toml").size(), 2U);
}

TEST(TablesText, KeepsWhatTheFileHas) {
  const std::vector<ForeignTool> tools{tool(3, 50.0, 2.0)};
  const MergedTables merged = merged_tables(tables, "t.toml", tools, EqualNumbers::refuse);
  EXPECT_EQ(merged.text, tables + "\n[[tool]]\nnumber = 3\nlength = 50\nradius = 2\n");
  EXPECT_EQ(merged.added, 1);
  EXPECT_EQ(merged.replaced, 0);
}

TEST(TablesText, RefusesAToolThatBothHave) {
  const std::vector<ForeignTool> tools{tool(2, 50.0, 2.0), tool(3, 50.0, 2.0)};
  try {
    static_cast<void>(merged_tables(tables, "t.toml", tools, EqualNumbers::refuse));
    FAIL();
  } catch (const config::ConfigError& error) {
    EXPECT_STREQ(error.what(),
                 "t.toml:8:1: tool 2 is also in the imported file; --replace takes its values from "
                 "there");
  }
}

TEST(TablesText, ReplacesValuesInTheirPlace) {
  const std::vector<ForeignTool> tools{tool(1, 80.0, 3.0), tool(2, 50.0, 2.0)};
  const MergedTables merged = merged_tables(tables, "t.toml", tools, EqualNumbers::replace);
  EXPECT_EQ(merged.text,
            "# measured in May\n"
            "[[tool]]\n"
            "radius = 3\n"
            "number = 1  # in the first pocket\n"
            "name = \"Фреза 6\"\n"
            "length = 80 # with gauge 3\n"
            "flute_length = 20\n"
            "\n"
            "[[tool]]\n"
            "length = 50\n"
            "radius = 2\n"
            "number = 2\n"
            "\n"
            "# first vice\n"
            "[offset.G54]\n"
            "X = 120.5\n");
  EXPECT_EQ(merged.replaced, 2);
}

// What `tool load` refuses to change in a running daemon (E9015) is left out.
TEST(TablesText, OfOffsetsHasNoNamesAndShapes) {
  std::vector<ForeignTool> tools{tool(1, 77.125, 3.0)};
  tools[0].given.insert(tools[0].given.end(), {"name", "kind", "flute_length", "holder_diameter"});
  keep_offsets(tools);
  EXPECT_EQ(tables_text(tools), "[[tool]]\nnumber = 1\nlength = 77.125\nradius = 3\n");
}

// Columns of TOML count characters, not bytes.
TEST(TablesText, ReplacesANameThatIsNotAscii) {
  ForeignTool named = tool(1, 0.0, 0.0);
  named.edge.name = "ü \"x\"";
  named.given = {"name"};
  const std::vector<ForeignTool> tools{named};
  const std::string text = "[[tool]]\n\"number\" = 1\nname = \"Фреза Ø6\" # ж\n";
  const MergedTables merged = merged_tables(text, "t.toml", tools, EqualNumbers::replace);
  EXPECT_EQ(config::read_tools_text(merged.text, "t.toml")[0].name, "ü \"x\"");
  EXPECT_TRUE(merged.text.ends_with(" # ж\n")) << merged.text;
}

TEST(TablesText, RefusesWhatItCannotEdit) {
  const std::vector<ForeignTool> tools{tool(2, 50.0, 2.0)};
  const std::string text = "tool = [{number = 1, length = 5}]\n";
  EXPECT_THROW(static_cast<void>(merged_tables(text, "t.toml", tools, EqualNumbers::refuse)),
               config::ConfigError);
}

// Values of the imported file and those that stay must fit together.
TEST(TablesText, RefusesACornerThatBecomesLargerThanItsTool) {
  const std::vector<ForeignTool> tools{tool(1, 50.0, 2.0)};
  const std::string text = "[[tool]]\nnumber = 1\nradius = 5\ncorner_radius = 5\n";
  EXPECT_THROW(static_cast<void>(merged_tables(text, "t.toml", tools, EqualNumbers::replace)),
               config::ConfigError);
}

}  // namespace
}  // namespace stanok::jobs
