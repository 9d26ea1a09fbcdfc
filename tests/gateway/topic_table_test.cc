// The table of topics in the documentation is that of the code.
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>

#include "gateway/cell/topics.h"
#include "tests/support/project_folders.h"

namespace stanok::testing {
namespace {

using gateway::Topic;
using gateway::TopicKind;

std::string row_of(const Topic& topic) {
  const bool is_event = topic.kind == TopicKind::event;
  return "| `" + std::string(topic.name) + "` | " +
         (is_event ? "event | no | 1" : "state | yes | 0") + " | " + std::string(topic.sent) +
         " | " + std::string(topic.members) + " |\n";
}

std::string text_of_document() {
  std::ifstream file(source_folder() + "/docs/integrator/cell.md");
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

TEST(TopicTable, IsThatOfTheDocument) {
  std::string wanted;
  for (const Topic& topic : gateway::topics) wanted += row_of(topic);
  const std::string document = text_of_document();
  const std::string opening = "|---|---|---|---|---|---|\n";
  const std::size_t begin = document.find(opening, document.find("<!-- topics:")) + opening.size();
  const std::size_t end = document.find("\n<!-- end of topics -->");
  ASSERT_LT(begin, end);
  EXPECT_EQ(document.substr(begin, end - begin), wanted);
}

TEST(Topics, BelongToTheMachineOrToTheGateway) {
  EXPECT_EQ(gateway::topic_of("hall/2", "mill", "state"), "hall/2/mill/state");
  EXPECT_EQ(gateway::topic_of("hall/2", "", "gateway"), "hall/2/gateway");
  EXPECT_EQ(gateway::event_topic_of("hall", "mill", "alarm"), "hall/mill/event/alarm");
  EXPECT_EQ(gateway::event_topic_of("hall", "", "lost"), "hall/gateway/event/lost");
}

TEST(Topics, ANameIsOneLevelWithoutWildcards) {
  for (const char* name : {"mill", "mill 3", "Фреза"}) EXPECT_TRUE(gateway::is_level(name)) << name;
  for (const char* name : {"", "a/b", "+", "mill#"}) EXPECT_FALSE(gateway::is_level(name)) << name;
}

}  // namespace
}  // namespace stanok::testing
