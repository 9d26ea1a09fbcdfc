// A plunge cycle of the grinder of config/machines, its log, and what is found in it: stiffness and
// force law of a hidden machine whose spring and surface are worked out here.
#include "jobs/cutting/grind_log.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <numbers>
#include <random>

#include "base/place.h"
#include "config/files/grinding_file.h"
#include "jobs/cutting/found_figures.h"
#include "jobs/cutting/identification.h"
#include "runtime/log_observer.h"
#include "runtime/simulation.h"
#include "tests/support/project_folders.h"
#include "tests/support/temporary_directory.h"

namespace stanok::jobs {
namespace {

const std::string grinder_file = stanok::testing::source_folder() + "/config/machines/grinder.toml";
const std::string sheet_file =
    stanok::testing::source_folder() + "/programs/examples/plunge_grinding.toml";
constexpr double idle_w = 850.0;
constexpr double watts_per_newton = 0.34 * 35.0 / 0.85;

// Two steps of feed, and a spark-out of six revolutions.
constexpr const char* cycle_text =
    "G21 G90 G18 G8 G40 G94 G54 G64\nG52 X30\n$2 S1671 M3\n$1 S120 M3\nG0 X0.35\nG1 X0.3 F1.8\n"
    "G1 X0.15 F1.8\nG1 X0.05 F0.72\nG1 X0 F0.24\nG4 P3\nG0 X5\nG52 X0\nM5 $-1\nM30\n";

process::GrindingProcess hidden_machine() {
  process::GrindingProcess process = config::read_grinding_file(sheet_file).process;
  process.stiffness_n_per_m = 17.5e6;
  process.force_factor = 4.4;
  process.force_exponent = 0.62;
  return process;
}

struct PlaceObserver final : public runtime::CycleObserver {
  void observe(const channels::CycleOutput& output) override {
    x_mm.push_back(output.channels[0].point_W[0].value);
  }
  std::vector<double> x_mm;
};

// N, at the end of each cycle; semi-implicit steps of a fortieth of a millisecond.
std::vector<double> forces(const process::GrindingProcess& p, const std::vector<double>& x_mm) {
  constexpr int steps = 40;
  constexpr double dt = 0.001 / steps;
  std::vector<double> depth(checked_size(std::lround(60.0 / p.part_speed_rpm / dt)), 0.0);
  const double R = p.part_radius_mm * p.wheel_radius_mm / (p.part_radius_mm + p.wheel_radius_mm);
  const double V = 2.0 * std::numbers::pi * p.part_radius_mm * p.part_speed_rpm / 1000.0;
  double y = 0.0;
  double v = 0.0;
  std::size_t angle = 0;
  std::vector<double> all;
  double force = 0.0;
  for (std::size_t k = 0; k < x_mm.size(); ++k) {
    const double before = k > 0 ? x_mm[k - 1] : x_mm[k];
    for (int n = 1; n <= steps; ++n) {
      const double x = before + (x_mm[k] - before) * n / steps;
      const double layer = std::max(0.0, 0.3 - x - y - depth[angle]);
      force = p.force_factor * p.width_mm * std::pow(R * layer * V, p.force_exponent);
      v += dt * 1000.0 / p.mass_kg *
           (force - p.damping_n_s_per_m / 1000.0 * v - p.stiffness_n_per_m / 1000.0 * y);
      y += dt * v;
      depth[angle] += std::max(0.0, 0.3 - x - y - depth[angle]);
      angle = angle + 1 == depth.size() ? 0 : angle + 1;
    }
    all.push_back(force);
  }
  return all;
}

runtime::SimulationOptions options_in(const std::filesystem::path& folder) {
  std::ofstream(folder / "cycle.nc") << cycle_text;
  runtime::SimulationOptions options;
  options.file = config::read_machine_file(grinder_file);
  options.program_roots = {folder};
  options.programs = {{.channel = 1, .program = "cycle.nc"}};
  return options;
}

class GrindLogOfACycle : public ::testing::Test {
 protected:
  void SetUp() override {
    runtime::SimulationOptions options = options_in(folder_.path());
    PlaceObserver places;
    ASSERT_TRUE(runtime::simulate(options, {&places}, [] { return false; }).ok);
    const std::vector<double> force = forces(hidden_machine(), places.x_mm);
    std::mt19937 random(20269);
    std::normal_distribution<double> gauss(0.0, 0.05);
    for (std::size_t k = 0; k < force.size(); k += 10) {
      runtime::SensorRow row{.t = 0.001 * static_cast<double>(k), .spindles = {}};
      row.spindles.resize(2);
      row.spindles[1].power_w =
          std::round(idle_w + watts_per_newton * force[k] * (1.0 + gauss(random)));
      options.sensors.push_back(row);
    }
    runtime::LogObserver log(options.file, runtime::setup_of(options), log_file(), "test");
    ASSERT_TRUE(runtime::simulate(options, {&log}, [] { return false; }).ok);
  }
  [[nodiscard]] std::string log_file() const { return folder_.path() / "cycle.log"; }

