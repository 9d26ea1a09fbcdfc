// Rigid taps at random: those that `check` takes run to their end, those that the axes cannot
// follow are refused before the tap, with a speed at which they go.
#include <gtest/gtest.h>

#include <random>
#include <regex>
#include <sstream>

#include "config/files/machine_file.h"
#include "jobs/dry_run/dry_run.h"
#include "runtime/program_files.h"
#include "runtime/simulation.h"
#include "tests/config/temporary_files.h"
#include "tests/support/project_folders.h"

namespace stanok::jobs {
namespace {

struct Tap {
  double rev_per_min = 0.0;
  double lead_mm = 0.0;
  double depth_mm = 0.0;
  double back = 1.0;  // times as fast on the way out

  [[nodiscard]] std::string program() const {
    std::ostringstream text;
    text << "G18 G8 G90 G97 S" << rev_per_min << " M3\nG0 X0 Z50\nG33.1 Z" << 50.0 - depth_mm
         << " K" << lead_mm << " I" << back << "\nM30\n";
    return text.str();
  }
};

Tap random_tap(std::mt19937_64& random) {
  const auto between = [&](double low, double high) {
    return low * std::pow(high / low, std::uniform_real_distribution<double>(0.0, 1.0)(random));
  };
  return {.rev_per_min = std::floor(between(50.0, 4000.0)),
          .lead_mm = std::floor(100.0 * between(0.25, 4.0)) / 100.0,
          .depth_mm = std::floor(10.0 * between(0.3, 40.0)) / 10.0,
          .back = random() % 3 == 0 ? 2.0 : 1.0};
}

class TapForecast : public ::testing::Test {
 protected:
  [[nodiscard]] Diagnostics check(const Tap& tap) {
    files_.write("tap.nc", tap.program());
    const runtime::ProgramFiles files({files_.folder()}, runtime::program_format(file_.machine));
    return check_program(file_.machine, 1, -1, "tap.nc", files).diagnostics;
  }
  // The code of what ended the run; empty: nothing did.
  [[nodiscard]] std::string run(const Tap& tap) {
    files_.write("tap.nc", tap.program());
    runtime::SimulationOptions options;
    options.file = file_;
    options.program_roots = {files_.folder()};
    options.programs = {{.channel = 1, .program = "tap.nc"}};
    const runtime::SimulationResult result = runtime::simulate(options, {}, [] { return false; });
    if (result.ok) return "";
    return result.alarms.empty() ? "no alarm" : result.alarms[0].diagnostic.code;
  }

  config::TemporaryFiles files_;
  config::MachineFile file_ = config::read_machine_file(
      std::filesystem::path(stanok::testing::source_folder()) / "config/machines/lathe.toml");
};

TEST_F(TapForecast, WhatItTakesRunsToItsEnd) {
  std::mt19937_64 random(7);
  int taken = 0;
  int refused = 0;
  for (int n = 0; n < 60; ++n) {
    const Tap tap = random_tap(random);
    SCOPED_TRACE(tap.program());
    const Diagnostics found = check(tap);
    const std::string ended_by = run(tap);
    if (found.empty()) {
      ++taken;
      EXPECT_EQ(ended_by, "");
      continue;
    }
    EXPECT_EQ(found[0].code, ended_by);
    EXPECT_EQ(found[0].place.line, 3);
    if (found[0].code != "A4001") continue;
    ++refused;
    std::smatch speed;
    const std::string help = found[0].help.at(0);
    if (!std::regex_search(help, speed, std::regex("at most S([0-9]+)"))) continue;
    Tap slower = tap;
    slower.rev_per_min = std::stod(speed[1]);
    EXPECT_LT(slower.rev_per_min, tap.rev_per_min);
    EXPECT_TRUE(check(slower).empty()) << help;
    EXPECT_EQ(run(slower), "") << help;
  }
  EXPECT_GT(taken, 20);
  EXPECT_GT(refused, 5);
}

}  // namespace
}  // namespace stanok::jobs
