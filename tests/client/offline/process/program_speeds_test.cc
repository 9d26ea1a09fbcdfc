// The speeds of a part program: those of its moves at feed, each once.
#include "client/offline/process/program_speeds.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "tests/support/project_folders.h"
#include "tests/support/temporary_directory.h"

namespace stanok::client {
namespace {

std::vector<double> speeds_of(const std::string& text) {
  const stanok::testing::TemporaryDirectory folder;
  const auto file = folder.path() / "part.nc";
  std::ofstream(file) << text;
  JobOptions job;
  job.machine_file = stanok::testing::source_folder() + "/config/machines/mill3.toml";
  return speeds_of_program(file.string(), job);
}

TEST(ProgramSpeeds, AreThoseOfMovesAtFeed) {
  EXPECT_THAT(speeds_of("G21 G90 G54 G94 F200\nS5000 M3\nG0 X10\nS4000\nG1 X20\nS3000\nG2 X30 I5\n"
                        "S4000\nG1 X40\nM5\nG1 X50\nM30\n"),
              ::testing::ElementsAre(3000.0, 4000.0));
}

TEST(ProgramSpeeds, AProgramWithErrorsHasNone) {
  EXPECT_THROW(static_cast<void>(speeds_of("G1 X\nM30\n")), std::runtime_error);
}

}  // namespace
}  // namespace stanok::client
