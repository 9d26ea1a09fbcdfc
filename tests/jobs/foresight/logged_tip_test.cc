// Where a log led the tip on the part: over work offsets as their numbers say, over tables that
// turn as the programmed point says, which rides on them.
#include "jobs/foresight/logged_tip.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>

#include "runtime/log_observer.h"
#include "runtime/simulation.h"
#include "tests/support/project_folders.h"
#include "tests/support/temporary_directory.h"

namespace stanok::jobs {
namespace {

using simulation::Vector;

struct LoggedPlace {
  setpoint_t setpoint;
  Vector on_part;
};

config::MachineFile machine_of_project(const std::string& name) {
  return config::read_machine_file(std::filesystem::path(stanok::testing::source_folder()) /
                                   "config" / "machines" / name);
}

// A program on a machine of the project, run and logged; places in P.
std::vector<LoggedPlace> logged_places(const std::string& machine, const std::string& text,
                                       const PartSystem& part) {
  const stanok::testing::TemporaryDirectory folder;
  std::ofstream(folder.path() / "part.nc") << text;
  const std::filesystem::path log = folder.path() / "run.lcm";
  runtime::SimulationOptions options;
  options.file = machine_of_project(machine);
  options.program_roots = {folder.path()};
  options.programs = {{1, "part.nc"}};
  runtime::LogObserver observer(options.file, runtime::setup_of(options), log.string(), "test");
  EXPECT_TRUE(runtime::simulate(options, {&observer}, [] { return false; }).ok);
  EXPECT_EQ(observer.close(), "");
  const auto& file = options.file;
  LoggedTip tip(file.machine, file.machine.channels[0], part);
  std::vector<LoggedPlace> places;
  const auto error = for_each_place(log, tip, [&](const setpoint_t& setpoint, const auto& at) {
    ASSERT_TRUE(at);
    places.push_back({setpoint, *at});
  });
  EXPECT_FALSE(error);
  return places;
}

Vector programmed(const setpoint_t& setpoint) {
  return {setpoint.tip_position[0], setpoint.tip_position[1], setpoint.tip_position[2]};
}

TEST(LoggedTip, IsWhereTheWorkOffsetsAndTheLengthOfTheToolSay) {
  const Vector g54(1.0, 2.0, -3.0);
  PartSystem part{.scheme = 1};
  part.in_base.translation() = g54;
  const auto places = logged_places("mill3.toml",
                                    "G21 G90 G17\nG10 L2 P1 X1 Y2 Z-3\nG10 L2 P2 X6 Y9 Z-1\n"
                                    "G10 L1 P1 Z40\nT1 M6\nG54 G43 H1\nG1 X10 Y3 Z4 F6000\nG55\n"
                                    "X20 Y1 Z2\nM30\n",
                                    part);
  std::map<int, Vector> ends;
  for (const LoggedPlace& place : places) ends[place.setpoint.line] = place.on_part;
  ASSERT_TRUE(ends.contains(7) && ends.contains(9));
  EXPECT_LT((ends[7] - Vector(10.0, 3.0, 4.0)).norm(), 1e-9) << ends[7];
  EXPECT_LT((ends[9] - Vector(20.0 + 5.0, 1.0 + 7.0, 2.0 + 2.0)).norm(), 1e-9) << ends[9];
}

// The programmed point rides on the table (G43.4), and the log has it in each cycle.
TEST(LoggedTip, RidesOnTheTable) {
  const auto places = logged_places("trunnion.toml",
                                    "G21 G90 G17\nG10 L2 P1 X0 Y0 Z0\nT2 M6\nG54 G0 A0 C0\n"
                                    "G43.4 H2\nG0 X10 Y-5 Z80\nG1 A-30 C75 F3000\n"
                                    "X-12 Y9 Z70 A-10 C-140\nA0 C0\nG49\nM30\n",
                                    {.scheme = 1});
  int seen = 0;
  double most = 0.0;
  for (const LoggedPlace& place : places) {
    const bool is_moving = (place.setpoint.flags & 1) != 0;
    if (!is_moving || place.setpoint.line < 7 || place.setpoint.line > 9) continue;
    ++seen;
    most = std::max(most, (place.on_part - programmed(place.setpoint)).norm());
  }
  EXPECT_GT(seen, 1000);
  EXPECT_LT(most, 1e-8);
}

TEST(LoggedTip, IsNotToldUnderASchemeThatTheMachineDoesNotHave) {
  const auto file = machine_of_project("mill3.toml");
  const LoggedTip tip(file.machine, file.machine.channels[0], {.scheme = 1});
  setpoint_t setpoint{};
  setpoint.axis_count = 3;
  setpoint.scheme = 99;
  EXPECT_FALSE(tip.at(setpoint));
  setpoint.scheme = 1;
  setpoint.axis_count = -5;  // of a damaged log
  EXPECT_TRUE(tip.at(setpoint));
}

}  // namespace
}  // namespace stanok::jobs
