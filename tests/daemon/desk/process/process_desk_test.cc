// Lobes, figures from a log and forces along a program as clients get them: against closed forms
// and what the simulated machine is known to be.
#include "daemon/desk/process/process_desk.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <fstream>
#include <numbers>
#include <thread>

#include "daemon/desk/program_desk.h"
#include "runtime/log_observer.h"
#include "runtime/simulation.h"
#include "tests/daemon/fake_machine.h"
#include "tests/support/project_folders.h"
#include "tests/support/temporary_directory.h"

namespace stanok::daemon {
namespace {

using nlohmann::json;

config::MachineFile machine_named(const std::string& name) {
  return config::read_machine_file(stanok::testing::source_folder() + "/config/machines/" + name);
}

class ProcessDeskTest : public ::testing::Test {
 protected:
  explicit ProcessDeskTest(const std::string& name = "lathe.toml") : machine(machine_named(name)) {
    machine.root = machine.logs = root.path();
  }

  using Ask = std::function<void(Answer answer)>;
  // It is calculated behind everything else that the computer does.
  CommandResult answer_to(const Ask& ask) {
    std::optional<CommandResult> answer;
    ask([&answer](const CommandResult& outcome) { answer = outcome; });
    while (!answer) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
      desk.tick();
    }
    return *answer;
  }
  CommandResult stability(const json& parameters) {
    return answer_to([&](Answer answer) { desk.stability(1, parameters, std::move(answer)); });
  }
  CommandResult figures(const json& parameters) {
    return answer_to([&](Answer answer) { desk.figures(1, parameters, 1, std::move(answer)); });
  }
  CommandResult forces(const json& parameters) {
    return answer_to([&](Answer answer) { desk.forces(1, parameters, 1, std::move(answer)); });
  }
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(root.path() / name) << text;
  }
  void put_example(const std::string& name) const {
    std::filesystem::copy_file(stanok::testing::source_folder() + "/programs/examples/" + name,
                               root.path() / name);
  }

  stanok::testing::TemporaryDirectory root;
  FakeMachine machine;
  ProcessDesk desk{machine};
};

constexpr const char* one_mode =
    "kind = \"turning\"\nforce = 2000.0\n"
    "[[mode_x]]\nfrequency = 150.0\ndamping = 0.035\nstiffness = 12.0\n";
// 2 k zeta (1 + zeta) / K (Tlusty 2000, ch. 9).
constexpr double always_stable_mm = 2.0 * 12000.0 * 0.035 * 1.035 / 2000.0;

TEST_F(ProcessDeskTest, LobesHaveTheClosedForm) {
  write("bar.toml", one_mode);
  const auto found = stability({{"program", "bar.toml"}, {"from", 2000}, {"to", 12000}});
  ASSERT_TRUE(found) << found.error().message;
  EXPECT_EQ((*found)["kind"], "turning");
  EXPECT_NEAR((*found)["always_stable_mm"].get<double>() / always_stable_mm, 1.0, 1e-3);
  const json& limits = (*found)["limits"];
  ASSERT_EQ(limits.size(), 400U);
  EXPECT_NEAR(limits.front()[0].get<double>(), 2000.0, 1e-6);
  EXPECT_NEAR(limits.back()[0].get<double>(), 12000.0, 1e-6);
  // A chatter frequency lies above the natural one.
  for (const json& limit : limits) EXPECT_GT(limit[2], 150.0);
  // The highest lobe ends near the natural frequency: 9,000 rev/min.
  EXPECT_NEAR((*found)["best"][0]["speed_rev_per_min"].get<double>() / 9000.0, 1.0, 0.1);
}

TEST_F(ProcessDeskTest, APlannedCutIsJudged) {
  write("bar.toml", one_mode);
  const auto judged = [&](double depth) {
    const auto found = stability({{"program", "bar.toml"},
                                  {"from", 2000},
                                  {"to", 12000},
                                  {"speed", 5300},
                                  {"depth", depth}});
    return (*found)["cuts"][0];
  };
  EXPECT_EQ(judged(0.5 * always_stable_mm)["stable"], true);
  EXPECT_TRUE(judged(0.5 * always_stable_mm)["better_speed_rev_per_min"].is_null());
  EXPECT_EQ(judged(2.0 * always_stable_mm)["stable"], false);
  EXPECT_GT(judged(2.0 * always_stable_mm)["better_speed_rev_per_min"], 2000.0);
}