  static GrindLogRequest request() {
    return {.channel = 1, .spindle = 1, .allowance_mm = 0.3, .watts_per_newton = watts_per_newton};
  }
  stanok::testing::TemporaryDirectory folder_;
};

// An interval of 95 % is 1.96 standard deviations wide to either side; one run in four hundred is
// beyond three.
void expect_near(const process::Estimate& estimate, double truth) {
  EXPECT_NEAR(estimate.value, truth, 3.0 / 1.96 * estimate.half_width());
}

TEST_F(GrindLogOfACycle, TellsStiffnessAndForceLaw) {
  const GrindLog log = read_grind_log(log_file(), request());
  ASSERT_GT(log.record.rows.size(), 15000U);
  EXPECT_GT(log.record.rows.front().x_mm, 0.3) << "idle in front of the touch";
  const process::GrindingProcess sheet = config::read_grinding_file(sheet_file).process;
  const auto fit = process::fit_grinding(log.record, sheet);
  ASSERT_TRUE(fit.has_value()) << fit.error();
  EXPECT_FALSE(fit->verdict.is_refused()) << fit->verdict.reason;
  const process::GrindingProcess truth = hidden_machine();
  expect_near(fit->stiffness_n_per_m, truth.stiffness_n_per_m);
  expect_near(fit->force_factor, truth.force_factor);
  expect_near(fit->force_exponent, truth.force_exponent);
  EXPECT_NEAR(fit->idle_w.value, idle_w, 5.0);
  EXPECT_LT(fit->stiffness_n_per_m.half_width(), 0.15 * truth.stiffness_n_per_m);
  // The process file with the new figures is read again.
  std::ifstream text(sheet_file);
  const std::string old{std::istreambuf_iterator<char>(text), {}};
  const auto file = folder_.path() / "found.toml";
  std::ofstream(file) << with_figures(old, *fit);
  const process::GrindingProcess found = config::read_grinding_file(file).process;
  EXPECT_NEAR(found.stiffness_n_per_m, fit->stiffness_n_per_m.value, 1.0);
  EXPECT_NEAR(found.force_factor, fit->force_factor.value, 1e-4);
  EXPECT_NEAR(found.force_exponent, fit->force_exponent.value, 1e-4);
  EXPECT_EQ(found.part_radius_mm, 30.0);
  const IdentifiedPlunge identified =
      identify({.log = log_file(), .reading = request(), .sheet = sheet, .process_text = old});
  EXPECT_GT(identified.readings, 1500);
  EXPECT_EQ(identified.rows.size(), log.record.rows.size());
  EXPECT_EQ(identified.text, with_figures(old, *fit));
  EXPECT_EQ(identification_fields(identified).front().name, "stiffness_n_per_m");
  EXPECT_EQ(identification_fields(identified).back().name, "fit");

  // What it lacks it says.
  const auto fault = [&](const GrindLogRequest& asked) {
    try {
      static_cast<void>(read_grind_log(log_file(), asked));
    } catch (const std::runtime_error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  GrindLogRequest other = request();
  other.spindle = 0;
  EXPECT_THAT(fault(other), ::testing::HasSubstr("no power of spindle 1"));
  other = request();
  other.channel = 3;
  EXPECT_THAT(fault(other), ::testing::HasSubstr("no setpoints of channel 3"));
  other = request();
  other.touch_mm = -4.0;
  EXPECT_THAT(fault(other), ::testing::HasSubstr("--touch"));
}

}  // namespace
}  // namespace stanok::jobs
