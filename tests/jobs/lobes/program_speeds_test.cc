// The speeds of a part program: those of its moves at feed, each once.
#include "jobs/lobes/program_speeds.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "config/files/machine_file.h"
#include "runtime/program_files.h"
#include "tests/support/project_folders.h"
#include "tests/support/temporary_directory.h"

namespace stanok::jobs {
namespace {

ProgramSpeeds speeds_of(const std::string& text) {
  const stanok::testing::TemporaryDirectory folder;
  std::ofstream(folder.path() / "part.nc") << text;
  const auto machine =
      config::read_machine_file(stanok::testing::source_folder() + "/config/machines/mill3.toml")
          .machine;
  const runtime::ProgramFiles files({folder.path()}, runtime::program_format(machine));
  return program_speeds({.machine = machine, .program = "part.nc", .files = files});
}

TEST(ProgramSpeeds, AreThoseOfMovesAtFeed) {
  EXPECT_THAT(speeds_of("G21 G90 G54 G94 F200\nS5000 M3\nG0 X10\nS4000\nG1 X20\nS3000\nG2 X30 I5\n"
                        "S4000\nG1 X40\nM5\nG1 X50\nM30\n")
                  .rev_per_min,
              ::testing::ElementsAre(3000.0, 4000.0));
}

TEST(ProgramSpeeds, AProgramWithErrorsHasNone) {
  const ProgramSpeeds found = speeds_of("S1000 M3\nG1 X10 F100\nG1 X\nM30\n");
  EXPECT_TRUE(has_errors(found.diagnostics));
  EXPECT_TRUE(found.rev_per_min.empty());
}

}  // namespace
}  // namespace stanok::jobs