TEST_F(ProcessDeskTest, WhatIsWrongWithAFileOfACutIsTold) {
  write("bad.toml", "kind = \"turning\"\nforce = -2.0\n");
  const auto bad = stability({{"program", "bad.toml"}});
  ASSERT_FALSE(bad);
  EXPECT_EQ(bad.error().code, "E9102");
  EXPECT_EQ(bad.error().place.file, "bad.toml");
  EXPECT_EQ(bad.error().place.line, 2);
  EXPECT_EQ(stability({{"program", "none.toml"}}).error().code, "E7001");
  write("bar.toml", one_mode);
  const auto range = stability({{"program", "bar.toml"}, {"from", 5000}, {"to", 5000}});
  EXPECT_EQ(range.error().code, "E9024");
  EXPECT_EQ(stability({{"program", "bar.toml"}, {"speed", 5000}}).error().code, "E9024");
}

TEST_F(ProcessDeskTest, WhatTakesLongIsCancelled) {
  put_example("slot_lobes.toml");
  std::optional<CommandResult> answer;
  desk.stability(1,
                 {{"program", "slot_lobes.toml"},
                  {"from", 500},
                  {"count", 1200},
                  {"method", "semi-discretisation"}},
                 [&answer](const CommandResult& outcome) { answer = outcome; });
  desk.cancel(1);
  while (!answer) desk.tick();
  ASSERT_FALSE(*answer);
  EXPECT_EQ(answer->error().code, "E9017");
}

class FiguresTest : public ProcessDeskTest {
 protected:
  void SetUp() override {
    write("cut.nc",
          "G21 G90 G18 G7 G40 G54\nT0101\nG97 S300 M3\nG4 F1.5\nS600\nG4 F1.5\nG95\nG0 X60 Z2\n"
          "G1 Z-10 F0.1\nZ-20 F0.3\nZ-30 F0.15\nZ-40 F0.4\nG0 X72\nZ5 M5\nM30\n");
    runtime::SimulationOptions options;
    options.file = machine.file();
    options.program_roots = {root.path()};
    options.programs = {{.channel = 1, .program = "cut.nc"}};
    options.drives = runtime::DriveChoice::simulated;
    runtime::LogObserver log(options.file, runtime::setup_of(options),
                             (root.path() / "cut.lcm").string(), "test");
    ASSERT_TRUE(runtime::simulate(options, {&log}, [] { return false; }).ok);
  }
  const json asked{{"file", "cut.lcm"}, {"stock", "0:32,-20:33,-40:32"}, {"coefficient", 1600}};
};

// Of [simulation.cutting] of lathe.toml: C = 1600 N, efficiency 0.85, y = 0.75.
TEST_F(FiguresTest, AreThoseOfTheSimulatedCut) {
  const auto found = figures(asked);
  ASSERT_TRUE(found) << found.error().message;
  std::map<std::string, double> values;
  for (const json& figure : (*found)["figures"]) {
    EXPECT_LT(figure["low"], figure["value"]) << figure;
    EXPECT_GT(figure["high"], figure["value"]) << figure;
    values[figure["name"]] = figure["value"];
  }
  EXPECT_NEAR(values.at("coefficient_over_efficiency_n"), 1600.0 / 0.85, 0.01 * 1600.0 / 0.85);
  EXPECT_NEAR(values.at("exponent"), 0.75, 0.01);
  EXPECT_NEAR(values.at("efficiency"), 0.85, 0.01);
  EXPECT_THAT((*found)["text"].get<std::string>(),
              ::testing::StartsWith("[process]\nefficiency = 0.8"));
  const json& power = (*found)["power"];
  EXPECT_GT(power.size(), 500U);
  EXPECT_LE(power.size(), ProcessDesk::rows_max);
  double squares = 0.0;
  for (const json& row : power) squares += std::pow(row[1].get<double>() - row[2].get<double>(), 2);
  EXPECT_LT(std::sqrt(squares / static_cast<double>(power.size())), 25.0) << "W between the two";
}

