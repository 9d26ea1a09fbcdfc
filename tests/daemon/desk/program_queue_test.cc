// ProgramQueue: programs begin one after the other, and never behind anything that an operator
// looks at first.
#include "daemon/desk/program_queue.h"

#include <gtest/gtest.h>

#include <fstream>

#include "channels/contract/operator_action.h"
#include "daemon/desk/dispatch.h"
#include "tests/daemon/fake_machine.h"
#include "tests/daemon/live_daemon.h"
#include "tests/support/temporary_directory.h"

namespace stanok::daemon {
namespace {

using channels::OperatorAction;
using channels::OperatorEvent;
using nlohmann::json;
using namespace std::chrono_literals;

class ProgramQueueTest : public ::testing::Test {
 protected:
  static constexpr std::uint64_t stops_taken = 7;

  json changed(void (ProgramQueue::*change)(const json&, int, Answer), const json& parameters) {
    std::optional<CommandResult> answered;
    (queue.*change)(parameters, 1, [&](const CommandResult& outcome) { answered = outcome; });
    while (!answered) queue.tick();
    return *answered ? (*answered)->at("queues").at(0) : json{{"code", answered->error().code}};
  }
  void add(const std::string& program) { changed(&ProgramQueue::add, {{"program", program}}); }
  CommandResult start(int session = 3) {
    return queue.start(1, {session, "a person", {.stops_before = stops_taken}});
  }
  json line() { return queue.list(1)["queues"][0]; }
  std::string program_begun() {
    const auto submitted = machine.submitted();
    if (submitted.empty()) return "";
    const auto* run = std::get_if<channels::commands::ProgramRun>(&submitted.back().command);
    return run == nullptr ? "" : std::string(run->program.view());
  }
  std::size_t asked() { return machine.submitted().size(); }
  // The cycle takes what was asked for last, and a run begins.
  void accept() {
    machine.change([&](FakeMachine& m) {
      channels::RunReport run;
      run.channel = 1;
      run.run = ++runs;
      m.run_reports.push_back(run);
      m.output.channels[0].running = true;
    });
    desk.on_reply({.id = machine.submitted().back().id, .ok = true, .code = {}, .text = {}});
  }
  enum class End { good, bad };
  void end_run(End how = End::good) {
    machine.change([&](FakeMachine& m) {
      m.run_reports.back().ended = true;
      m.run_reports.back().ok = how == End::good;
      m.output.channels[0].running = false;
    });
    tick();
  }
  void tick() {
    for (int n = 0; n < 3; ++n) {
      desk.tick(SteadyTime{} + 1h);
      queue.tick();
    }
  }
  void accepted(const channels::OperatorCommand& command, int channel = 1,
                std::uint64_t stops_before = 0) {
    OperatorEvent event;
    event.command = command;
    event.channel = channel;
    event.stops_before = stops_before;
    desk.note_acceptance(event);
  }
  void begin_two() {
    add("a.nc");
    add("b.nc");
    ASSERT_TRUE(start());
    tick();
    ASSERT_EQ(program_begun(), "a.nc");
    accept();
  }
  void expect_that_nothing_begins_behind_it(const std::string& why) {
    EXPECT_FALSE(line()["started"]) << why;
    EXPECT_EQ(line()["stopped_by"], why);
    const std::size_t before = asked();
    end_run();
    tick();
    EXPECT_EQ(asked(), before) << why;
  }

