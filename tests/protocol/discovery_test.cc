// The table as documents: complete, and the same as the one printed in docs/protocol.md.
#include "protocol/discovery.h"

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "protocol/method_table.h"

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
  }
}

TEST(Discovery, IsWhatTheManualPrints) {
  const std::string wanted = methods_markdown();
  const std::string manual = file_text(STANOK_SOURCE_DIR "/docs/protocol.md");
  const bool is_printed = manual.find(wanted) != std::string::npos;
  const std::string copy = STANOK_BINARY_DIR "/protocol_methods.md";
  if (!is_printed) std::ofstream(copy) << wanted;
  EXPECT_TRUE(is_printed) << "docs/protocol.md is older than the table; its new text is in "
                          << copy;
}

}  // namespace
}  // namespace stanok::protocol
