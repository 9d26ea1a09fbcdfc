// The rows of formats, and their table in docs/operator/tool-libraries.md:
//   STANOK_WRITE_DOCS=1 build/release/tests/jobs_tests --gtest_filter='ToolFormatsDocument.*'
#include "jobs/tools/tool_formats.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <set>
#include <string>

#include "jobs/tools/tool_values.h"
#include "tests/support/project_folders.h"

namespace stanok::jobs {
namespace {

TEST(ToolFormats, AreFoundByNameAndByTheEndOfAFile) {
  for (const ToolFormat& format : tool_formats()) {
    EXPECT_EQ(tool_format_named(format.name), &format);
    EXPECT_NE(format.read, nullptr) << format.name;
  }
  EXPECT_EQ(tool_format_named("nonsense"), nullptr);
  EXPECT_EQ(tool_format_of("folder.tbl/tools"), nullptr);
  EXPECT_EQ(tool_format_of("MILL.TBL"), tool_format_named("linuxcnc"));
}

TEST(ToolFormats, CarryKeysOfTheTablesFile) {
  const auto& keys = config::tool_keys();
  for (const ToolFormat& format : tool_formats()) {
    std::set<std::string_view> seen;
    for (const CarriedKey& carried : format.carried) {
      EXPECT_NE(std::ranges::find(keys, carried.key, &ToolKey::name), keys.end()) << carried.key;
      EXPECT_TRUE(seen.insert(carried.key).second) << format.name << ": " << carried.key;
    }
    for (const std::string_view kind : format.kinds) {
      const auto& kinds = tool_key("kind").allowed.names;
      EXPECT_NE(std::ranges::find(kinds, kind), kinds.end()) << kind;
    }
  }
}

TEST(ToolFormatsDocument, IsTheTableOfTheManual) {
  const std::string path = testing::source_folder() + "/docs/operator/tool-libraries.md";
  const std::string begin_mark =
      "<!-- formats: written by a test, see tests/jobs/tools/tool_formats_test.cc -->\n";
  const std::string end_mark = "<!-- end of formats -->";
  const std::string wanted = "\n" + table_of_tool_formats() + "\n";
  std::ifstream file(path);
  const std::string manual(std::istreambuf_iterator<char>(file), {});
  ASSERT_NE(manual.find(begin_mark), std::string::npos);
  const std::size_t begin = manual.find(begin_mark) + begin_mark.size();
  const std::size_t end = manual.find(end_mark);
  ASSERT_NE(end, std::string::npos);
  if (std::getenv("STANOK_WRITE_DOCS") != nullptr) {
    std::ofstream(path) << manual.substr(0, begin) + wanted + manual.substr(end);
    return;
  }
  EXPECT_EQ(manual.substr(begin, end - begin), wanted)
      << "docs/operator/tool-libraries.md: write the table again as described in this file";
}

}  // namespace
}  // namespace stanok::jobs
