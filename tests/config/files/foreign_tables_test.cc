#include "config/files/foreign_tables.h"

#include <gtest/gtest.h>

#include "config/files/tables_file.h"
#include "config/text/config_error.h"

namespace stanok::config {
namespace {

std::string faults_of(const std::string& text) {
  try {
    static_cast<void>(read_tables_text(text, "machines/tool.tbl", {"X"}));
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "";
}

TEST(ForeignTables, AreCalledWhatTheyAre) {
  EXPECT_EQ(faults_of("; mill\r\n\r\n  T1 P1 Z+5 D6 ;end mill\n"),
            "machines/tool.tbl:3:1: this is a LinuxCNC tool table, not a tables file; run `stanok "
            "tool import tool.tbl --output tables.toml` and name tables.toml here");
  EXPECT_NE(faults_of("{\"data\":[]}").find(":1:1: this is a tool library in JSON"),
            std::string::npos);
  EXPECT_NE(faults_of("PK\x03\x04").find("this is a tool library of Fusion"), std::string::npos);
}

TEST(ForeignTables, AreNotSuspectedInTheTextOfATablesFile) {
  for (const char* text : {"", "# T1 P1\n[[tool]]\nnumber = 1\n", "T1 = 5\n", "T1.P1 = 5\n",
                           "T = 1", "T1 P1", "T1 =5\n"}) {
    const std::string line = text;
    const bool is_table = line == "T1 P1";
    EXPECT_EQ(foreign_tables_in(line).has_value(), is_table) << line;
  }
}

TEST(ToolsText, HasToolsWithoutTheAxesOfAMachine) {
  const auto tools =
      read_tools_text("[[tool]]\nnumber = 4\nradius = 3\n[offset.G54]\nW7 = 1\n", "tables.toml");
  ASSERT_EQ(tools.size(), 1U);
  EXPECT_EQ(tools[0].radius, 3.0);
  EXPECT_THROW(static_cast<void>(read_tools_text("[[tool]]\nnumber = 0\n", "tables.toml")),
               ConfigError);
}

}  // namespace
}  // namespace stanok::config