  stanok::testing::TemporaryDirectory folder;
  const bool has_state = std::filesystem::create_directory(folder.path() / "state");
  FakeMachine machine;
  NotesOfChannels notes;
  CommandDesk desk{machine, notes};
  ChannelControl control;
  ProgramQueue queue{machine, desk, control, notes, folder.path() / "state/queue.txt"};
  std::uint32_t runs = 0;
  const bool watches =
      (desk.watch([this](const OperatorEvent& event) { queue.note(event); }), true);
};

TEST_F(ProgramQueueTest, RunsItsProgramsOneAfterTheOther) {
  add("a.nc");
  add("b.nc");
  tick();
  EXPECT_EQ(asked(), 0U) << "nobody has started it";
  ASSERT_TRUE(start());
  tick();
  EXPECT_EQ(program_begun(), "a.nc");
  EXPECT_EQ(machine.submitted().back().stops_before, stops_taken) << "nothing begins behind a stop";
  accept();
  tick();
  EXPECT_EQ(asked(), 1U) << "the first one is under way";
  EXPECT_EQ(line()["under_way"], line()["programs"][0]["id"]);
  end_run();
  EXPECT_EQ(program_begun(), "b.nc");
  accept();
  end_run();
  EXPECT_EQ(line()["programs"], json::array());
  EXPECT_FALSE(line()["started"]);
  EXPECT_TRUE(line()["stopped_by"].is_null());
  EXPECT_EQ(asked(), 2U);
  EXPECT_FALSE(start()) << "it is empty";
}

TEST_F(ProgramQueueTest, StopsWithWhateverEndsOrReplacesAProgram) {
  namespace commands = channels::commands;
  const std::vector<std::pair<channels::OperatorCommand, std::string>> ends{
      {commands::MachineEstop{}, "STOP ALL"},
      {commands::MachineOff{}, "the machine was switched off"},
      {commands::ProgramStop{}, "a program was stopped"},
      {commands::ProgramReset{}, "reset"},
      {commands::ProgramLoad{}, "another program was loaded"},
      {commands::ProgramRun{}, "another program was started"},
      {commands::Mdi{}, "an MDI line was executed"}};
  for (const auto& [command, why] : ends) {
    begin_two();
    accepted(command, channels::is_stop(channels::action_of(command)) ? 0 : 1);
    expect_that_nothing_begins_behind_it(why);
    while (!line()["programs"].empty())
      changed(&ProgramQueue::remove, {{"id", line()["programs"][0]["id"]}});
  }
}

TEST_F(ProgramQueueTest, StopsWithAFailedProgramAndKeepsIt) {
  begin_two();
  end_run(End::bad);
  EXPECT_EQ(asked(), 1U);
  EXPECT_FALSE(line()["started"]);
  EXPECT_EQ(line()["stopped_by"], "E9010 the program was ended before its end");
  EXPECT_EQ(line()["programs"].size(), 2U);
}

TEST_F(ProgramQueueTest, StopsWithAnAlarmOfAnyChannel) {
  begin_two();
  machine.change(
      [](FakeMachine& m) { m.output.channels[1].state = channels::ChannelState::alarm; });
  tick();
  expect_that_nothing_begins_behind_it("channel 2 has an alarm");
  EXPECT_FALSE(start()) << "the alarm is still there";
}

TEST_F(ProgramQueueTest, StopsWhenSomebodyElseTakesTheChannel) {
  begin_two();
  SessionState owner;
  owner.id = 3;
  EXPECT_FALSE(control.take(1, owner));
  tick();
  EXPECT_TRUE(line()["started"]) << "who started it may";
  control.forget(3);
  tick();
  EXPECT_TRUE(line()["started"]) << "its connection has ended, nobody has the channel";
  SessionState other;
  other.id = 4;
  other.peer = "another one";
  EXPECT_FALSE(control.take(1, other));
  tick();
  expect_that_nothing_begins_behind_it("session 4 (another one) has taken control of the channel");
  EXPECT_EQ(start().error().code, "E6080");
}

TEST_F(ProgramQueueTest, AProgramThatTheMachineRefusesStopsIt) {
  add("a.nc");
  ASSERT_TRUE(start());
  tick();
  desk.on_reply(
      {.id = machine.submitted().back().id,
       .ok = false,
       .code = FixedText<8>("E6072"),
       .text = FixedText<240>("a stop that was given later arrived before this command")});
  tick();
  EXPECT_EQ(asked(), 1U);
  EXPECT_EQ(line()["stopped_by"], "E6072 a stop that was given later arrived before this command");
}

// A hold counts as a stop until an operator, who knows of it, lets the program go on.
TEST_F(ProgramQueueTest, GoesOnBehindAHoldThatWasResumed) {
  begin_two();
  accepted(channels::commands::ProgramHold{});
  accepted(channels::commands::ProgramResume{}, 1, stops_taken + 1);
  end_run();
  EXPECT_EQ(program_begun(), "b.nc");
  EXPECT_EQ(machine.submitted().back().stops_before, stops_taken + 1);
}

TEST_F(ProgramQueueTest, WhatIsUnderWayStaysInItsPlace) {
  begin_two();
  add("c.nc");
  const json entries = line()["programs"];
  const auto id = [&](std::size_t k) { return entries[k]["id"]; };
  EXPECT_EQ(changed(&ProgramQueue::remove, {{"id", id(0)}})["code"], "E9022");
  EXPECT_EQ(changed(&ProgramQueue::move, {{"id", id(0)}, {"place", 2}})["code"], "E9022");
  EXPECT_EQ(changed(&ProgramQueue::move, {{"id", id(2)}, {"place", 1}})["code"], "E9022");
  EXPECT_EQ(changed(&ProgramQueue::remove, {{"id", 999}})["code"], "E9022");
  const json moved = changed(&ProgramQueue::move, {{"id", id(2)}, {"place", 2}})["programs"];
  EXPECT_EQ(moved[1]["program"], "c.nc");
  EXPECT_EQ(moved[2]["program"], "b.nc");
  EXPECT_EQ(changed(&ProgramQueue::remove, {{"id", id(1)}})["programs"].size(), 2U);
}

TEST_F(ProgramQueueTest, IsThereAfterARestartAndStandsStill) {
  begin_two();
  NotesOfChannels new_notes;
  CommandDesk new_desk{machine, new_notes};
  ProgramQueue again{machine, new_desk, control, new_notes, folder.path() / "state/queue.txt"};
  const json kept = again.list(1)["queues"][0];
  EXPECT_FALSE(kept["started"]);
  EXPECT_TRUE(kept["under_way"].is_null());
  ASSERT_EQ(kept["programs"].size(), 2U);
  EXPECT_EQ(kept["programs"][0]["program"], "a.nc");
  EXPECT_EQ(new_notes[1].queue.programs, 2U);
  const std::size_t before = asked();
  again.tick();
  EXPECT_EQ(asked(), before);
}

TEST_F(ProgramQueueTest, AQueueThatIsEmptiedBeforeItBeginsIsNotStarted) {
  add("a.nc");
  ASSERT_TRUE(start());
  const json id = line()["programs"][0]["id"];
  std::optional<CommandResult> answered;
  queue.remove({{"id", id}}, 1, [&](const CommandResult& outcome) { answered = outcome; });
  EXPECT_FALSE(line()["started"]);
  while (!answered) queue.tick();
  EXPECT_EQ(asked(), 0U);
}

// Who is told so gives the command again: then the program is there once, not twice.
TEST_F(ProgramQueueTest, WhatTheDiskDoesNotTakeIsNotAdded) {
  add("a.nc");
  std::filesystem::remove_all(folder.path() / "state");
  std::ofstream(folder.path() / "state") << "no folder\n";
  EXPECT_EQ(changed(&ProgramQueue::add, {{"program", "b.nc"}})["code"], "E9023");
  EXPECT_EQ(line()["programs"].size(), 1U);
  EXPECT_EQ(notes[1].queue.programs, 1U);
  std::filesystem::remove(folder.path() / "state");
  std::filesystem::create_directory(folder.path() / "state");
  EXPECT_EQ(changed(&ProgramQueue::add, {{"program", "b.nc"}})["programs"].size(), 2U);
}

// What an operator takes out never begins, whatever the disk does.
TEST_F(ProgramQueueTest, WhatIsRemovedStaysRemovedWithoutADisk) {
  add("a.nc");
  std::filesystem::remove_all(folder.path() / "state");
  std::ofstream(folder.path() / "state") << "no folder\n";
  const json removed = changed(&ProgramQueue::remove, {{"id", line()["programs"][0]["id"]}});
  EXPECT_EQ(removed["code"], "E9023");
  EXPECT_EQ(line()["programs"], json::array());
  EXPECT_FALSE(start());
}

TEST_F(ProgramQueueTest, ADamagedFileIsNoQueue) {
  std::ofstream(folder.path() / "other.txt") << "1 a.nc\n";
  ProgramQueue damaged{machine, desk, control, notes, folder.path() / "other.txt"};
  EXPECT_EQ(damaged.list(1)["queues"][0]["programs"], json::array());
}

// The daemon whole: its clock, its cycle, its reception.
class LiveQueueTest : public ::testing::Test {
 protected:
  json ask(const std::string& method, const json& parameters = json::object()) {
    client.request(++last, method, parameters);
    const json answer = client.receive("id", last);
    return answer.contains("result") ? answer["result"] : answer["error"]["data"];
  }
  json line() { return ask("queue.list", {{"channel", 1}})["queues"][0]; }
  template <class Condition>
  void wait_until(const Condition& condition) {
    for (int n = 0; n < 6000 && !condition(); ++n) std::this_thread::sleep_for(10ms);
    ASSERT_TRUE(condition()) << line();
  }
  std::vector<std::string> good_runs() {
    std::vector<std::string> programs;
    const json history = ask("program.history", {{"channel", 1}});
    for (const json& run : history["runs"])
      if (run["ok"]) programs.push_back(run["program"]);
    return programs;
  }

  LiveDaemon daemon;
  RawClient client{daemon.socket()};
  int last = 100;
};

TEST_F(LiveQueueTest, TwoProgramsRunAndAResetLetsNoThirdBegin) {
  daemon.program("short.nc", "G1 X1 F6000\nX0\nM30\n");
  daemon.program("long.nc",
                 "for (num turn = 0; turn < 100000; turn++) {\nG1 X1 F600\nX0\n}\nM30\n");
  ask("machine.on");
  for (const char* program : {"short.nc", "short.nc", "long.nc", "short.nc"})
    ask("queue.add", {{"program", program}});
  EXPECT_EQ(line()["programs"].size(), 4U);
  EXPECT_TRUE(ask("queue.start")["queues"][0]["started"]);
  wait_until([&] { return ask("channel.status")["program"] == "long.nc"; });
  EXPECT_EQ(good_runs().size(), 2U);
  ask("program.reset");
  wait_until([&] { return !line()["started"].get<bool>() && line()["under_way"].is_null(); });
  EXPECT_EQ(line()["programs"].size(), 2U);
  EXPECT_EQ(good_runs().size(), 2U);
  EXPECT_NE(ask("channel.status")["program_status"], "Running");
}

}  // namespace
}  // namespace stanok::daemon
