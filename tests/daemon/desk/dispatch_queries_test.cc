// Dispatch: what it tells of a machine that it only looks at.
#include "tests/daemon/desk/dispatch_fixture.h"

namespace stanok::daemon {
namespace {

using nlohmann::json;

TEST_F(DispatchTest, TellsWhatWasLostOnItsWayToPeople) {
  const json status = result("machine.status");
  EXPECT_EQ(status["replies_lost"], 2);
  EXPECT_TRUE(status["log_lines_lost"].is_number_unsigned());
}

TEST_F(DispatchTest, TellsWhatIsKeptOfLogsAndWithinWhichBounds) {
  const json kept = result("log.status")["kept"];
  EXPECT_EQ(kept["files"], 7);
  EXPECT_EQ(kept["bytes"], 70);
  EXPECT_EQ(kept["bytes_max"], 1000);
  EXPECT_EQ(kept["hours_max"], 48);
  EXPECT_EQ(kept["free_bytes"], 5000);
  EXPECT_TRUE(kept["free_bytes_min"].is_null()) << "no bound";
}

TEST_F(DispatchTest, ShowsAChannelWithTheWordsOfOpc) {
  struct Case {
    channels::ChannelState state;
    bool waiting;
    const char* state_word;
    const char* program_word;
  };
  using channels::ChannelState;
  for (const Case& c : {Case{ChannelState::idle, false, "Reset", "Stopped"},
                        Case{ChannelState::ready, false, "Reset", "Stopped"},
                        Case{ChannelState::running, false, "Active", "Running"},
                        Case{ChannelState::running, true, "Active", "Waiting"},
                        Case{ChannelState::held, false, "Interrupted", "Interrupted"},
                        Case{ChannelState::alarm, false, "Interrupted", "Canceled"}}) {
    machine.output.channels[0].state = c.state;
    machine.output.channels[0].waiting = c.waiting;
    const json status = result("channel.status");
    EXPECT_EQ(status["state"], c.state_word);
    EXPECT_EQ(status["program_status"], c.program_word);
  }
  machine.output.channels[0].point_W[0].value = 12.5;
  machine.output.channels[0].axes[0].position = -3.25;
  machine.output.channels[0].feed_override = 0.75;
  const json status = result("channel.status", {{"channel", 1}});
  EXPECT_EQ(status["position"], json({{"X", 12.5}, {"B", 0.0}}));
  EXPECT_EQ(status["axes"]["X2"]["position"], -3.25);
  EXPECT_EQ(status["override"]["feed"], 75.0);
  for (const char* member :
       {"id", "name", "state", "program_status", "alarm", "program", "line", "block", "scheme",
        "position", "feed_mm_s", "override", "remaining_s"}) {
    EXPECT_TRUE(status.contains(member)) << member;
  }
}

TEST_F(DispatchTest, ShowsSchemesAndTheirAxes) {
  const json list = result("kinematics.list");
  ASSERT_EQ(list["schemes"].size(), 2U);
  EXPECT_EQ(list["schemes"][0]["active"], true);
  EXPECT_EQ(list["schemes"][1]["axes"], json::array({"X", "B"}));
  const json active = result("kinematics.status");
  EXPECT_EQ(active["scheme"], 1);
  EXPECT_EQ(active["axes"][0]["takes_part"], true);
  EXPECT_EQ(active["axes"][1]["takes_part"], false);
}

TEST_F(DispatchTest, ShowsTheCuttingProcess) {
  channels::ChannelOutput& channel = machine.output.channels[0];
  channel.running = true;
  channel.process.law = motion::LawKind::modulated;
  channel.process.increments = 12;
  channel.process.feed_mm_per_min = 150.0;
  channel.process.feed_mm_per_rev = 0.25;
  channel.process.spindle_rev_per_min = 600.0;
  channel.process.cutting_speed_m_per_min = 94.2;
  const json process = result("process.status");
  EXPECT_EQ(process["law"], "modulated");
  EXPECT_EQ(process["increments"], 12);
  EXPECT_EQ(process["feed_mm_min"], 150.0);
  EXPECT_EQ(process["feed_mm_rev"], 0.25);
  EXPECT_EQ(process["spindle_rev_min"], 600.0);
  channel.running = false;
  EXPECT_TRUE(result("process.status")["law"].is_null());
}

TEST_F(DispatchTest, ShowsOneToolAndSaysWhichThereIsNot) {
  EXPECT_EQ(result("tool.get", {{"number", 32000}})["length"], 77.5);
  EXPECT_EQ(failure("tool.get", {{"number", 5}}).code, "E5021");
  EXPECT_EQ(failure("tool.get", {{"number", 32000}, {"edge", 2}}).code, "E5021");
}

TEST_F(DispatchTest, AllowsWorkpiecesAndShowsThem) {
  EXPECT_EQ(result("workpiece.status"), json({{"allowed", false}, {"workpieces", json::array()}}));
  EXPECT_EQ(result("workpiece.allow"), json({{"allowed", true}}));
  machine.change([](FakeMachine& changed) {
    channels::Workpiece& workpiece = changed.output.channels[0].workpiece;
    workpiece.announcements = 1;
    workpiece.has_shape = true;
    workpiece.shape.size_mm = {80.0, 60.0, 20.0};
  });
  const json status = result("workpiece.status");
  EXPECT_TRUE(status["allowed"]);
  ASSERT_EQ(status["workpieces"].size(), 1U);
  EXPECT_EQ(status["workpieces"][0]["shape"], "box");
  EXPECT_EQ(status["workpieces"][0]["size"], json({80.0, 60.0, 20.0}));
  EXPECT_EQ(result("workpiece.allow", {{"on", 0}}), json({{"allowed", false}}));
}

}  // namespace
}  // namespace stanok::daemon
