// Forces along a milling program on its virtual workpiece, at cuts whose engagement is known.
#include "jobs/cutting/milling_forecast.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>
#include <tuple>

#include "client/offline/process/forecast_job.h"
#include "client/offline/process/milling_report.h"
#include "jobs/cutting/cut_columns.h"
#include "jobs/cutting/program_text.h"
#include "tests/support/project_folders.h"
#include "tests/support/temporary_directory.h"

namespace stanok::client {
namespace {

using jobs::MillingForecast;
using jobs::MillingPlace;
using jobs::MillingRequest;
using jobs::ProgramText;
using jobs::with_feeds;

constexpr double pi = std::numbers::pi;
const std::string machine_file =
    stanok::testing::source_folder() + "/config/machines/e7106mf4.toml";

// Tool 3 of e7106mf4: end mill of 6 mm. A slot of 2 mm; then 3 mm of width upwards, and downwards;
// then 1 mm deep across the bottom of the slot, which is air but for a wall.
constexpr const char* program_text =
    "G21 G90 G17 G40 G49 G80 G54 G94\n"
    "#workpiece (0, 0.15, 0, 60, 40, 10, 0, 0, 10)\n"
    "T3 M6\n"
    "S6000 M3\n"
    "G0 X-6 Y10\n"
    "G43 H3 Z50\n"
    "G0 Z2\n"
    "G1 Z-2 F300\n"
    "G1 X50 F600\n"  // 9: slot
    "G0 Z2\n"
    "G0 X-6 Y13\n"
    "G1 Z-2 F300\n"
    "G1 X50 F600\n"  // 13: up, 3 mm
    "G0 Z2\n"
    "G0 X66 Y16\n"
    "G1 Z-2 F300\n"
    "G1 X50 F600\n"  // 17: into the wall
    "G1 X-6 F900\n"  // 18: down, 3 mm
    "G0 Z50\n"
    "G49 M5\n"
    "M30\n";

process::CuttingProcess end_mill() {
  process::CuttingProcess cut;
  cut.force_n_per_mm2 = 1800.0;
  cut.radial_ratio = 0.35;
  cut.teeth = 3;
  cut.edge_n_per_mm = 10.0;
  cut.edge_radial_n_per_mm = 15.0;
  cut.modes_x =
      cut.modes_y = {{.frequency_hz = 900.0, .damping = 0.03, .stiffness_n_per_mm = 8000.0}};
  return cut;
}

struct Program {
  explicit Program(const std::string& text) {
    std::ofstream(file()) << text;
    JobOptions job;
    job.machine_file = machine_file;
    request.job = forecast_job(file(), job);
    request.cut = end_mill();
  }
  [[nodiscard]] std::string file() const { return folder.path() / "part.nc"; }

