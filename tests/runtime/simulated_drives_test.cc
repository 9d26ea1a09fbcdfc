// Runs on the virtual clock with simulated drives.
#include <gtest/gtest.h>

#include "runtime/simulation.h"
#include "tests/config/temporary_files.h"

namespace stanok::runtime {
namespace {

// Drives take some cycles to be switched on; the program starts when they hold their axes.
TEST(SimulatedDrives, ProgramWaitsForThemAndRuns) {
  const config::TemporaryFiles files;
  files.write("part.nc", "G1 X1 F600\nM30\n");
  SimulationOptions options;
  options.file = config::read_machine_file(std::filesystem::path(STANOK_SOURCE_DIR) / "config" /
                                           "machines" / "mill3.toml");
  options.program_roots = {files.folder()};
  options.programs = {{.channel = 1, .program = "part.nc"}};
  options.drives = DriveChoice::simulated;
  const SimulationResult result = simulate(options, {}, [] { return false; });
  EXPECT_TRUE(result.ok);
  ASSERT_EQ(result.runs.size(), 1U);
  EXPECT_EQ(result.runs[0].end_M[0], 1.0);
  EXPECT_GT(result.runs[0].start_cycle, 1);
}

}  // namespace
}  // namespace stanok::runtime