TEST_F(FiguresTest, WhatIsMissingIsTold) {
  const auto code = [&](const json& parameters) { return figures(parameters).error().code; };
  EXPECT_EQ(code({{"file", "../cut.lcm"}, {"stock", "0:32"}}), "E9021");
  EXPECT_EQ(code({{"file", "cut.lcm"}}), "E9024");
  EXPECT_EQ(code({{"file", "cut.lcm"}, {"stock", "0:32,5:33"}}), "E9024") << "Z does not fall";
  EXPECT_EQ(code({{"file", "cut.lcm"}, {"stock", "0:32,"}}), "E9024");
  EXPECT_EQ(code({{"file", "cut.lcm"}, {"stock", "0:32"}, {"spindle", 2}}), "E9024");
  EXPECT_EQ(code({{"file", "none.lcm"}, {"stock", "0:32"}}), "E9024");
  EXPECT_EQ(code({{"file", "cut.lcm"}, {"kind", "grinding"}, {"program", "none.toml"}}), "E7001");
  write("none.toml", "width = 1.0\n");
  EXPECT_EQ(code({{"file", "cut.lcm"}, {"kind", "grinding"}, {"program", "none.toml"}}), "E9102");
}

// Of the bar: 3 mm at 200 HB, or 2 mm at 260 HB, whichever takes more.
double force_n(double feed_per_rev) {
  return 1600.0 * std::pow(feed_per_rev, 0.75) * std::max(3.0, 2.0 * std::pow(1.3, 0.75));
}

TEST_F(ProcessDeskTest, ForcesOfATurningProgramAreTheFormula) {
  put_example("adaptive_steps.nc");
  const auto found = forces({{"program", "adaptive_steps.nc"}, {"stiffness", 20.0}});
  ASSERT_TRUE(found) << found.error().message;
  const double most = force_n(0.25);
  EXPECT_NEAR((*found)["force_programmed_max_n"].get<double>(), most, 1e-6 * most);
  EXPECT_NEAR((*found)["deflection_max_um"].get<double>(), most / 20.0, 1e-6 * most);
  EXPECT_EQ((*found)["force_max_n"], (*found)["force_programmed_max_n"]);
  EXPECT_TRUE((*found)["text"].is_null());
  const json& places = (*found)["places"];
  EXPECT_GT(places.size(), 500U);
  EXPECT_LE(places.size(), ProcessDesk::rows_max);
  double seen = 0.0;
  for (const json& place : places) seen = std::max(seen, place[1].get<double>());
  EXPECT_NEAR(seen, most, 1e-6 * most) << "a peak is not left out";
}

TEST_F(ProcessDeskTest, PlannedFeedsKeepTheForce) {
  put_example("adaptive_steps.nc");
  const auto found = forces(
      {{"program", "adaptive_steps.nc"}, {"force", 1200}, {"feed_min", 0.05}, {"feed_max", 0.6}});
  ASSERT_TRUE(found) << found.error().message;
  EXPECT_LE((*found)["force_max_n"], 1200.0);
  EXPECT_GT((*found)["force_max_n"], 0.98 * 1200.0);
  EXPECT_THAT((*found)["text"].get<std::string>(), ::testing::HasSubstr("// #adaptive"));
  // The feed of 3 mm: (1200 / 4800)^(4/3) of a turn, in steps of 0.001.
  EXPECT_THAT((*found)["text"].get<std::string>(), ::testing::HasSubstr("F0.157"));
}

TEST_F(ProcessDeskTest, AProgramWithAnErrorHasNoForces) {
  write("bad.nc", "G21 G90 G18\nG1 X60 Z-10 F\nM30\n");
  const auto found = forces({{"program", "bad.nc"}});
  ASSERT_FALSE(found);
  EXPECT_EQ(found.error().place.file, "bad.nc");
  EXPECT_EQ(found.error().place.line, 2);
}

class MillingForcesTest : public ProcessDeskTest {
 protected:
  MillingForcesTest() : ProcessDeskTest("e7106mf4.toml") { put_example("end_mill_6.toml"); }
  // Tool 3: end mill of 6 mm; a slot of 2 mm.
  static std::string slot(const std::string& blank) {
    return "G21 G90 G17 G40 G49 G80 G54 G94\n" + blank +
           "T3 M6\nS6000 M3\nG0 X-6 Y10\nG43 H3 Z50\nG0 Z2\nG1 Z-2 F300\nG1 X30 F600\nG0 Z50\n"
           "G49 M5\nM30\n";
  }
};

