// Which messages of Sparkplug B states lead to; payloads are read by a decoder of its own in
// broker_test.py.
#include "gateway/sparkplug/edge_node.h"

#include <gtest/gtest.h>

namespace stanok::testing {
namespace {

using gateway::EdgeNode;
using gateway::SparkplugMessage;
using gateway::StatesOfMachine;
using nlohmann::json;

std::string kinds(const std::vector<SparkplugMessage>& messages) {
  std::string text;
  for (const SparkplugMessage& message : messages) text += message.topic + ";";
  return text;
}

StatesOfMachine states(const json& state, const json& program = json::object()) {
  return {{"state", state}, {"program", program}};
}

class TheNode : public ::testing::Test {
 protected:
  std::string told(const StatesOfMachine& mill) { return kinds(node_.update({{"mill", mill}}, 1)); }
  EdgeNode node_{"works", "gate", 300};
};

TEST_F(TheNode, IsBornAloneAndItsMachinesWhenTheyAreThere) {
  EXPECT_EQ(kinds(node_.births(1)), "spBv1.0/works/NBIRTH/gate;");
  EXPECT_EQ(told(states({{"connected", false}})), "");
  EXPECT_EQ(told(states({{"connected", true}})), "spBv1.0/works/DBIRTH/gate/mill;");
  EXPECT_EQ(kinds(node_.births(1)), "spBv1.0/works/NBIRTH/gate;spBv1.0/works/DBIRTH/gate/mill;");
}

TEST_F(TheNode, TellsWhatHasChanged) {
  static_cast<void>(told(states({{"connected", true}}, {{"line", 1}})));
  EXPECT_EQ(told(states({{"connected", true}}, {{"line", 1}})), "");
  EXPECT_EQ(told(states({{"connected", true}}, {{"line", 2}})), "spBv1.0/works/DDATA/gate/mill;");
  EXPECT_EQ(told(states({{"connected", true}}, json::object())), "spBv1.0/works/DDATA/gate/mill;");
  EXPECT_EQ(told(states({{"connected", true}}, {{"line", nullptr}})), "");
}

TEST_F(TheNode, IsBornAgainForANewMetricAndForAnotherType) {
  static_cast<void>(told(states({{"connected", true}}, {{"line", nullptr}})));
  EXPECT_EQ(told(states({{"connected", true}}, {{"line", 2}})), "spBv1.0/works/DBIRTH/gate/mill;");
  EXPECT_EQ(told(states({{"connected", true}}, {{"line", 2}, {"tool", 3}})),
            "spBv1.0/works/DBIRTH/gate/mill;");
}

TEST_F(TheNode, SaysThatAMachineIsAwayOnce) {
  static_cast<void>(told(states({{"connected", true}})));
  EXPECT_EQ(told(states({{"connected", false}})), "spBv1.0/works/DDEATH/gate/mill;");
  EXPECT_EQ(told(states({{"connected", false}})), "");
  EXPECT_EQ(told(states({{"connected", true}})), "spBv1.0/works/DBIRTH/gate/mill;");
}

TEST_F(TheNode, TakesNothingForARequestThatIsNone) {
  EXPECT_FALSE(EdgeNode::asks_for_births(""));
  EXPECT_FALSE(EdgeNode::asks_for_births("\xff\xff\xff"));
  EXPECT_FALSE(EdgeNode::asks_for_births(node_.births(1)[0].payload));
  EXPECT_EQ(node_.command_topic(), "spBv1.0/works/NCMD/gate");
  EXPECT_EQ(node_.death(1).topic, "spBv1.0/works/NDEATH/gate");
}

}  // namespace
}  // namespace stanok::testing
