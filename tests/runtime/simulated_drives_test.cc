// Runs on the virtual clock with simulated drives.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <chrono>
#include <thread>
#include <vector>

#include "runtime/simulation.h"
#include "tests/config/temporary_files.h"
#include "tests/support/project_folders.h"

namespace stanok::runtime {
namespace {

// Drives take some cycles to be switched on; the program starts when they hold their axes.
TEST(SimulatedDrives, ProgramWaitsForThemAndRuns) {
  const config::TemporaryFiles files;
  files.write("part.nc", "G1 X1 F600\nM30\n");
  SimulationOptions options;
  options.file = config::read_machine_file(std::filesystem::path(stanok::testing::source_folder()) /
                                           "config" / "machines" / "mill3.toml");
  options.program_roots = {files.folder()};
  options.programs = {{.channel = 1, .program = "part.nc"}};
  options.drives = DriveChoice::simulated;
  const SimulationResult result = simulate(options, {}, [] { return false; });
  EXPECT_TRUE(result.ok);
  ASSERT_EQ(result.runs.size(), 1U);
  EXPECT_EQ(result.runs[0].end_M[0], 1.0);
  EXPECT_GT(result.runs[0].start_cycle, 1);
}

config::MachineFile mill() {
  return config::read_machine_file(std::filesystem::path(stanok::testing::source_folder()) /
                                   "config" / "machines" / "mill3.toml");
}

// A poll is a matter of the bus: from 10 to 50 ms the drives follow, at full acceleration, too.
TEST(SimulatedDrives, FollowAtEveryPollOfTheContract) {
  const config::TemporaryFiles files;
  files.write("part.nc", "G1 X20 Y10 F3000\nG0 X100 Y50\nG1 X0 Y0 F6000\nM30\n");
  for (const int poll_ms : {10, 20, 30, 40, 50}) {
    SimulationOptions options;
    options.file = mill();
    options.file.bus.poll_ms = poll_ms;
    options.program_roots = {files.folder()};
    options.programs = {{.channel = 1, .program = "part.nc"}};
    options.drives = DriveChoice::simulated;
    const SimulationResult result = simulate(options, {}, [] { return false; });
    EXPECT_TRUE(result.ok) << poll_ms << " ms";
    for (const channels::AlarmReport& alarm : result.alarms)
      ADD_FAILURE() << alarm.diagnostic.code << " " << alarm.diagnostic.message;
  }
}

// Bits of the setpoints of a channel from the first cycle in which a program runs.
class SetpointBits final : public CycleObserver {
 public:
  void observe(const channels::CycleOutput& output) override {
    const channels::ChannelOutput& channel = output.channels[0];
    if (!channel.running) return;
    for (std::size_t k = 0; k < 3; ++k) {
      const channels::AxisSetpoint& axis = channel.axes[k];
      for (const double value : {axis.position, axis.velocity, axis.acceleration, axis.jerk})
        bits.push_back(std::bit_cast<std::uint64_t>(value));
    }
  }

