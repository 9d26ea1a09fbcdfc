// What is shown after an emergency stop, with drives that coast: typed back, it moves no axis by
// more than an increment of its encoder.
#include <gtest/gtest.h>

#include "config/files/machine_file.h"
#include "lang/contract/meaning.h"
#include "tests/runtime/drive_bench.h"
#include "tests/support/chain/operator_session.h"
#include "tests/support/project_folders.h"
#include "tests/support/sanitized.h"

namespace stanok::runtime {
namespace {

std::string words_shown(DriveBench& bench) {
  lang::AxisValues point{};
  for (std::size_t k = 0; k < point.size(); ++k) point[k] = bench.output().point_W[k].value;
  const lang::AxisValues words =
      lang::words_at(bench.machine().situation(bench.output()).meaning, point);
  std::string line = "G90 G0";
  for (std::size_t k = 0; k < 3; ++k)
    line += std::string(" ") + "XYZ"[k] + std::to_string(words[k]);
  return line;
}

TEST(ShownWithDrives, AfterAnEmergencyStopLeadsWhereTheAxesStand) {
  for (int seed = 0; seed < testing::cases(20); ++seed) {
    testing::SeededChoices choices(static_cast<std::uint64_t>(seed) + 5320);
    DriveBench bench([](const std::filesystem::path&) {
      return config::read_machine_file(testing::source_folder() +
                                       "/config/machines/mill3_probe.toml");
    });
    bench.program("cut.nc", "G21 G90 G55 T1 M6 G43 H1\nG52 X3 Y-2\nG1 X40 Y20 Z300 F9000\nM30\n");
    ASSERT_EQ(bench.reply_to(bench.ask(channels::OperatorAction::program_run, "cut.nc")), "ok");
    bench.run(choices.between(0.0, 1.0));
    ASSERT_EQ(bench.reply_to(bench.ask(channels::OperatorAction::machine_estop)), "ok");
    bench.run(1.0);
    ASSERT_EQ(bench.reply_to(bench.ask(channels::OperatorAction::program_reset)), "ok");
    ASSERT_EQ(bench.reply_to(bench.ask(channels::OperatorAction::machine_on)), "ok");
    bench.run(1.0);
    const std::string line = words_shown(bench);
    std::array<double, 3> before{};
    for (std::size_t k = 0; k < before.size(); ++k) before[k] = bench.output().feedback[k].position;
    ASSERT_EQ(bench.reply_to(bench.ask(channels::OperatorAction::mdi, line)), "ok") << line;
    bench.run(1.0);
    for (std::size_t k = 0; k < before.size(); ++k) {
      const double increment = bench.machine_file().machine.axes[k].resolution;
      EXPECT_LE(std::abs(bench.output().feedback[k].position - before[k]), 1.001 * increment)
          << "seed " << seed << " axis " << k << " " << line;
    }
  }
}

}  // namespace
}  // namespace stanok::runtime
