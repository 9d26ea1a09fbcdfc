// Feeds that keep a force, by the formula; their words in a program; the program on the virtual
// part.
#include "client/offline/process/feed_plan.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "channels/contract/output.h"
#include "client/offline/process/force_forecast.h"
#include "client/offline/process/program_feeds.h"
#include "runtime/simulation.h"
#include "tests/support/project_folders.h"
#include "tests/support/temporary_directory.h"

namespace stanok::client {
namespace {

const std::string lathe_file = stanok::testing::source_folder() + "/config/machines/lathe.toml";
const std::string steps_program =
    stanok::testing::source_folder() + "/programs/examples/adaptive_steps.nc";

// 1600 t h^0.75 = 1200 N: h = (1200 / (1600 t))^(4/3).
TEST(FeedPlan, IsTheFormulaAndFallsATurnAhead) {
  std::vector<CutPlace> places;
  for (int k = 0; k < 2000; ++k) {
    const double way = 0.02 * k;
    places.push_back({.way_mm = way, .depth_mm = way < 20.0 ? 2.0 : way < 30.0 ? 3.0 : 1.0});
  }
  const auto plan = plan_feeds(places, {.coefficient_n = 1600.0, .exponent = 0.75}, 1200.0,
                               {.min = 0.01, .max = 0.5});
  ASSERT_EQ(plan.size(), 3U);
  const double shallow = std::pow(1200.0 / 3200.0, 4.0 / 3.0);
  const double deep = std::pow(1200.0 / 4800.0, 4.0 / 3.0);
  EXPECT_NEAR(plan[0].feed_per_rev, shallow, 0.001);
  EXPECT_LE(plan[0].feed_per_rev, shallow);
  EXPECT_NEAR(plan[1].feed_per_rev, deep, 0.001);
  EXPECT_NEAR(plan[1].begin_mm, 20.0 - deep, 0.03);
  EXPECT_LE(plan[1].begin_mm, 20.0 - plan[1].feed_per_rev + 1e-9);
  EXPECT_EQ(plan[2].feed_per_rev, 0.5) << "the greatest";
  EXPECT_NEAR(plan[2].begin_mm, 30.0, 0.021);
}

TEST(ProgramFeeds, DivideABlockAndReplaceItsF) {
  const std::string text = "N10 G1 X10 F0.3 (cut)\n#adaptive (off)\nN20 Z-40 // on\nM30\n";
  EXPECT_EQ(with_feeds(text, {{1, {{"", "F0.2"}}}, {3, {{"Z-10.0000", "F0.25"}, {"", "F0.157"}}}}),
            "N10 G1 X10 F0.2 (cut)\n// #adaptive (off)\nG1 Z-10.0000 F0.25\nN20 Z-40 F0.157 // on\n"
            "M30\n");
}

// Greatest and mean force of the simulated cut, where the chip is whole.
struct ForceObserver final : public runtime::CycleObserver {
  void observe(const channels::CycleOutput& output) override {
    const channels::ChannelOutput& channel = output.channels[0];
    if (!channel.running || channel.feed_commanded <= 0.0) return;
    ++cycles;
    const double z = channel.point_W[1].value;
    const double speed = channel.process.spindle_rev_per_min / 60.0;
    if (z < -1.0 && z > -99.0) feeds.emplace_back(z, channel.path_speed / speed);
  }
  int cycles = 0;
  std::vector<std::pair<double, double>> feeds;  // z, mm per turn
};

// The bar of lathe.toml: depth 2, 3, 2 mm, then 260 and 170 HB, 20 mm each. The force at each place
// is worked out here from the feed of the simulated run, as its mean over the turn before.
TEST(Optimise, KeepsTheForceOnTheVirtualPartWithinFivePercent) {
  ForecastRequest request;
  request.program = steps_program;
  request.force_n = 1200.0;
  request.feed_min = 0.05;
  request.feed_max = 0.6;
  request.job.machine_file = lathe_file;
  const ForceForecast forecast = forecast_forces(request);
  std::ifstream file(steps_program);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  const stanok::testing::TemporaryDirectory folder;
  std::ofstream(folder.path() / "part.nc") << with_feeds(text, forecast.lines);
  runtime::SimulationOptions options;
  options.file = config::read_machine_file(lathe_file);
  options.program_roots = {folder.path()};
  options.programs = {{.channel = 1, .program = "part.nc"}};
  ForceObserver observer;
  ASSERT_TRUE(runtime::simulate(options, {&observer}, [] { return false; }).ok);
  ASSERT_GT(observer.feeds.size(), 1000U);
  double most = 0.0;
  double sum = 0.0;
  int inside = 0;
  for (std::size_t k = 150; k < observer.feeds.size(); ++k) {
    const double z = observer.feeds[k].first;
    double mean = 0.0;
    for (std::size_t n = k - 100; n < k; ++n) mean += observer.feeds[n].second / 100.0;
    const double depth = z > -20.0 ? 2.0 : z > -40.0 ? 3.0 : 2.0;
    const double hardness = z > -60.0 ? 200.0 : z > -80.0 ? 260.0 : 170.0;
    const double force = 1600.0 * depth * std::pow(mean, 0.75) * std::pow(hardness / 200.0, 0.75);
    most = std::max(most, force);
    sum += force;
    if (std::abs(force / 1200.0 - 1.0) < 0.05) ++inside;
  }
  const auto count = static_cast<double>(observer.feeds.size() - 150);
  EXPECT_LE(most, 1.05 * 1200.0);
  // A turn in front of and behind each of four steps is all that lies below.
  EXPECT_GE(inside / count, 0.96);
  EXPECT_NEAR(sum / count, 1200.0, 0.03 * 1200.0);
  // As fast as the control that knew nothing of the part.
  EXPECT_LE(observer.cycles * 0.001, 1.03 * forecast.time_s + 0.5);
  RecordProperty("time_s", std::to_string(observer.cycles * 0.001));
  RecordProperty("force_most", std::to_string(most));
}

}  // namespace
}  // namespace stanok::client
