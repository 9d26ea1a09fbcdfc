// Dispatch: roles, parameters, queries, commands and their answers, against a fake machine.
#include <fstream>

#include "tests/daemon/desk/dispatch_fixture.h"

namespace stanok::daemon {
namespace {

using channels::OperatorAction;
using nlohmann::json;
using protocol::Failure;
using protocol::FailureKind;
using protocol::Role;
using namespace std::chrono_literals;

int session_in(const channels::OperatorEvent& event) {
  return std::get<channels::commands::ChannelControl>(event.command).session;
}

// Of two sessions one has channel 1; only stops of the other one pass.
TEST_F(DispatchTest, GivesAChannelToOneSession) {
  session.id = 3;
  session.peer = "uid 1000, pid 77";
  const auto taken = ask("channel.control");
  EXPECT_FALSE(taken->has_value()) << "answered when the cycle knows it";
  EXPECT_EQ(machine.submitted().at(0).action(), OperatorAction::channel_control);
  EXPECT_EQ(session_in(machine.submitted().at(0)), 3);
  dispatch.on_reply(accepted(machine.submitted().at(0).id));
  EXPECT_EQ(taken->value().value()["controlled_by"], "session 3 (uid 1000, pid 77)");
  EXPECT_EQ(result("channel.status")["controlled_by"], "session 3 (uid 1000, pid 77)");
  session.id = 4;
  for (const auto& [method, parameters] :
       std::map<std::string, json>{{"program.run", {{"program", "a.nc"}}},
                                   {"jog", {{"axis", "X"}, {"velocity", 1.0}}},
                                   {"override.feed", {{"percent", 50}}}})
    EXPECT_EQ(failure(method, parameters).code, "E6080") << method;
  EXPECT_EQ(failure("channel.control").code, "E6080");
  EXPECT_EQ(machine.submitted().size(), 1u);
  for (const char* method : {"program.hold", "program.stop", "program.reset", "machine.estop"})
    static_cast<void>(ask(method));
  EXPECT_EQ(machine.submitted().size(), 5u) << "stops are for everybody";
  static_cast<void>(ask("override.feed", {{"percent", 50}, {"channel", 2}}));
  EXPECT_EQ(machine.submitted().size(), 6u) << "another channel";
  static_cast<void>(ask("channel.control", {{"on", 0}}));
  EXPECT_EQ(failure("override.feed", {{"percent", 50}}).code, "E6080") << "it is not its own";
  dispatch.forget(3);
  EXPECT_TRUE(result("channel.status")["controlled_by"].is_null());
  EXPECT_EQ(machine.submitted().back().action(), OperatorAction::channel_control);
  EXPECT_EQ(session_in(machine.submitted().back()), 0) << "the cycle is told";
  static_cast<void>(ask("override.feed", {{"percent", 50}}));
  EXPECT_EQ(machine.submitted().back().action(), OperatorAction::override_feed);
}

// What concerns all channels is refused when somebody else has any of them.
TEST_F(DispatchTest, ControlOfAChannelCoversWhatAllChannelsShare) {
  session.id = 3;
  static_cast<void>(ask("channel.control", {{"channel", 2}}));
  const auto ask_all = [&](const auto& check) {
    for (const auto& [method, parameters] : std::map<std::string, json>{
             {"machine.on", json::object()},
             {"tool.set", {{"number", 4}, {"key", "length"}, {"value", 1.0}}},
             {"offset.set", {{"offset", "G54"}, {"axis", "X2"}, {"value", 1.0}}},
             {"tool.load", {{"tables", "[offset.G54]\nX2 = 1.0\n"}}},
             {"drive.reset", {{"drive", "X"}}}})
      check(method, parameters);
  };
  session.id = 4;
  ask_all([&](const std::string& method, const json& parameters) {
    EXPECT_EQ(failure(method, parameters).code, "E6080") << method;
  });
  EXPECT_EQ(machine.submitted().size(), 1u);
  static_cast<void>(ask("machine.off"));
  EXPECT_EQ(machine.submitted().size(), 2u) << "a stop";
  session.id = 3;
  ask_all([&](const std::string& method, const json& parameters) {
    const auto slot = ask(method, parameters);
    EXPECT_TRUE(!slot->has_value() || slot->value().has_value()) << method;
  });
}

// Who has asked and whom the cycle did not hear has no control; the cycle is told until it hears.
TEST_F(DispatchTest, TellsTheCycleWhoHasAChannelUntilItHears) {
  session.id = 3;
  machine.is_full = true;
  EXPECT_EQ(failure("channel.control").code, "E9007");
  EXPECT_TRUE(result("channel.status")["controlled_by"].is_null());
  machine.is_full = false;
  tick(0ms);
  EXPECT_EQ(session_in(machine.submitted().back()), 0);
  static_cast<void>(ask("channel.control"));
  EXPECT_EQ(session_in(machine.submitted().back()), 3);
  machine.is_full = true;
  dispatch.forget(3);
  EXPECT_EQ(session_in(machine.submitted().back()), 3);
  machine.is_full = false;
  tick(10ms);
  EXPECT_EQ(session_in(machine.submitted().back()), 0);
  const std::size_t told = machine.submitted().size();
  tick(20ms);
  EXPECT_EQ(machine.submitted().size(), told) << "once";
}

TEST_F(DispatchTest, ObeysTheRoleOfEveryMethod) {
  for (const protocol::Method& method : protocol::methods()) {
    for (const Role role :
         {Role::observer, Role::machine_operator, Role::programmer, Role::integrator}) {
      session.role = role;
      const auto slot = ask(std::string(method.name), {{"nonsense", 1}});
      ASSERT_TRUE(slot->has_value() && !slot->value().has_value()) << method.name;
      const FailureKind kind = slot->value().error().kind;
      EXPECT_EQ(kind == FailureKind::not_permitted, role < method.role) << method.name;
    }
  }
}

TEST_F(DispatchTest, AnswersEveryMethodOrHandsItToTheMachine) {
  const stanok::testing::TemporaryDirectory root;
  machine.root = root.path();
  for (const protocol::Method& method : protocol::methods()) {
    if (method.name == "program.check" || method.name == "program.estimate")
      continue;                                       // the schemes of this machine are none
    if (calculates(method)) continue;                 // a.nc is no sheet of a process
    if (method.name.starts_with("queue.")) continue;  // program_queue_test.cc
    if (method.name.ends_with(".touch") || method.name == "offset.undo")
      continue;  // touch_off_test.py
    const json parameters = accepted_parameters(method);
    if (parameters.contains("file") && method.name.starts_with("history."))
      continue;  // no log here
    session.role = Role::integrator;
    std::filesystem::remove(root.path() / "a.nc");
    if (method.name != "program.write") std::ofstream(root.path() / "a.nc") << "M30\n";
    SCOPED_TRACE(method.name);
    if (method.action.empty())
      expect_an_answer(method, parameters);
    else
      expect_an_action(method, parameters);
  }
  EXPECT_TRUE(shutdown_asked);
}

TEST_F(DispatchTest, SaysWhatIsUnknown) {
  EXPECT_EQ(failure("machine.fly").kind, FailureKind::method_not_found);
  EXPECT_EQ(failure("machine.fly").code, "E9002");
  EXPECT_EQ(failure("channel.status", {{"chanel", 1}}).code, "E9003");
  EXPECT_EQ(failure("channel.status", {{"channel", 3}}).code, "E6001");
  EXPECT_EQ(failure("program.hold", {{"channel", 3}}).code, "E6001");
}

TEST_F(DispatchTest, RemembersOverridesThatTheMachineTook) {
  const auto slot = ask("override.rapid", {{"percent", 40}});
  EXPECT_EQ(result("channel.status")["override"]["rapid"], 100.0);
  ASSERT_EQ(machine.submitted().size(), 1U);
  const auto command = machine.submitted()[0].command;
  EXPECT_DOUBLE_EQ(std::get<channels::commands::OverrideRapid>(command).factor, 0.4);
  dispatch.on_reply(accepted(machine.submitted()[0].id));
  EXPECT_EQ(result("channel.status")["override"]["rapid"], 40.0);
}

TEST_F(DispatchTest, RemembersSwitchesThatTheMachineTook) {
  json status = result("channel.status");
  EXPECT_EQ(status["single_block"], false);
  EXPECT_EQ(status["block_skip"], json::array());
  const auto take = [&](const char* method, const json& parameters) {
    const auto slot = ask(method, parameters);
    dispatch.on_reply(accepted(machine.submitted().back().id));
  };
  take("program.step", {{"on", 1}});
  take("program.optional_stop", {{"on", 1}});
  take("program.skip", {{"level", 3}});
  take("program.skip", {{"level", 1}});
  take("program.unskip", {{"level", 3}});
  status = result("channel.status");
  EXPECT_EQ(status["single_block"], true);
  EXPECT_EQ(status["optional_stop"], true);
  EXPECT_EQ(status["block_skip"], json({1}));
}

TEST_F(DispatchTest, PassesARefusalOfTheMachineOn) {
  const auto slot = ask("program.start", {{"channel", 2}});
  EXPECT_EQ(machine.submitted()[0].channel, 2);
  dispatch.on_reply(refused(machine.submitted()[0].id, "E6005", "no program is loaded"));
  ASSERT_TRUE(slot->has_value());
  EXPECT_EQ(slot->value().error().kind, FailureKind::refused);
  EXPECT_EQ(slot->value().error().code, "E6005");
  EXPECT_EQ(slot->value().error().channel, 2);
}

TEST_F(DispatchTest, TellsTheFirstErrorOfAProgramWithItsPlace) {
  const auto error_at = [](int line, const char* code) {
    channels::AlarmReport report;
    report.channel = 1;
    report.number = static_cast<std::uint64_t>(line);
    report.diagnostic.code = code;
    report.diagnostic.message = "unknown word";
    report.diagnostic.place = {"part.nc", line, 5, line, 6};
    return report;
  };
  machine.diagnostics = {error_at(1, "E1111")};  // of an earlier load
  const auto slot = ask("program.load", {{"program", "part.nc"}});
  machine.diagnostics.push_back(error_at(12, "E1002"));
  machine.diagnostics.push_back(error_at(13, "E1003"));
  dispatch.on_reply(refused(machine.submitted()[0].id, "", "part.nc"));
  ASSERT_TRUE(slot->has_value());
  const Failure failure = slot->value().error();
  EXPECT_EQ(failure.kind, FailureKind::program_error);
  EXPECT_EQ(failure.code, "E1002");
  EXPECT_EQ(failure.place.line, 12);
  EXPECT_EQ(failure.message, "unknown word (and 1 more)");
}

class WaitForTheEnd : public DispatchTest {
 protected:
  void begin() {
    slot = ask("program.run", {{"program", "part.nc"}, {"wait", "done"}});
    channels::RunReport report;
    report.channel = 1;
    report.run = 4;
    report.program = "part.nc";
    report.start_cycle = 1000;
    machine.run_reports = {report};
    dispatch.on_reply(accepted(machine.submitted()[0].id));
    EXPECT_FALSE(slot->has_value());
    tick(10ms);
    EXPECT_FALSE(slot->has_value()) << "the run is not over";
  }
  void end(bool ok) {
    machine.run_reports[0].ended = true;
    machine.run_reports[0].ok = ok;
    machine.run_reports[0].blocks = 7;
    machine.run_reports[0].end_cycle = 3500;
    machine.output.cycle = 3499;
    tick(20ms);
    tick(30ms);
    EXPECT_FALSE(slot->has_value()) << "the axes are not yet seen at the end";
    machine.output.cycle = 3500;
    tick(40ms);
    tick(50ms);
    ASSERT_TRUE(slot->has_value());
  }
  std::shared_ptr<std::optional<CommandResult>> slot;
};

TEST_F(WaitForTheEnd, AnswersWithTheFiguresOfTheRun) {
  begin();
  end(true);
  const json done = *slot->value();
  EXPECT_EQ(done["program"], "part.nc");
  EXPECT_EQ(done["blocks"], 7);
  EXPECT_DOUBLE_EQ(done["time_s"], 2.5);  // 2500 cycles of 1 ms
}

TEST_F(WaitForTheEnd, AnswersWithTheAlarmThatEndedIt) {
  begin();
  channels::AlarmReport alarm;
  alarm.channel = 1;
  alarm.cycle = 3500;
  alarm.diagnostic.code = "A3001";
  alarm.diagnostic.message = "following error";
  machine.alarm_reports = {alarm};
  end(false);
  EXPECT_EQ(slot->value().error().kind, FailureKind::machine_fault);
  EXPECT_EQ(slot->value().error().code, "A3001");
}

TEST_F(WaitForTheEnd, SaysThatSomebodyElseEndedIt) {
  begin();
  end(false);
  EXPECT_EQ(slot->value().error().code, "E9010");
}

TEST_F(DispatchTest, SaysWhenTheQueueIsFull) {
  machine.is_full = true;
  EXPECT_EQ(failure("program.start").code, "E9007");
}

TEST_F(DispatchTest, GivesUpWhenTheCycleStands) {
  tick(0ms);
  const auto slot = ask("program.start");
  tick(1900ms);
  EXPECT_FALSE(slot->has_value());
  machine.output.cycle = 2;
  tick(2100ms);
  tick(4000ms);
  EXPECT_FALSE(slot->has_value()) << "it goes on, however slowly";
  tick(4200ms);
  ASSERT_TRUE(slot->has_value());
  EXPECT_EQ(slot->value().error().code, "E9006");
  dispatch.on_reply(accepted(machine.submitted()[0].id));  // too late: nobody is asked twice
}

// What the cycle has begun to take it answers when it goes on; nothing newer takes effect.
TEST_F(DispatchTest, WithdrawsWhatItGivesUp) {
  tick(0ms);
  const auto taken = ask("program.resume");
  const auto waiting = ask("program.start");
  machine.taking = machine.submitted()[0].id;
  tick(2100ms);
  EXPECT_FALSE(taken->has_value());
  ASSERT_TRUE(waiting->has_value());
  EXPECT_EQ(waiting->value().error().code, "E9006");
  EXPECT_EQ(machine.withdrawn, machine.submitted()[1].id);
  dispatch.on_reply(accepted(machine.submitted()[0].id));
  EXPECT_TRUE(taken->has_value());
}

TEST_F(DispatchTest, ListsAlarmsUntilTheyAreAcknowledged) {
  channels::AlarmReport alarm;
  alarm.channel = 1;
  alarm.number = 501;  // of which the first 500 are not kept any more
  alarm.diagnostic.code = "E7001";
  alarm.diagnostic.place = {"part.nc", 3, 1, 3, 2};
  machine.alarm_reports = {alarm};
  const json standing = result("alarm.list");
  ASSERT_EQ(standing["alarms"].size(), 1U);
  EXPECT_EQ(standing["forgotten"], 500);
  EXPECT_EQ(standing["alarms"][0]["line"], 3);
  EXPECT_FALSE(standing["alarms"][0]["remedy"].get<std::string>().empty());
  machine.output.channels[0].state = channels::ChannelState::alarm;
  const auto slot = ask("alarm.ack");
  dispatch.on_reply(accepted(machine.submitted()[0].id));
  EXPECT_EQ(result("alarm.list")["alarms"].size(), 1U) << "the channel still has it";
  EXPECT_EQ(result("alarm.history")["alarms"][0]["acknowledged"], true);
  machine.output.channels[0].state = channels::ChannelState::idle;
  EXPECT_TRUE(result("alarm.list")["alarms"].empty());
}

// What was reset does not come back with the next alarm; what was acknowledged in an alarm stands
// with it.
TEST_F(DispatchTest, AnAlarmThatWasResetDoesNotComeBackWithTheNext) {
  const auto raise = [&](const char* code) {
    channels::AlarmReport alarm;
    alarm.channel = 1;
    alarm.number = machine.alarm_reports.size() + 1;
    alarm.diagnostic.code = code;
    machine.alarm_reports.push_back(alarm);
    machine.output.channels[0].state = channels::ChannelState::alarm;
  };
  const auto accept = [&](const char* method) {
    static_cast<void>(ask(method));
    dispatch.on_reply(accepted(machine.submitted().back().id));
  };
  const auto standing = [&] {
    std::vector<std::string> codes;
    const json list = result("alarm.list");
    for (const json& row : list["alarms"]) codes.push_back(row["code"]);
    return codes;
  };
  raise("E5101");
  machine.output.channels[0].state = channels::ChannelState::idle;
  accept("program.reset");
  EXPECT_TRUE(standing().empty());
  raise("U1006");
  EXPECT_EQ(standing(), std::vector<std::string>{"U1006"});
  accept("alarm.ack");
  EXPECT_EQ(standing(), std::vector<std::string>{"U1006"}) << "the channel is in that state";
  machine.output.channels[0].state = channels::ChannelState::idle;
  EXPECT_TRUE(standing().empty());
  accept("alarm.ack");
  raise("E6003");
  EXPECT_EQ(standing(), std::vector<std::string>{"E6003"});
  EXPECT_EQ(result("alarm.history")["alarms"].size(), 3u);
  EXPECT_FALSE(result("alarm.history").contains("forgotten"));
}

TEST_F(DispatchTest, TellsTheErrorOfALineWithTheKindOfAProgramsErrors) {
  const auto slot = ask("mdi", {{"text", "G1 X1 F"}});
  channels::AlarmReport report;
  report.channel = 1;
  report.number = 1;
  report.diagnostic.code = "E2001";
  machine.diagnostics = {report};
  dispatch.on_reply(refused(machine.submitted()[0].id, "", "mdi"));
  ASSERT_TRUE(slot->has_value());
  EXPECT_EQ(slot->value().error().kind, FailureKind::program_error);
  EXPECT_EQ(slot->value().error().code, "E2001");
}

TEST_F(DispatchTest, LetsRolesGoDownOnly) {
  EXPECT_EQ(result("session.role", {{"role", "integrator"}, {"name", "Anna"}})["role"],
            "integrator");
  EXPECT_TRUE(session.peer.starts_with("Anna (")) << session.peer;
  const std::string named = session.peer;
  static_cast<void>(result("session.role", {{"role", "integrator"}, {"name", "Boris"}}));
  EXPECT_EQ(session.peer, named) << "a browser could pretend to be somebody else";
  EXPECT_EQ(failure("session.role", {{"role", "integrator"}, {"name", "An\nna"}}).kind,
            FailureKind::invalid_parameters)
      << "would begin a line in the log";
  EXPECT_EQ(result("session.role", {{"role", "observer"}})["role"], "observer");
  EXPECT_EQ(result("session.role", {{"role", "operator"}})["role"], "observer");
  EXPECT_EQ(failure("program.hold").kind, FailureKind::not_permitted);
}

TEST_F(DispatchTest, OnlyLogsInTheirFolderHaveNames) {
  for (const char* name : {"../run.lcm", "/etc/run.lcm", "a/run.lcm", "tables.toml", ".."}) {
    EXPECT_EQ(failure("history.verify", {{"file", name}}).code, "E9021") << name;
    EXPECT_EQ(failure("history.path", {{"file", name}}).code, "E9021") << name;
  }
}

TEST_F(DispatchTest, NamesTheFirstChannelWhenNoneIsNamedAndNoneForTheMachine) {
  ask("program.hold");
  EXPECT_EQ(machine.submitted().back().channel, 1);
  ask("machine.estop");
  EXPECT_EQ(machine.submitted().back().channel, 0);
}

TEST_F(DispatchTest, BeginsAndEndsLogs) {
  EXPECT_EQ(failure("log.stop").code, "E9012");
  EXPECT_EQ(result("log.start")["path"], "mill.lcm");
  EXPECT_EQ(failure("log.start").code, "E9011");
  EXPECT_EQ(result("log.stop")["path"], "mill.lcm");
}

TEST_F(DispatchTest, ResetsDrivesByName) {
  EXPECT_EQ(result("drive.reset", {{"drive", "X"}}), json({{"accepted", true}}));
  EXPECT_EQ(machine.resets, std::vector<std::string>{"X"});
  EXPECT_EQ(failure("drive.reset", {{"drive", "Q"}}).code, "E6050");
  EXPECT_EQ(failure("drive.reset").code, "E9003");
}

TEST_F(DispatchTest, MakesSimulatedDrivesFailAndNoOthers) {
  session.role = Role::integrator;
  EXPECT_EQ(result("drive.fault", {{"drive", "X"}, {"fault", "stuck"}}),
            json({{"accepted", true}}));
  ASSERT_EQ(machine.faults.size(), 1U);
  EXPECT_EQ(machine.faults[0].second, plant::FaultKind::stuck);
  EXPECT_EQ(failure("drive.fault", {{"drive", "X"}, {"fault", "asleep"}}).code, "E9003");
  EXPECT_EQ(failure("drive.fault", {{"drive", "Q"}, {"fault", "off"}}).code, "E6050");
  machine.choice = "real";
  EXPECT_EQ(failure("drive.fault", {{"drive", "X"}, {"fault", "off"}}).code, "E6051");
}

// The choices of the command are the faults there are.
TEST(DriveFault, NamesEveryFaultOfTheSimulation) {
  const protocol::Method* method = protocol::find_method("drive.fault");
  const auto choices = method->parameters[1].choices;
  ASSERT_EQ(choices.size(), plant::fault_kind_count);
  for (const std::string_view choice : choices) EXPECT_TRUE(plant::fault_named(choice)) << choice;
}

}  // namespace
}  // namespace stanok::daemon
