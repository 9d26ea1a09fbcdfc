// Homing and jogging with simulated drives on the virtual clock: switches, encoders and the
// exchange of every poll are those of the plant.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <random>

#include "runtime/simulation.h"
#include "tests/runtime/drive_bench.h"
#include "tests/support/project_folders.h"

namespace stanok::runtime {
namespace {

constexpr double mm = 1e-3;  // the drives count in thousandths

// Five axes, switches and starting places at random, some of them in the same order: afterwards
// every axis knows its place, to what it goes in a poll at the slow velocity.
TEST(Homing, FiveAxesInAnyOrderOfTheirSwitches) {
  std::mt19937_64 random(17);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  for (int trial = 0; trial < 12; ++trial) {
    SCOPED_TRACE(trial);
    std::vector<AxisPlace> axes(5);
    for (AxisPlace& axis : axes) {
      axis.home_from = -95.0 + 160.0 * part(random);
      axis.home_to = axis.home_from + 10.0 + 15.0 * part(random);
      axis.velocity = (part(random) < 0.5 ? 1.0 : -1.0) * (10.0 + 30.0 * part(random));
      axis.start = -99.0 + 198.0 * part(random);
      axis.order = 1 + static_cast<int>(3.0 * part(random));
    }
    DriveBench bench(axes);
    for (std::size_t k = 0; k < 5; ++k) EXPECT_FALSE(bench.is_homed(k));
    EXPECT_EQ(bench.reply_to(bench.ask(OperatorAction::program_run, "part.nc")), "E5208");
    ASSERT_EQ(bench.reply_to(bench.ask(OperatorAction::home)), "ok") << bench.text();
    for (std::size_t k = 0; k < 5; ++k) EXPECT_TRUE(bench.is_homed(k)) << k;
    // Proof of the place: a jog to the travel's end stops there, and the limit switch, 5 mm behind
    // it in the machine, stays off.
    for (std::size_t k = 0; k < 5; ++k) {
      const auto id = bench.ask(OperatorAction::jog, std::string(1, "XYZUV"[k]), 150.0,
                                99.0 - bench.setpoint(k));
      ASSERT_EQ(bench.reply_to(id), "ok") << bench.text();
      bench.run(4.0);
      EXPECT_NEAR(bench.output().feedback[k].position, 99.0, 5.0 * mm);
      EXPECT_FALSE(bench.output().feedback[k].limit_positive);
    }
    ASSERT_EQ(bench.reply_to(bench.ask(OperatorAction::program_run, "part.nc")), "ok")
        << bench.text();
  }
}

// In scheme 1 of this machine B and C are parked at 0, braked and without power.
TEST(Homing, ParkedAxesAreReleasedForItAndParkedAgain) {
  DriveBench bench([](const std::filesystem::path&) {
    return config::read_machine_file(std::filesystem::path(stanok::testing::source_folder()) /
                                     "config" / "machines" / "e7106mf4.toml");
  });
  ASSERT_EQ(bench.reply_to(bench.ask(OperatorAction::home)), "ok") << bench.text();
  bench.run(0.5);
  for (const std::size_t parked : {3U, 4U}) {
    EXPECT_NEAR(bench.setpoint(parked), 0.0, 1e-9);
    EXPECT_TRUE(bench.output().feedback[parked].brake_closed);
    EXPECT_FALSE(bench.output().feedback[parked].enabled);
  }
  const double marks[] = {-445.0, 295.0, 345.0};
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(bench.setpoint(k), marks[k], 0.1);
    EXPECT_TRUE(bench.output().feedback[k].enabled);
  }
}

TEST(Homing, OneAxisByName) {
  DriveBench bench({{.home_from = 50.0, .home_to = 60.0}, {.home_from = 50.0, .home_to = 60.0}});
  ASSERT_EQ(bench.reply_to(bench.ask(OperatorAction::home, "Y")), "ok");
  EXPECT_FALSE(bench.is_homed(0));
  EXPECT_TRUE(bench.is_homed(1));
  EXPECT_EQ(bench.reply_to(bench.ask(OperatorAction::home, "W")), "E6052");
}

// Where C is behind the latest index pulse, while it is an axis.
class AngleBehindIndex final : public CycleObserver {
 public:
  void observe(const channels::CycleOutput& output) override {
    const channels::ChannelOutput& channel = output.channels[0];
    const channels::AxisFeedback& drive = channel.feedback[2];
    if (!channel.drives[2].follows_velocity && drive.index_count > 0)
      last = std::remainder(drive.position - drive.index_position, 360.0);
  }
  double last = 0.0;
};

// M902 on a spindle whose encoder counts from where it was switched on: it turns to its index
// pulse, wherever that is, and C reads the machine's angle.
TEST(Homing, ASpindleThatBecomesAnAxisTurnsToItsIndexPulse) {
  std::ifstream stream(stanok::testing::source_folder() + "/config/machines/lathe.toml");
  std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  text.replace(text.find("tables = "), std::string("tables = \"lathe/tables.toml\"").size(), "");
  const std::string last_key = "jerk_max = 36000.0\n";
  const std::string search =
      "[axis.homing]\norder = 1\nvelocity = 120\nvelocity_slow = 60\nhome_switch = \"index\"\n"
      "[axis.plant]\nencoder = \"incremental\"\nindex_pitch = 360\nindex_position = 25\n";
  text.insert(text.find(last_key) + last_key.size(), search);
  text += "\n[drives]\nbus = \"modbus-tcp\"\n";
  const config::TemporaryFiles files;
  files.write("part.nc", "M3 S300\nG4 P0.4\nM5\nM902\nG94 G0 C90\nG4 P0.5\nM903\nM30\n");
  SimulationOptions options;
  options.file = config::read_machine_file(files.write("lathe.toml", text));
  options.program_roots = {files.folder()};
  options.programs = {{.channel = 1, .program = "part.nc"}};
  options.drives = DriveChoice::simulated;
  AngleBehindIndex angle;
  const SimulationResult result = simulate(options, {&angle}, [] { return false; });
  EXPECT_TRUE(result.ok) << (result.alarms.empty() ? "" : result.alarms[0].diagnostic.message);
  // The index pulse reads `position`, 0: C90 is 90 deg behind it, in the latched counts, too.
  EXPECT_NEAR(angle.last, 90.0, 0.1);
}

TEST(Homing, SaysWhatItDidNotFindAndLeavesTheAxisWithoutReference) {
  DriveBench bench({{.home_from = 150.0, .home_to = 160.0}});  // behind both limit switches
  EXPECT_EQ(bench.reply_to(bench.ask(OperatorAction::home)), "A2001");
  EXPECT_EQ(bench.text(), "axis X: there is no home switch between the limit switches");
  EXPECT_FALSE(bench.is_homed(0));
}

TEST(Homing, AResetStopsIt) {
  DriveBench bench({{.home_from = 80.0, .home_to = 95.0, .start = -90.0}});
  const auto id = bench.ask(OperatorAction::home);
  bench.run(1.0);
  EXPECT_GT(bench.output().axes[0].velocity, 1.0);
  bench.ask(OperatorAction::program_reset);
  EXPECT_EQ(bench.reply_to(id), "A2001");
  bench.run(0.5);
  EXPECT_EQ(bench.output().axes[0].velocity, 0.0);
  EXPECT_FALSE(bench.is_homed(0));
}

// A lease of 200 ms: without renewal the axis is at rest soon after, and went no further than the
// speed and the brake take it: 20 mm/s for 0.2 s, and D = v T / 2 = 0.63 mm.
TEST(Jogging, EndsWhenItIsNotRenewed) {
  DriveBench bench({{.home_from = 50.0, .home_to = 60.0}});
  const double from = bench.setpoint(0);
  ASSERT_EQ(bench.reply_to(bench.ask(OperatorAction::jog, "X", 20.0)), "ok");
  bench.run(0.5);
  EXPECT_EQ(bench.output().axes[0].velocity, 0.0);
  EXPECT_GT(bench.setpoint(0) - from, 2.0);
  EXPECT_LT(bench.setpoint(0) - from, 20.0 * 0.2 + 0.7);
}

TEST(Jogging, GoesOnWhileItIsRenewed) {
  DriveBench bench({{.home_from = 50.0, .home_to = 60.0}});
  const double from = bench.setpoint(0);
  for (int k = 0; k < 20; ++k) {
    bench.ask(OperatorAction::jog, "X", -10.0);
    bench.run(0.1);
  }
  EXPECT_NEAR(bench.setpoint(0) - from, -20.0, 0.5);
  bench.run(0.5);
  EXPECT_EQ(bench.output().axes[0].velocity, 0.0);
}

TEST(Jogging, TheOtherDirectionStopsItAtOnce) {
  DriveBench bench({{.home_from = 50.0, .home_to = 60.0}});
  bench.ask(OperatorAction::jog, "X", 20.0);
  bench.run(0.15);
  const double at = bench.setpoint(0);
  EXPECT_EQ(bench.reply_to(bench.ask(OperatorAction::jog, "X", -20.0)), "E6056");
  bench.run(0.3);
  EXPECT_EQ(bench.output().axes[0].velocity, 0.0);
  EXPECT_LT(bench.setpoint(0) - at, 1.0);  // braking: v T / 2 = 0.63 mm
  EXPECT_EQ(bench.reply_to(bench.ask(OperatorAction::jog, "X", -20.0)), "ok");
}

// Without a reference a jog may run onto the limit switch: everything stops with an alarm, and the
// way back is free when the alarm has been reset.
TEST(Jogging, LimitSwitchStopsItAndTheWayBackIsFree) {
  DriveBench bench({{.home_from = 50.0, .home_to = 60.0, .start = 95.0}});
  ASSERT_EQ(bench.reply_to(bench.ask(OperatorAction::jog, "X", 20.0, 30.0)), "ok");
  bench.run(2.0);
  EXPECT_EQ(bench.output().state, channels::ChannelState::alarm);
  EXPECT_TRUE(bench.output().feedback[0].limit_positive);
  ASSERT_EQ(bench.reply_to(bench.ask(OperatorAction::program_reset)), "ok");
  ASSERT_EQ(bench.reply_to(bench.ask(OperatorAction::machine_on)), "ok");
  bench.run(1.0);
  EXPECT_EQ(bench.reply_to(bench.ask(OperatorAction::jog, "X", 20.0, 1.0)), "E6057");
  ASSERT_EQ(bench.reply_to(bench.ask(OperatorAction::jog, "X", -20.0, 10.0)), "ok") << bench.text();
  bench.run(2.0);
  EXPECT_FALSE(bench.output().feedback[0].limit_positive);
  EXPECT_NE(bench.output().state, channels::ChannelState::alarm);
}

TEST(Jogging, KeepsTheTravelOfAnAxisWithReference) {
  DriveBench bench({{.home_from = 50.0, .home_to = 60.0}});
  ASSERT_EQ(bench.reply_to(bench.ask(OperatorAction::home)), "ok");
  EXPECT_EQ(bench.reply_to(bench.ask(OperatorAction::jog, "X", 50.0, 200.0)), "E6053");
  for (int k = 0; k < 30; ++k) {
    bench.ask(OperatorAction::jog, "X", 150.0);
    bench.run(0.1);
  }
  EXPECT_EQ(bench.setpoint(0), 100.0);
  EXPECT_NE(bench.output().state, channels::ChannelState::alarm);
}

TEST(Jogging, OfAParkedAxisSaysThatItIsParked) {
  DriveBench bench([](const std::filesystem::path&) {
    return config::read_machine_file(std::filesystem::path(stanok::testing::source_folder()) /
                                     "config" / "machines" / "e7106mf4.toml");
  });
  ASSERT_EQ(bench.reply_to(bench.ask(OperatorAction::home)), "ok") << bench.text();
  EXPECT_EQ(bench.reply_to(bench.ask(OperatorAction::jog, "B", 5.0, 1.0)), "E6058");
  EXPECT_NE(bench.text().find("parks the axis"), std::string::npos) << bench.text();
  ASSERT_EQ(bench.reply_to(bench.ask(OperatorAction::machine_off)), "ok");
  bench.run(1.0);
  EXPECT_EQ(bench.reply_to(bench.ask(OperatorAction::jog, "B", 5.0, 1.0)), "E6006");
}

TEST(Jogging, IsRefusedWhereItMakesNoSense) {
  DriveBench bench({{.home_from = 50.0, .home_to = 60.0}});
  EXPECT_EQ(bench.reply_to(bench.ask(OperatorAction::jog, "X", 0.0)), "E6054");
  EXPECT_EQ(bench.reply_to(bench.ask(OperatorAction::jog, "Q", 1.0)), "E6052");
  bench.ask(OperatorAction::home);
  bench.run(0.2);
  EXPECT_EQ(bench.reply_to(bench.ask(OperatorAction::jog, "X", 1.0)), "E6056");
  EXPECT_EQ(bench.reply_to(bench.ask(OperatorAction::program_run, "part.nc")), "E6056");
}

}  // namespace
}  // namespace stanok::runtime
