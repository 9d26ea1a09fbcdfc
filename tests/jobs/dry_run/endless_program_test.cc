// Programs without end on the virtual clock and in a check: time goes on, time-outs come, budgets
// end what only computes, and the log of such a run is repeated bit for bit.
#include <gtest/gtest.h>

#include <fstream>

#include "jobs/dry_run/dry_run.h"
#include "runtime/log_observer.h"
#include "runtime/program_files.h"
#include "runtime/replay.h"
#include "runtime/simulation.h"
#include "tests/config/temporary_files.h"
#include "tests/support/project_folders.h"

namespace stanok::jobs {
namespace {

class EndlessProgram : public ::testing::Test {
 protected:
  runtime::SimulationOptions options_on(const std::string& machine) {
    runtime::SimulationOptions options;
    options.file = config::read_machine_file(
        std::filesystem::path(stanok::testing::source_folder()) / "config" / "machines" / machine);
    options.program_roots = {files.folder()};
    return options;
  }
  DryRunResult checked(std::uint64_t steps) {
    auto machine = options_on("mill3.toml").file.machine;
    machine.program_bounds.steps = steps;
    const runtime::ProgramFiles texts({files.folder()}, runtime::program_format(machine));
    return check_program(machine, 1, -1, "p.nc", texts);
  }

  config::TemporaryFiles files;
};

TEST_F(EndlessProgram, LetsTheVirtualClockGoOn) {
  for (const char* text : {"while (true) { }\nM30\n", "while (true) { G1 X0 F100\n}\nM30\n",
                           "num aa;\nG1 X5 F600\nwhile (true) { aa += 1; }\nM30\n"}) {
    files.write("p.nc", text);
    runtime::SimulationOptions options = options_on("mill3.toml");
    options.programs = {{1, "p.nc"}};
    options.until_s = 2.0;
    const runtime::SimulationResult result = runtime::simulate(options, {}, [] { return false; });
    EXPECT_TRUE(result.until_reached) << text;
    EXPECT_EQ(result.cycles, 2000) << text;
  }
}

TEST_F(EndlessProgram, OfAWorkerIsTimedOutByItsMaster) {
  files.write("worker.nc", "while (true) { }\nM30\n");
  files.write("master.nc",
              "channel_run (1, \"worker.nc\");\n"
              "if (!channel_wait (1, 0.5)) { terminate (1006, \"late\"); }\nM30\n");
  runtime::SimulationOptions options = options_on("e7106mf4.toml");
  int master = 0;
  for (const auto& channel : options.file.machine.channels) {
    if (channel.kind == lang::ChannelKind::master) master = channel.id;
  }
  ASSERT_NE(master, 0);
  options.programs = {{master, "master.nc"}};
  options.until_s = 5.0;
  const runtime::SimulationResult result = runtime::simulate(options, {}, [] { return false; });
  ASSERT_FALSE(result.alarms.empty());
  EXPECT_EQ(result.alarms.front().channel, master);
  EXPECT_LT(result.alarms.front().cycle, 1000) << "0.5 s and what begins before";
}

TEST_F(EndlessProgram, IsEndedByItsBoundOfSteps) {
  files.write("p.nc", "while (true) { }\nM30\n");
  runtime::SimulationOptions options = options_on("mill3.toml");
  options.file.machine.program_bounds.steps = 30'000'000;
  options.programs = {{1, "p.nc"}};
  const runtime::SimulationResult result = runtime::simulate(options, {}, [] { return false; });
  ASSERT_EQ(result.alarms.size(), 1U);
  EXPECT_EQ(result.alarms[0].diagnostic.code, "E8005");
}

TEST_F(EndlessProgram, IsRepeatedFromItsLogBitForBit) {
  files.write("p.nc",
              "num aa;\nG1 X5 F600\n"
              "while (true) { for (aa = 0; aa < 9000000; aa += 1) { }\nG1 X6 F600\n"
              "G1 X0\n}\nM30\n");
  runtime::SimulationOptions options = options_on("mill3.toml");
  options.programs = {{1, "p.nc"}};
  options.until_s = 1.5;
  const std::filesystem::path path = files.folder() / "run.lcm";
  runtime::LogObserver log(options.file, runtime::setup_of(options), path.string(), "test");
  const runtime::SimulationResult result = runtime::simulate(options, {&log}, [] { return false; });
  EXPECT_EQ(log.close(), "");
  EXPECT_TRUE(result.until_reached);
  const runtime::ReplayResult repeated = runtime::replay(path, {});
  EXPECT_TRUE(repeated.is_same());
  EXPECT_GE(repeated.cycles, 1499);
}

TEST_F(EndlessProgram, IsAnErrorOfACheckWhenItOnlyComputes) {
  files.write("p.nc", "M5\nwhile (true) { }\nM30\n");
  const auto result = checked(2'000'000);
  ASSERT_EQ(result.diagnostics.size(), 1U);
  EXPECT_EQ(result.diagnostics[0].code, "E8005");
  EXPECT_EQ(result.diagnostics[0].place.line, 2);
}

TEST_F(EndlessProgram, IsAWarningOfACheckWhenItMoves) {
  files.write("p.nc", "while (true) { G1 X1 F600\nG1 X0\n}\nM30\n");
  const auto result = checked(2'000'000);
  ASSERT_EQ(result.diagnostics.size(), 1U);
  EXPECT_EQ(result.diagnostics[0].code, "W820");
  EXPECT_EQ(result.diagnostics[0].severity, Severity::warning);
  EXPECT_GT(result.blocks, 19'000U) << "hundred steps a block, and the instructions of the loop";
  EXPECT_LE(result.blocks, 20'004U);
}

TEST_F(EndlessProgram, IsNotWhatIsOnlyLong) {
  std::string text = "F600 G1\n";
  for (int k = 0; k < 40'000; ++k) text += k % 2 == 0 ? "X1\n" : "X0\n";
  files.write("p.nc", text + "M30\n");
  EXPECT_TRUE(checked(1'000'000).diagnostics.empty());
}

// The file has no content on the disk: reading it would take its size of memory.
TEST_F(EndlessProgram, OrOneOfManyGigabytesIsRefusedBeforeItIsRead) {
  files.write("p.nc", "M30\n");
  std::filesystem::resize_file(files.folder() / "p.nc", std::uintmax_t{1} << 40);
  const auto result = checked(1'000'000);
  ASSERT_EQ(result.diagnostics.size(), 1U);
  EXPECT_EQ(result.diagnostics[0].code, "E8004");
}

}  // namespace
}  // namespace stanok::jobs