  std::vector<std::uint64_t> bits;
};

// Drives follow setpoints; they do not change them. With a drive on the bus the spindle, too.
TEST(SimulatedDrives, SetpointsAreTheSameWithAndWithoutDrives) {
  const config::TemporaryFiles files;
  files.write("part.nc",
              "G17 G21 G90 G94 G64 P0.01\nM3 S3000\nG0 X10 Y5\nG1 Z-2 F600\nG2 X30 I10 F3000\n"
              "G1 X40 Y20\nG3 X20 Y20 R12\nM5\nG0 X0 Y0 Z0\nM30\n");
  const auto bits_with = [&](DriveChoice drives) {
    SimulationOptions options;
    options.file = mill();
    options.file.bus.spindles = {{.axis = "S1", .spindle = 1, .unit = 201}};
    options.program_roots = {files.folder()};
    options.programs = {{.channel = 1, .program = "part.nc"}};
    options.drives = drives;
    SetpointBits bits;
    EXPECT_TRUE(simulate(options, {&bits}, [] { return false; }).ok);
    return bits.bits;
  };
  const std::vector<std::uint64_t> ideal = bits_with(DriveChoice::ideal);
  const std::vector<std::uint64_t> simulated = bits_with(DriveChoice::simulated);
  ASSERT_GT(ideal.size(), 12U * 1000U);
  EXPECT_EQ(simulated, ideal);
}

// mill3 ramps with 8000 rev/min/s; a poll is 10 ms.
TEST(SimulatedDrives, ASpindleWithADriveOfItsOwnTurnsAsItIsProgrammed) {
  const config::TemporaryFiles files;
  files.write("part.nc", "M4 S2000\nG4 P1\nM5\nG4 P1\nM30\n");
  config::MachineFile file = mill();
  file.bus.spindles = {{.axis = "S1",
                        .spindle = 1,
                        .unit = 201,
                        .kind = drives::DriveKind::velocity,
                        .map = drives::register_map({.velocity_scale = 1.0})}};
  Assembly assembly({.file = file,
                     .drives = DriveChoice::simulated,
                     .program_roots = {files.folder()},
                     .machine = {.on_at_start = true, .stops_go_on = true},
                     .output_capacity = 0});
  channels::OperatorEvent start;
  start.command = channels::commands::ProgramRun{channels::ShortText("part.nc")};
  start.channel = 1;
  const auto cycle = [&](std::span<const channels::OperatorEvent> events) {
    while (assembly.machine().prepare(0) != channels::Progress::blocked) {
    }
    assembly.cycle(events);
  };
  for (int n = 0; n < 100; ++n) cycle({});
  cycle({&start, 1});
  const auto spindle = [&] { return assembly.drive_status().axes.at(3).feedback; };
  for (int n = 0; n < 900; ++n) cycle({});
  EXPECT_EQ(assembly.drive_status().axes.at(3).axis, "S1");
  EXPECT_EQ(spindle().velocity, -2000.0);
  EXPECT_EQ(spindle().state, drives::DriveState::operation_enabled);
  EXPECT_GT(spindle().power_w, 0.0);
  for (int n = 0; n < 1000; ++n) cycle({});
  EXPECT_EQ(spindle().velocity, 0.0);
  EXPECT_NE(spindle().state, drives::DriveState::operation_enabled);
  EXPECT_TRUE(assembly.machine().alarms().empty());
}

// Output 3 is wired to input 40 on a module of the embedded server: the program waits for what it
// has switched on itself, and the change of the input is recorded.
TEST(EmbeddedDrives, ProgramsReachSignalsOnTheBus) {
  const config::TemporaryFiles files;
  files.write("part.nc",
              "M64 P3\nM66 P40 L3 Q5\nif (#5399 != 1) { terminate (1010, \"no input\"); }\nM30\n");
  config::MachineFile file = mill();
  file.bus.poll_ms = 2;
  file.bus.signals = {{.kind = drives::SignalKind::digital_output,
                       .number = 3,
                       .unit = 30,
                       .field = {.address = 17}},
                      {.kind = drives::SignalKind::digital_input,
                       .number = 40,
                       .unit = 30,
                       .table = drives::SignalTable::discrete_input,
                       .field = {.address = 17}}};
  Assembly assembly({.file = file,
                     .drives = DriveChoice::embedded,
                     .program_roots = {files.folder()},
                     .machine = {.on_at_start = true, .stops_go_on = true},
                     .output_capacity = 0});
  assembly.start();
  const auto cycle = [&](std::span<const channels::OperatorEvent> events) {
    while (assembly.machine().prepare(0) != channels::Progress::blocked) {
    }
    assembly.cycle(events);
    std::this_thread::sleep_for(std::chrono::milliseconds{1});
  };
  const auto all_enabled = [&] {
    const auto feedback = assembly.feedback();
    return std::ranges::all_of(feedback, &channels::AxisFeedback::enabled);
  };
  int cycles = 0;
  do cycle({});
  while (!all_enabled() && ++cycles < 10000);
  channels::OperatorEvent start;
  start.command = channels::commands::ProgramRun{channels::ShortText("part.nc")};
  start.channel = 1;
  cycle({&start, 1});
  while (!assembly.machine().is_idle() && ++cycles < 20000) cycle({});
  assembly.stop();
  ASSERT_EQ(assembly.machine().runs().size(), 1U);
  EXPECT_TRUE(assembly.machine().runs()[0].ok);
  bool is_recorded = false;
  channels::InputRecord record;
  while (assembly.machine().input_records().pop(record)) {
    const auto* input = std::get_if<channels::DigitalInput>(&record.content);
    is_recorded = is_recorded || (input != nullptr && input->number == 40 && input->is_on);
  }
  EXPECT_TRUE(is_recorded);
}

}  // namespace
}  // namespace stanok::runtime
