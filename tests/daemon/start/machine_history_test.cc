// MachineHistory: what the disk does not take is told to operators.
#include "daemon/start/machine_history.h"

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <thread>

#include "tests/daemon/live_daemon.h"

namespace stanok::daemon {
namespace {

using nlohmann::json;

class MachineHistoryTest : public ::testing::Test {
 protected:
  json ask(const std::string& method, const json& parameters = json::object()) {
    client.request(++last, method, parameters);
    const json answer = client.receive("id", last);
    return answer.contains("result") ? answer["result"] : answer["error"]["data"];
  }

  LiveDaemon daemon;
  RawClient client{daemon.socket()};
  int last = 0;
};

TEST_F(MachineHistoryTest, WhatIsNotKeptIsAnAlarmUntilItIsAcknowledged) {
  RawClient page(daemon.socket());
  page.request(1, "subscribe", {{"topics", {"events"}}});
  page.receive("id", 1);
  std::filesystem::remove_all(daemon.socket().parent_path() / "state");
  const json refused = ask("offset.set", {{"offset", "G54"}, {"axis", "X"}, {"value", 7.5}});
  EXPECT_EQ(refused["code"], "E9025");
  EXPECT_EQ(page.receive("method", "event")["params"]["code"], "W940") << "a page hears of it";
  const json alarms = ask("alarm.list")["alarms"];
  ASSERT_FALSE(alarms.empty());  // of the tables, and of the positions when it is their time
  for (const json& alarm : alarms) {
    EXPECT_EQ(alarm["code"], "W940");
    EXPECT_EQ(alarm["channel"], 1);
    EXPECT_TRUE(alarm["at"].is_number());
  }
  EXPECT_EQ(ask("channel.status", {{"channel", 1}})["state"], "Reset") << "it stops nothing";
  ask("alarm.ack");
  EXPECT_EQ(ask("alarm.list")["alarms"], json::array());
}

}  // namespace
}  // namespace stanok::daemon
