// Events out of what a daemon remembers: each once, whoever of them begins anew.
#include "gateway/cell/event_source.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "gateway/start/gateway_options.h"
#include "tests/support/temporary_directory.h"

namespace stanok::testing {
namespace {

using gateway::DaemonStart;
using gateway::EventSource;
using nlohmann::json;

json run(int number, const char* state) {
  const bool has_ended = std::string(state) != "runs";
  return {{"channel", 1},       {"number", number},
          {"program", "a.nc"},  {"begun_cycle", 1000 * number},
          {"blocks", 5},        {"ended_cycle", has_ended ? json(1000 * number + 500) : json()},
          {"time_s", 0.5},      {"path_mm", 10.0},
          {"ended", has_ended}, {"ok", std::string(state) == "good"}};
}

json runs(std::initializer_list<json> list) {
  return {{"runs", json(list)}};
}

json measurement(int number) {
  return {{"channel", 1}, {"number", number}, {"cycle", 10}, {"text", "measured bore size=14.05"}};
}

json measurements(std::initializer_list<json> list) {
  return {{"measurements", json(list)}};
}

class TheSource : public ::testing::Test {
 protected:
  TheSource() { meet(source_); }
  static void meet(EventSource& source) {
    source.meet({.boot = "b", .process = 7, .started_s = 100.0});
    source.set_clock(5000.0, 1e-3);
  }
  // Kinds and numbers of runs, since the last look.
  std::string seen() {
    std::string text;
    for (const auto& stored : outbox_.behind(seen_, 100)) {
      seen_ = stored.number;
      const json& content = stored.event.content;
      const json number =
          content.contains("count") ? content["count"] : content.value("number", json());
      text += stored.event.kind + " " +
              (number.is_null() ? "" : std::to_string(number.get<int>())) + ";";
    }
    return text;
  }