  stanok::testing::TemporaryDirectory folder;
  MillingRequest request;
};

// Resultant of three straight teeth between two angles, at its greatest; mean power without edges.
double peak_n(double from, double to, double feed_per_tooth, double depth_mm) {
  const process::CuttingProcess cut = end_mill();
  double most = 0.0;
  for (int n = 0; n < 1200; ++n) {
    double x = 0.0;
    double y = 0.0;
    for (int tooth = 0; tooth < 3; ++tooth) {
      const double angle = 2.0 * pi / 3.0 * (tooth + n / 1200.0);
      if (angle < from || angle > to) continue;
      const double chip = feed_per_tooth * std::sin(angle);
      const double t = depth_mm * (cut.force_n_per_mm2 * chip + cut.edge_n_per_mm);
      const double r =
          depth_mm * (cut.radial_ratio * cut.force_n_per_mm2 * chip + cut.edge_radial_n_per_mm);
      x -= t * std::cos(angle) + r * std::sin(angle);
      y += t * std::sin(angle) - r * std::cos(angle);
    }
    most = std::max(most, std::hypot(x, y));
  }
  return most;
}

// K_t times volume, and K_te times the way of the edges that are in the cut.
double power_w(double width_mm, double arc_rad, double feed_per_min) {
  const process::CuttingProcess cut = end_mill();
  const double volume = width_mm * 2.0 * feed_per_min / 60.0;
  const double edges =
      3.0 * arc_rad / (2.0 * pi) * 2.0 * cut.edge_n_per_mm * 2.0 * pi * 3.0 * 100.0;
  return (cut.force_n_per_mm2 * volume + edges) * 1e-3;
}

std::vector<MillingPlace> inside(const MillingForecast& forecast, std::uint32_t line, double x_from,
                                 double x_to) {
  std::vector<MillingPlace> places;
  for (const MillingPlace& place : forecast.places) {
    if (place.line == line && place.x_mm > x_from && place.x_mm < x_to) places.push_back(place);
  }
  return places;
}

TEST(MillingForecast, TellsForceAndPowerOfKnownCuts) {
  const Program program(program_text);
  const MillingForecast forecast = forecast_milling(program.request);
  struct Cut {
    const char* name;
    std::uint32_t line;
    double from;
    double to;
    double width_mm;
    double feed_per_min;
  };
  for (const Cut& cut :
       {Cut{"slot", 9, 0.0, pi, 6.0, 600.0}, Cut{"up", 13, 0.0, pi / 2.0, 3.0, 600.0},
        Cut{"down", 18, pi / 2.0, pi, 3.0, 900.0}}) {
    const auto places = inside(forecast, cut.line, 8.0, 42.0);
    ASSERT_GT(places.size(), 50U) << cut.name;
    const double feed = cut.feed_per_min / 6000.0 / 3.0;
    const double peak = peak_n(cut.from, cut.to, feed, 2.0);
    const double power = power_w(cut.width_mm, cut.to - cut.from, cut.feed_per_min);
    double mean_power = 0.0;
    for (const MillingPlace& place : places) {
      EXPECT_NEAR(place.force_peak_n, peak, 0.05 * peak) << cut.name << " at " << place.x_mm;
      EXPECT_NEAR(place.area_mm2, 2.0 * cut.width_mm, 0.05 * 2.0 * cut.width_mm) << cut.name;
      mean_power += place.power_w / static_cast<double>(places.size());
    }
    EXPECT_NEAR(mean_power, power, 0.03 * power) << cut.name;
    EXPECT_NEAR(places.front().deflection_um, places.front().force_peak_n / 8.0, 1e-6);
    EXPECT_NEAR(places.front().feed_programmed, cut.feed_per_min, 1e-6);
    EXPECT_NEAR(places.front().rev_per_min, 6000.0, 1e-6);
  }
}

// The planned program runs: no force above the set value, and each block that cuts comes to it.
TEST(MillingForecast, APlannedProgramKeepsTheForceWithinFivePercent) {
  Program program(program_text);
  constexpr double set_n = 160.0;
  program.request.force_n = set_n;
  program.request.feed_min = 0.01;
  program.request.feed_max = 0.5;
  const MillingForecast planned = forecast_milling(program.request);
  std::ifstream text(program.file());
  const std::string before{std::istreambuf_iterator<char>(text), {}};
  Program after(with_feeds(before, planned.lines));
  const MillingForecast run = forecast_milling(after.request);
  for (const std::uint32_t line : {9U, 13U, 17U, 18U}) {
    double most = 0.0;
    for (const MillingPlace& place : run.places)
      if (place.line == line) most = std::max(most, place.force_peak_n);
    EXPECT_NEAR(most, set_n, 0.05 * set_n) << line;
  }
  // In the middle of each cut the closed form has it as well.
  for (const auto& [line, from, to] :
       {std::tuple(9U, 0.0, pi), std::tuple(13U, 0.0, pi / 2.0), std::tuple(18U, pi / 2.0, pi)}) {
    const auto places = inside(run, line, 8.0, 42.0);
    ASSERT_FALSE(places.empty());
    const double feed = places.front().feed_programmed / 6000.0 / 3.0;
    EXPECT_LE(peak_n(from, to, feed, 2.0), 1.05 * set_n) << line;
    EXPECT_GE(peak_n(from, to, feed, 2.0), 0.9 * set_n) << line;
  }
}

TEST(MillingForecast, SaysWhyItCannot) {
  const auto fault = [](const std::string& text, double force_n) {
    Program program(text);
    program.request.force_n = force_n;
    try {
      static_cast<void>(forecast_milling(program.request));
    } catch (const std::runtime_error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_THAT(fault("G21 G90 G54 G94\nT3 M6\nS6000 M3\nG1 X10 F600\nM5\nM30\n", 0.0),
              ::testing::HasSubstr("#workpiece"));
  EXPECT_THAT(fault("G95\nG94\n" + std::string(program_text), 100.0),
              ::testing::HasSubstr("line 1 has G95"));
}

TEST(ProgramText, KnowsWordsAndFeeds) {
  EXPECT_TRUE(ProgramText::has_word("N10 G95 G1", "G95"));
  EXPECT_TRUE(ProgramText::has_word("g95", "G95"));
  EXPECT_FALSE(ProgramText::has_word("G1 (G95)", "G95"));
  EXPECT_FALSE(ProgramText::has_word("G95.1", "G95"));
  EXPECT_FALSE(ProgramText::has_word("G951", "G95"));
  EXPECT_TRUE(ProgramText::has_feed_expression("G1 X1 F=speed"));
  EXPECT_FALSE(ProgramText::has_feed_expression("G1 X1 F300"));
  EXPECT_FALSE(ProgramText::has_feed_expression("G1 X1 F.5 // F=2"));
  EXPECT_FALSE(ProgramText::has_feed_expression("for (k = 0; k < 2; k = k + 1)"));
  EXPECT_EQ(ProgramText::value("Z-4.5", 'Z'), -4.5);
}

TEST(MillingReport, HasTextCsvJsonAndAPicture) {
  MillingForecast forecast;
  EXPECT_EQ(to_text(forecast), "nothing is cut at feed\n");
  forecast.places = {{.line = 5, .x_mm = 1.5, .force_peak_n = 210.0, .power_w = 300.0},
                     {.line = 6, .x_mm = 2.5, .force_peak_n = 120.0, .deflection_um = 9.0}};
  EXPECT_THAT(to_text(forecast), ::testing::HasSubstr("210.0 N at most, in line 5 at X1.500"));
  EXPECT_EQ(to_json(forecast).at("force_programmed_max_line"), 5);
  EXPECT_EQ(std::ranges::count(jobs::csv(forecast.places, jobs::milling_columns()), '\n'), 3);
  EXPECT_THAT(picture_script(forecast, "it's.svg"), ::testing::HasSubstr("it''s.svg"));
}

}  // namespace
}  // namespace stanok::client
