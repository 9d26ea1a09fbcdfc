// Feeds that keep a force, by the formula; their words in a program; the program on the virtual
// part.
#include "jobs/cutting/feed_plan.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "channels/contract/output.h"
#include "client/offline/process/forecast_job.h"
#include "jobs/cutting/force_forecast.h"
#include "jobs/cutting/program_feeds.h"
#include "runtime/simulation.h"
#include "tests/support/project_folders.h"
#include "tests/support/temporary_directory.h"

namespace stanok::client {
namespace {

using jobs::CutPlace;
using jobs::ForceForecast;
using jobs::ForecastRequest;
using jobs::plan_feeds;
using jobs::with_feeds;

const std::string lathe_file = stanok::testing::source_folder() + "/config/machines/lathe.toml";
const std::string steps_program =
    stanok::testing::source_folder() + "/programs/examples/adaptive_steps.nc";

// 1600 t h^0.75 = 1200 N: h = (1200 / (1600 t))^(4/3).
TEST(FeedPlan, IsTheFormulaAndFallsATurnAhead) {
  std::vector<CutPlace> places;
  for (int k = 0; k < 2000; ++k) {
    const double way = 0.02 * k;
    places.push_back({.distance_mm = way, .depth_mm = way < 20.0 ? 2.0 : way < 30.0 ? 3.0 : 1.0});
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

// What a program does on the bar of lathe.toml: depth 2, 3, 2 mm, then 260 and 170 HB, 20 mm of
// each. The force at each place is worked out here from the feed of the simulated run, as its mean
// over the turn before.
class CutBar final : public runtime::CycleObserver {
 public:
  explicit CutBar(const std::string& text) {
    const stanok::testing::TemporaryDirectory folder;
    std::ofstream(folder.path() / "part.nc") << text;
    runtime::SimulationOptions options;
    options.file = config::read_machine_file(lathe_file);
    options.program_roots = {folder.path()};
    options.programs = {{.channel = 1, .program = "part.nc"}};
    EXPECT_TRUE(runtime::simulate(options, {this}, [] { return false; }).ok);
    EXPECT_GT(feeds_.size(), 1000U);
    double sum = 0.0;
    int near = 0;
    for (std::size_t k = 150; k < feeds_.size(); ++k) {
      const double force = force_n(k);
      force_most_n = std::max(force_most_n, force);
      sum += force;
      if (std::abs(force / 1200.0 - 1.0) < 0.05) ++near;
    }
    const auto count = static_cast<double>(feeds_.size() - 150);
    force_mean_n = sum / count;
    inside = near / count;
  }

  void observe(const channels::CycleOutput& output) override {
    const channels::ChannelOutput& channel = output.channels[0];
    if (!channel.running || channel.feed_commanded <= 0.0) return;
    time_s += 0.001;
    const double z = channel.point_W[1].value;
    const double speed = channel.process.spindle_rev_per_min / 60.0;
    if (z < -1.0 && z > -99.0) feeds_.emplace_back(z, channel.path_speed / speed);
  }

  double time_s = 0.0;  // at feed
  double force_most_n = 0.0;
  double force_mean_n = 0.0;
  double inside = 0.0;  // part of the time within 5 % of 1200 N

 private:
  [[nodiscard]] double force_n(std::size_t k) const {
    const double z = feeds_[k].first;
    double mean = 0.0;
    for (std::size_t n = k - 100; n < k; ++n) mean += feeds_[n].second / 100.0;
    const double depth = z > -20.0 ? 2.0 : z > -40.0 ? 3.0 : 2.0;
    const double hardness = z > -60.0 ? 200.0 : z > -80.0 ? 260.0 : 170.0;
    return 1600.0 * depth * std::pow(mean, 0.75) * std::pow(hardness / 200.0, 0.75);
  }

  std::vector<std::pair<double, double>> feeds_;  // z, mm per turn
};

std::string text_of(const std::string& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

ForceForecast forecast_at_1200_n() {
  ForecastRequest request;
  JobOptions job;
  job.machine_file = lathe_file;
  request.job = forecast_job(steps_program, job);
  request.force_n = 1200.0;
  request.feed_min = 0.05;
  request.feed_max = 0.6;
  return forecast_forces(request);
}

TEST(Optimise, KeepsTheForceOnTheVirtualPartWithinFivePercent) {
  const ForceForecast forecast = forecast_at_1200_n();
  const CutBar cut(with_feeds(text_of(steps_program), forecast.lines));
  EXPECT_LE(cut.force_most_n, 1.05 * 1200.0);
  // A turn in front of and behind each of four steps is all that lies below.
  EXPECT_GE(cut.inside, 0.96);
  EXPECT_NEAR(cut.force_mean_n, 1200.0, 0.03 * 1200.0);
  EXPECT_LE(cut.time_s, 1.03 * forecast.time_s + 0.5);
}

// Beside adaptive control, which knows nothing of the part, on the same part: as fast, and without
// the force that a step of depth brings before the control answers.
TEST(Optimise, DoesOnTheSamePartWhatAdaptiveControlDoes) {
  const CutBar planned(with_feeds(text_of(steps_program), forecast_at_1200_n().lines));
  const CutBar adaptive(text_of(steps_program));
  for (const auto& [name, cut] :
       {std::pair("planned", &planned), std::pair("adaptive", &adaptive)}) {
    RecordProperty(std::string(name) + "_s", std::to_string(cut->time_s));
    RecordProperty(std::string(name) + "_most", std::to_string(cut->force_most_n));
    RecordProperty(std::string(name) + "_inside", std::to_string(cut->inside));
  }
  EXPECT_LE(planned.time_s, 1.01 * adaptive.time_s);
  EXPECT_NEAR(adaptive.force_mean_n, planned.force_mean_n, 0.02 * 1200.0);
  EXPECT_GT(adaptive.force_most_n, 1.2 * 1200.0) << "until it answers a step from 2 to 3 mm";
  EXPECT_GT(planned.inside, adaptive.inside);
}

}  // namespace
}  // namespace stanok::client