  TemporaryDirectory folder_;
  gateway::Outbox outbox_{folder_.path() / "outbox.sqlite"};
  EventSource source_{"mill", outbox_};
  std::int64_t seen_ = 0;
};

TEST_F(TheSource, TellsBeginAndEndOfARunOnce) {
  source_.take_runs(runs({run(1, "runs")}), {{"a.nc", "v"}});
  EXPECT_EQ(seen(), "run_begun 1;");
  source_.take_runs(runs({run(1, "good")}), {});
  EXPECT_EQ(seen(), "run_ended 1;");
  source_.take_runs(runs({run(1, "good"), run(2, "bad")}), {});
  EXPECT_EQ(seen(), "run_begun 2;run_ended 2;");
  EXPECT_EQ(source_.parts(), json({{"a.nc", 1}}));
}

TEST_F(TheSource, KnowsWhenAndOfWhichTextARunWas) {
  source_.take_runs(runs({run(1, "good")}), {{"a.nc", "v"}});
  const auto ended = outbox_.behind(1, 1).at(0).event;
  EXPECT_EQ(ended.time_s, 5001.5);
  EXPECT_EQ(ended.content["begun_s"], 5001.0);
  EXPECT_EQ(ended.content["version"], "v");
}

TEST_F(TheSource, GoesOnWhereAGatewayBeforeItEnded) {
  source_.take_runs(runs({run(1, "good"), run(2, "runs")}), {});
  static_cast<void>(seen());
  EventSource next("mill", outbox_);
  meet(next);
  next.take_runs(runs({run(1, "good"), run(2, "good"), run(3, "good")}), {});
  EXPECT_EQ(seen(), "run_ended 2;run_begun 3;run_ended 3;");
  EXPECT_EQ(next.parts(), json({{"a.nc", 3}}));
}

TEST_F(TheSource, CountsAnewForAnotherDaemon) {
  source_.take_runs(runs({run(1, "good")}), {});
  static_cast<void>(seen());
  for (const DaemonStart& other : {DaemonStart{"b", 8, 100.0, 0.0}, DaemonStart{"b", 7, 200.0, 0.0},
                                   DaemonStart{"other", 7, 100.0, 0.0}}) {
    source_.meet(other);
    source_.take_runs(runs({run(1, "good")}), {});
    EXPECT_EQ(seen(), "run_begun 1;run_ended 1;");
  }
}

// Numbers of runs go on with the journal; a run that was cut off ends once, when it was.
TEST_F(TheSource, GoesOnWithTheJournalOfAnotherDaemon) {
  source_.meet({.boot = "b", .process = 8, .started_s = 100.0, .history = "j"});
  source_.take_runs(runs({run(1, "good"), run(2, "runs")}), {});
  source_.take_measurements(measurements({measurement(1)}));
  static_cast<void>(seen());
  source_.meet({.boot = "b", .process = 9, .started_s = 200.0, .history = "j"});
  json cut = run(2, "bad");
  cut["begun_cycle"] = cut["ended_cycle"] = nullptr;
  cut["begun_at"] = 5002.0;
  cut["ended_at"] = 5002.75;
  cut["end"] = "cut_off";
  source_.take_runs(runs({run(1, "good"), cut, run(3, "runs")}), {});
  source_.take_measurements(measurements({measurement(1)}));
  const auto ended = outbox_.behind(seen_, 1).at(0).event;
  EXPECT_EQ(ended.time_s, 5002.75);
  EXPECT_EQ(ended.content["end"], "cut_off");
  EXPECT_EQ(ended.content["begun_s"], 5002.0);
  EXPECT_EQ(seen(), "run_ended 2;run_begun 3;measurement 1;");
  source_.meet({.boot = "b", .process = 10, .started_s = 300.0, .history = "another"});
  source_.take_runs(runs({run(1, "good")}), {});
  EXPECT_EQ(seen(), "run_begun 1;run_ended 1;") << "its journal was removed";
}

// A busy computer: question or answer were long on their way, now or when it was met first.
TEST_F(TheSource, KnowsADaemonAgainWhoseAnswerWasLate) {
  source_.take_runs(runs({run(1, "good")}), {});
  static_cast<void>(seen());
  source_.meet({.boot = "b", .process = 7, .started_s = 91.0, .uncertain_s = 30.0});
  source_.take_runs(runs({run(1, "good")}), {});
  EXPECT_EQ(seen(), "");
  gateway::Outbox outbox{folder_.path() / "other.sqlite"};
  EventSource late("mill", outbox);
  late.meet({.boot = "b", .process = 7, .started_s = 91.0, .uncertain_s = 30.0});
  late.take_runs(runs({run(1, "good")}), {});
  EXPECT_EQ(outbox.behind(0, 10).size(), 2U);
  late.meet({.boot = "b", .process = 7, .started_s = 119.0, .uncertain_s = 0.1});
  late.take_runs(runs({run(1, "good")}), {});
  EXPECT_EQ(outbox.behind(0, 10).size(), 2U);
  // One that started later than that is another one.
  late.meet({.boot = "b", .process = 7, .started_s = 124.0, .uncertain_s = 0.1});
  late.take_runs(runs({run(1, "good")}), {});
  EXPECT_EQ(outbox.behind(0, 10).size(), 4U);
}

TEST_F(TheSource, TellsWhatTheDaemonHadForgotten) {
  source_.take_runs(runs({run(4, "good")}), {});
  EXPECT_EQ(seen(), "lost 3;run_begun 4;run_ended 4;");
}

TEST_F(TheSource, CountsTheTimeOfToolsWithRuns) {
  source_.add_tool_time(3, 2.0);
  EXPECT_EQ(source_.tools(), json::object());
  source_.take_runs(runs({run(1, "good")}), {});
  EXPECT_EQ(source_.tools(), json({{"3", 2.0}}));
  source_.add_tool_time(3, 1.5);
  source_.take_runs(runs({run(2, "good")}), {});
  EXPECT_EQ(source_.tools(), json({{"3", 3.5}}));
}

TEST_F(TheSource, TellsMeasurementsOnceAlsoThoseWhileItWasAway) {
  source_.take_measurements(measurements({measurement(1)}));
  EXPECT_EQ(seen(), "measurement 1;");
  EventSource next("mill", outbox_);
  meet(next);
  next.take_measurements(measurements({measurement(1), measurement(2), measurement(3)}));
  EXPECT_EQ(seen(), "measurement 2;measurement 3;");
  next.take_measurements(measurements({measurement(7)}));
  EXPECT_EQ(seen(), "lost 3;measurement 7;");
}

TEST(GatewayOptions, RefuseWhatWouldBeDangerous) {
  gateway::GatewayOptions options;
  EXPECT_THROW(check(options), gateway::UsageError);
  options.machines = {gateway::machine_address("/run/stanok/mill.sock")};
  EXPECT_EQ(options.machines[0].name, "mill");
  EXPECT_NO_THROW(check(options));
  options.history = "postgresql://cell:secret@db/cell";
  EXPECT_THROW(check(options), gateway::UsageError);
  options.history = "postgresql://cell@db/cell";
  EXPECT_NO_THROW(check(options));
  options.broker.user = "hall";
  options.broker.password_file = "/etc/password";
  EXPECT_NO_THROW(check(options));
  gateway::set_broker("broker.example:1883", options);
  EXPECT_THROW(check(options), gateway::UsageError);
  options.broker.tls_ca = "/etc/ca.pem";
  EXPECT_NO_THROW(check(options));
  EXPECT_THROW(static_cast<void>(gateway::machine_address("a/b=/x.sock")), gateway::UsageError);
  EXPECT_THROW(gateway::set_broker("host:port", options), gateway::UsageError);
}

}  // namespace
}  // namespace stanok::testing
