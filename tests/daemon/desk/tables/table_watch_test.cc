// Who changed what of tools and offsets, and when what loaded programs lead through is another one.
#include "daemon/desk/tables/table_watch.h"

#include <gtest/gtest.h>

#include "daemon/desk/program_times.h"
#include "tests/daemon/fake_machine.h"

namespace stanok::daemon {
namespace {

using nlohmann::json;

class TableWatchTest : public ::testing::Test {
 protected:
  TableWatchTest() { EXPECT_FALSE(watch.look(1.0)) << "nothing was known before"; }

  // A run of channel 1 that leaves behind what `act` does.
  void run(const std::string& program, const std::function<void()>& act) {
    machine.output.channels[0].running = true;
    machine.output.channels[0].run += 1;
    EXPECT_FALSE(watch.look(2.0)) << "while it runs";
    act();
    EXPECT_FALSE(watch.look(3.0)) << "while it runs";
    channels::RunReport report;
    report.channel = 1;
    report.program = program;
    report.begun_at = ++time_s_;
    machine.run_reports.push_back(report);
    machine.output.channels[0].running = false;
  }

  FakeMachine machine;
  TableWatch watch{machine};

 private:
  double time_s_ = 0.0;
};

TEST_F(TableWatchTest, KnowsWhoChangedWhat) {
  machine.tables_now.tools[0].length = 80.0;
  watch.note("anna", 100.0);
  machine.tables_now.offsets["G54"]["X2"] = -3.5;
  watch.note("boris", 200.0);
  watch.note("boris", 300.0);
  EXPECT_EQ(watch.history()["changes"], json::parse(R"([
      {"time_s":200.0,"by":"boris","what":"G54 X2","from":0.0,"to":-3.5},
      {"time_s":100.0,"by":"anna","what":"T32000.1 length","from":77.5,"to":80.0}])"));
  EXPECT_FALSE(watch.look(400.0)) << "it was noted when it was accepted";
}

TEST_F(TableWatchTest, ARunMayLeaveOtherTablesBehind) {
  run("measure.nc", [&] { machine.tables_now.offsets["G55"]["B"] = 12.0; });
  EXPECT_TRUE(watch.look(50.0));
  EXPECT_FALSE(watch.look(51.0)) << "once";
  const json change = watch.history()["changes"][0];
  EXPECT_EQ(change["by"], "measure.nc");
  EXPECT_EQ(change["what"], "G55 B");
  EXPECT_EQ(change["time_s"], 50.0);
  run("part.nc", [] {});
  EXPECT_FALSE(watch.look(60.0)) << "with the tables that were there";
  EXPECT_EQ(watch.history()["changes"].size(), 1U);
}

TEST_F(TableWatchTest, ARunMayLeaveAnotherSchemeBehind) {
  run("mdi", [&] { machine.output.channels[0].scheme = 2; });
  EXPECT_TRUE(watch.look(50.0));
  EXPECT_FALSE(watch.look(51.0));
  EXPECT_TRUE(watch.history()["changes"].empty());
}

TEST_F(TableWatchTest, IsBounded) {
  for (int k = 0; k < 600; ++k) {
    machine.tables_now.tools[0].radius = 1.0 + k;
    watch.note("anna", k);
  }
  EXPECT_EQ(watch.history()["changes"].size(), TableWatch::changes_max);
  EXPECT_EQ(watch.history()["changes"][0]["to"], 600.0);
}

TEST(ProgramTimes, AreThoseOfTheLastCheckAndTheLastRun) {
  ProgramTimes times;
  times.note_check("a.nc", ProgramTimes::Verdict::faulty, 10.0);
  times.note_check("a.nc", ProgramTimes::Verdict::faultless, 20.0);
  channels::RunReport first;
  first.program = "b.nc";
  first.begun_at = 92.0;
  first.ended = true;
  channels::RunReport second = first;
  second.begun_at = 95.0;
  second.ok = true;
  json rows = json::parse(R"([{"name":"a.nc"},{"name":"b.nc"},{"name":"c.nc"}])");
  times.add_to(rows, {second, first});
  EXPECT_EQ(rows[0], json::parse(R"({"name":"a.nc","checked_s":20.0,"check_ok":true,
                                     "ran_s":null,"run_ok":null})"));
  EXPECT_EQ(rows[1], json::parse(R"({"name":"b.nc","checked_s":null,"check_ok":null,
                                     "ran_s":95.0,"run_ok":true})"));
  EXPECT_EQ(rows[2]["ran_s"], nullptr);
}

}  // namespace
}  // namespace stanok::daemon
