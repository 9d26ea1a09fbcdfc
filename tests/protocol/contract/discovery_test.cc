// The table as documents: complete, and the same as the one printed in docs/reference/protocol.md.
// After a change of the table write it there anew with
//   STANOK_WRITE_DOCS=1 build/dev/tests/protocol_tests --gtest_filter='Discovery.*'
// which writes panel/openrpc.json, too: the typed client of the panel is made from it.
#include "protocol/contract/discovery.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "protocol/contract/method_table.h"
#include "tests/support/project_folders.h"

namespace stanok::protocol {
namespace {

std::string file_text(const std::string& path) {
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

TEST(Discovery, ListsEveryMethodWithRoleAndParameters) {
  const auto document = discovery_document("1.2.3");
  EXPECT_EQ(document["info"]["version"], "1.2.3");
  ASSERT_EQ(document["methods"].size(), methods().size());
  for (std::size_t i = 0; i < methods().size(); ++i) {
    EXPECT_EQ(document["methods"][i]["name"], methods()[i].name);
    EXPECT_EQ(document["methods"][i]["x-role"], role_name(methods()[i].role));
    EXPECT_EQ(document["methods"][i]["params"].size(), methods()[i].parameters.size());
    const auto& schema = document["methods"][i]["result"]["schema"];
    EXPECT_EQ(schema["type"], "object") << methods()[i].name;
    EXPECT_EQ(schema.dump().find("\"$"), std::string::npos) << "a shape that there is not";
  }
}

// All that stands between its two marks is the table, and nothing else of an older one.
TEST(Discovery, IsWhatTheManualPrints) {
  const std::string path = stanok::testing::source_folder() + "/docs/reference/protocol.md";
  const std::string begin_mark =
      "<!-- methods: written by a test, see tests/protocol/contract/discovery_test.cc -->\n";
  const std::string end_mark = "<!-- end of methods -->";
  const std::string wanted = "\n" + methods_markdown() + "\n";
  std::string manual = file_text(path);
  const std::size_t begin = manual.find(begin_mark) + begin_mark.size();
  const std::size_t end = manual.find(end_mark);
  ASSERT_NE(manual.find(begin_mark), std::string::npos);
  ASSERT_LE(begin, end);
  ASSERT_NE(end, std::string::npos);
  if (std::getenv("STANOK_WRITE_DOCS") != nullptr) {
    std::ofstream(path) << manual.substr(0, begin) + wanted + manual.substr(end);
    manual = file_text(path);
  }
  EXPECT_EQ(manual.substr(begin, manual.find(end_mark) - begin), wanted)
      << "docs/reference/protocol.md: write the table anew as described in this file";
}

// The page is compiled against this document; the version of the daemon is not part of it.
TEST(Discovery, IsWhatThePanelIsCompiledAgainst) {
  const std::string path = stanok::testing::source_folder() + "/panel/openrpc.json";
  const std::string wanted = discovery_document("").dump(1) + "\n";
  if (std::getenv("STANOK_WRITE_DOCS") != nullptr) std::ofstream(path) << wanted;
  EXPECT_TRUE(file_text(path) == wanted)
      << "panel/openrpc.json: write it anew as described in this file, then: cd panel && npm ci && "
         "npm run generate && npm run check && npm run build";
}

}  // namespace
}  // namespace stanok::protocol
