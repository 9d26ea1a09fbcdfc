// A milling program with its workpiece, its log, and what is found in it: forces of a material and
// a sensor that are worked out here from width and depth of the cuts.
#include "jobs/cutting/milling_log.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>
#include <random>

#include "runtime/log_observer.h"
#include "runtime/simulation.h"
#include "tests/support/project_folders.h"
#include "tests/support/temporary_directory.h"

namespace stanok::jobs {
namespace {

const std::string mill_file = stanok::testing::source_folder() + "/config/machines/e7106mf4.toml";

constexpr double force_n_per_mm2 = 1150.0;
constexpr double edge_n_per_mm = 14.0;
constexpr double lag_s = 0.03;
constexpr double idle_linear = 0.05;
constexpr double idle_square = 4e-6;
constexpr double noise = 0.05;

// Tool 3: end mill of 6 mm. Slots with two feeds, then 3 mm of width, at two speeds; the walls of
// the blank stand in X at 0 and 60.
constexpr const char* cut_program =
    "G21 G90 G17 G40 G49 G80 G54 G94 G64\n"
    "#workpiece (0, 0.15, 0, 60, 40, 10, 0, 0, 10)\n"
    "T3 M6\n"
    "S6000 M3\n"
    "G0 X-6 Y10\n"
    "G43 H3 Z50\n"
    "G0 Z-2\n"
    "G1 X66 F600\n"  // 8: slot
    "G0 Z2\nG0 X-6 Y13\nG0 Z-2\n"
    "G1 X66 F1500\n"  // 12: 3 mm, against the feed
    "G0 Z2\nG0 X-6 Y22\nS4000 M3\nG4 P1\nG0 Z-2\n"
    "G1 X66 F400\n"  // 18: slot
    "G0 Z2\nG0 X-6 Y25\nG0 Z-2\n"
    "G1 X66 F1200\n"  // 22: 3 mm
    "G0 Z50\nG49 M5\nM30\n";

constexpr double radius = 3.0;
constexpr double length = 60.0;  // of the blank
constexpr double depth = 2.0;

// Quarters of the tool that meet the material: two in a slot, one at the side of it.
struct CutLine {
  std::uint32_t line;
  int quarters;
};
constexpr CutLine cut_lines[] = {{8, 2}, {12, 1}, {18, 2}, {22, 1}};

// Of a quarter in front of a middle at x: width across the feed and arc between the two ends of the
// blank.
struct Quarter {
  double width = 0.0;
  double arc = 0.0;
};
Quarter quarter_at(double x) {
  // From the feed on, up to this angle the quarter lies in front of a wall that is `ahead` of its
  // middle.
  const auto beyond = [](double ahead) { return std::acos(std::clamp(ahead / radius, 0.0, 1.0)); };
  if (x <= -radius || x >= length) return {};
  const double to = x < 0.0 ? beyond(-x) : 0.5 * std::numbers::pi;
  const double from = beyond(length - x);
  return {.width = radius * (std::sin(to) - std::sin(from)), .arc = to - from};
}

class Plant final : public runtime::CycleObserver {
 public:
  void observe(const channels::CycleOutput& output) override {
    const channels::ChannelOutput& channel = output.channels[0];
    const double n = std::abs(channel.process.spindle_rev_per_min);
    const double x = channel.point_W[0].value;
    const double speed = std::abs(x - x_before_) / 0.001;
    x_before_ = x;
    double wanted = 0.0;
    const auto* const cut = std::ranges::find(cut_lines, channel.tag.line, &CutLine::line);
    if (cut != std::end(cut_lines)) {
      const Quarter quarter = quarter_at(x);
      const double volume = cut->quarters * quarter.width * depth * speed;
      const double rubbed = 3.0 * depth * cut->quarters * quarter.arc * radius * n / 60.0;
      wanted = 1e-3 * (force_n_per_mm2 * volume + edge_n_per_mm * rubbed);
    }
    power_ += (wanted - power_) * (1.0 - std::exp(-0.001 / lag_s));
    rev_per_min.push_back(n);
    cut_w.push_back(power_);
  }
  std::vector<double> rev_per_min;
  std::vector<double> cut_w;

 private:
  double x_before_ = 0.0;
  double power_ = 0.0;
};

TEST(MillingLogOfAProgram, TellsForcesAndIdlePower) {
  const stanok::testing::TemporaryDirectory folder;
  std::ofstream(folder.path() / "part.nc") << cut_program;
  runtime::SimulationOptions options;
  options.file = config::read_machine_file(mill_file);
  options.program_roots = {folder.path()};
  options.programs = {{.channel = 1, .program = "part.nc"}};
  Plant plant;
  ASSERT_TRUE(runtime::simulate(options, {&plant}, [] { return false; }).ok);
  std::mt19937 random(20267);
  std::normal_distribution<double> gauss(0.0, noise);
  for (std::size_t k = 0; k < plant.cut_w.size(); k += 10) {
    const double n = plant.rev_per_min[k];
    runtime::SensorRow row{.t = 0.001 * static_cast<double>(k), .spindles = {}};
    row.spindles.resize(1);
    row.spindles[0].power_w =
        std::round(n * (idle_linear + idle_square * n) + plant.cut_w[k] * (1.0 + gauss(random)));
    options.sensors.push_back(row);
  }
  const std::string log_file = folder.path() / "part.log";
  {
    runtime::LogObserver log(options.file, runtime::setup_of(options), log_file, "test");
    ASSERT_TRUE(runtime::simulate(options, {&log}, [] { return false; }).ok);
  }

  MillingLogRequest request;
  request.cut.teeth = 3;
  const MillingLog log = read_milling_log(log_file, request);
  const auto fit = process::fit_milling(log.record);
  ASSERT_TRUE(fit.has_value()) << fit.error();
  EXPECT_FALSE(fit->verdict.is_refused()) << fit->verdict.reason;
  RecordProperty("force", std::to_string(fit->force_n_per_mm2.value));
  RecordProperty("edge", std::to_string(fit->edge_n_per_mm.value));
  // The virtual workpiece knows the cut to about a hundredth.
  EXPECT_NEAR(fit->force_n_per_mm2.value, force_n_per_mm2, 0.05 * force_n_per_mm2);
  EXPECT_NEAR(fit->edge_n_per_mm.value, edge_n_per_mm, 0.1 * edge_n_per_mm);
  EXPECT_NEAR(fit->idle_w(5000.0), 5000.0 * (idle_linear + idle_square * 5000.0), 2.0);
  EXPECT_NEAR(fit->lag_s.value, lag_s, 0.02);
}

}  // namespace
}  // namespace stanok::jobs