TEST_F(MillingForcesTest, PlannedFeedsKeepTheForceOfASlot) {
  write("slot.nc", slot("#workpiece (0, 0.25, 0, 40, 20, 10, 0, 0, 10)\n"));
  const auto found = forces({{"program", "slot.nc"}, {"cut", "end_mill_6.toml"}, {"force", 60}});
  ASSERT_TRUE(found) << found.error().message;
  EXPECT_EQ((*found)["kind"], "milling");
  EXPECT_GT((*found)["force_programmed_max_n"], 60.0);
  EXPECT_LE((*found)["force_max_n"], 60.0);
  // A slot of 2 mm takes 12 mm2.
  const json& places = (*found)["places"];
  double area = 0.0;
  for (const json& place : places) area = std::max(area, place[6].get<double>());
  EXPECT_NEAR(area, 12.0, 0.6);
  EXPECT_GT((*found)["time_s"], (*found)["time_programmed_s"]);
}

TEST_F(MillingForcesTest, WithoutABlankNothingIsTold) {
  write("slot.nc", slot(""));
  const auto found = forces({{"program", "slot.nc"}, {"cut", "end_mill_6.toml"}});
  ASSERT_FALSE(found);
  EXPECT_EQ(found.error().code, "E9024");
  EXPECT_THAT(found.error().message, ::testing::HasSubstr("#workpiece"));
}

TEST_F(MillingForcesTest, ALogWithoutABlankTellsNoFigures) {
  write("slot.nc", slot(""));
  runtime::SimulationOptions options;
  options.file = machine.file();
  options.program_roots = {root.path()};
  options.programs = {{.channel = 1, .program = "slot.nc"}};
  runtime::LogObserver log(options.file, runtime::setup_of(options),
                           (root.path() / "slot.lcm").string(), "test");
  ASSERT_TRUE(runtime::simulate(options, {&log}, [] { return false; }).ok);
  const auto found =
      figures({{"file", "slot.lcm"}, {"kind", "milling"}, {"program", "end_mill_6.toml"}});
  ASSERT_FALSE(found);
  EXPECT_EQ(found.error().code, "E9024");
  EXPECT_THAT(found.error().message, ::testing::HasSubstr("#workpiece"));
}

class PartTest : public MillingForcesTest {
 protected:
  CommandResult picture(const std::string& name) {
    std::optional<CommandResult> answer;
    programs.picture(1, {{"program", name}}, 1,
                     [&answer](const CommandResult& outcome) { answer = outcome; });
    while (!answer) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
      programs.tick();
    }
    return *answer;
  }
  ProgramDesk programs{machine};
};

// A slot 6 wide and 2 deep from the edge at X 0 to X 30, round at its end.
TEST_F(PartTest, IsShownAsTheProgramLeavesIt) {
  write("slot.nc", slot("#workpiece (0, 0.25, 0, 40, 20, 10, 0, 0, 10)\n"));
  const auto found = picture("slot.nc");
  ASSERT_TRUE(found) << found.error().message;
  EXPECT_EQ((*found)["ok"], true);
  EXPECT_EQ((*found)["complete"], true);
  EXPECT_NEAR((*found)["blank_mm3"].get<double>(), 8000.0, 1e-6);
  const double volume = 2.0 * (6.0 * 30.0 + std::numbers::pi * 9.0 / 2.0);
  EXPECT_NEAR((*found)["removed_mm3"].get<double>(), volume, 0.01 * volume);
  // Of a PNG file the first bytes, in base64.
  EXPECT_THAT((*found)["picture"].get<std::string>(), ::testing::StartsWith("iVBORw0KGgo"));
}

TEST_F(PartTest, WithoutABlankThereIsNone) {
  write("slot.nc", slot(""));
  const auto found = picture("slot.nc");
  ASSERT_TRUE(found) << found.error().message;
  EXPECT_EQ((*found)["ok"], true);
  EXPECT_TRUE((*found)["picture"].is_null());
  write("bad.nc", "G21\nG1 X60 Z-10 F\nM30\n");
  EXPECT_EQ(picture("bad.nc").error().place.line, 2);
}

}  // namespace
}  // namespace stanok::daemon
