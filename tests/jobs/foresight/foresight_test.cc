// What is known of a program before it runs.
#include "jobs/foresight/foresight.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <fstream>
#include <future>
#include <mutex>
#include <set>
#include <thread>

#include "runtime/thread_time.h"
#include "tests/support/project_folders.h"
#include "tests/support/sanitized.h"
#include "tests/support/temporary_directory.h"

namespace stanok::jobs {
namespace {

TEST(Timeline, KnowsWhenABlockBegins) {
  Timeline timeline;
  timeline.add(1, 1, 0.0);
  timeline.add(1, 1, 0.9);
  timeline.add(1, 2, 1.0);
  timeline.add(1, 5, 3.0);
  timeline.add(2, 1, 4.0);
  timeline.add(2, 1, 6.0);
  EXPECT_EQ(timeline.at(1, 1), 0.0);
  EXPECT_EQ(timeline.at(1, 2), 1.0);
  EXPECT_EQ(timeline.at(1, 4), 1.0) << "of the block before it";
  EXPECT_EQ(timeline.at(1, 9), 3.0);
  EXPECT_EQ(timeline.at(2, 1), 4.0);
  EXPECT_EQ(timeline.at(3, 1), std::nullopt);
  EXPECT_EQ(timeline.end_of(1), 3.0);
  EXPECT_EQ(timeline.end_of(2), 6.0);
}

// A million blocks in a bounded memory, to a thousandth of the whole.
TEST(Timeline, StaysSmallAndTrue) {
  Timeline timeline;
  for (int block = 1; block <= 1'000'000; ++block)
    timeline.add(1, static_cast<std::uint64_t>(block), 0.01 * block);
  for (const int block : {1000, 250'000, 999'000})
    EXPECT_NEAR(*timeline.at(1, static_cast<std::uint64_t>(block)), 0.01 * block, 10.0);
}

class ForesightTest : public ::testing::Test {
 protected:
  void write(const std::string& name, const std::string& text) {
    std::ofstream(folder.path() / name) << text;
  }
  Outlook wait_for_prediction(int channel = 1) {
    constexpr int looks_max = 18'000;  // three minutes: it is a thread for an idle computer
    for (int n = 0; n < looks_max; ++n) {
      const Outlook outlook = foresight.outlook(channel, now);
      if (outlook.predicted_s) return outlook;
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    ADD_FAILURE() << "nothing is foreseen";
    return {};
  }
  channels::ChannelOutput& output(int index) {
    return now.channels[static_cast<std::size_t>(index)];
  }

  stanok::testing::TemporaryDirectory folder;
  config::MachineFile file =
      config::read_machine_file(stanok::testing::source_folder() + "/config/machines/mill3.toml");
  std::mutex mutex;
  std::vector<recording::PathPreview> paths;
  Foresight foresight{file,
                      {folder.path()},
                      [this](recording::PathPreview path) {
                        const std::lock_guard lock(mutex);
                        paths.push_back(std::move(path));
                      },
                      [](const std::string& obstacle) { ADD_FAILURE() << obstacle; }};
  channels::CycleOutput now = [this] {
    channels::CycleOutput output;
    output.channel_count = static_cast<int>(file.machine.channels.size());
    for (std::size_t k = 0; k < file.machine.channels.size(); ++k) {
      output.channels[k].id = file.machine.channels[k].id;
      output.channels[k].scheme = file.machine.channels[k].scheme;
    }
    return output;
  }();
};

TEST_F(ForesightTest, PredictsTheTimeOfAProgramAndWhatIsLeftOfIt) {
  write("a.nc", "G4 P1\nG4 P2\nG4 P3\nM30\n");
  foresight.look_at(1, "a.nc", now, file.machine.tables);
  EXPECT_NEAR(*wait_for_prediction().predicted_s, 6.0, 0.1);
  EXPECT_FALSE(foresight.outlook(1, now).remaining_s) << "it does not run yet";
  foresight.begins(1, {{1, 7}});
  output(0).running = true;
  output(0).run = 8;
  for (const auto& [block, left] : std::map<std::uint64_t, double>{{1, 6.0}, {2, 5.0}, {3, 3.0}}) {
    output(0).tag.block = block;
    EXPECT_NEAR(foresight.outlook(1, now).remaining_s.value_or(-1.0), left, 0.1) << block;
  }
}

TEST_F(ForesightTest, TellsTheAlarmThatAProgramWouldRaise) {
  write("far.nc", "G0 X1\nG0 X100000\nM30\n");
  foresight.look_at(1, "far.nc", now, file.machine.tables);
  const auto foreseen = wait_for_prediction().foreseen;
  ASSERT_TRUE(foreseen);
  EXPECT_EQ(foreseen->diagnostic.code, "E5101");
  EXPECT_EQ(foreseen->diagnostic.place.line, 2);
}

TEST_F(ForesightTest, HandsOnThePathOfTheTip) {
  write("round.nc", "G21 G90 G17 G54\nG0 X20 Y0 Z5\nG1 Z0 F1000\nG2 I-20\nM30\n");
  foresight.look_at(1, "round.nc", now, file.machine.tables);
  static_cast<void>(wait_for_prediction());
  const std::lock_guard lock(mutex);
  ASSERT_EQ(paths.size(), 1U);
  EXPECT_EQ(paths[0].channel, 1);
  EXPECT_EQ(paths[0].program, "round.nc");
  double greatest_y = 0.0;
  double smallest_x = 0.0;
  for (const recording::PreviewPoint& one : paths[0].points) {
    if (one.rapid) continue;
    EXPECT_NEAR(std::hypot(one.point[0], one.point[1]), 20.0, 1e-5);
    greatest_y = std::max(greatest_y, one.point[1]);
    smallest_x = std::min(smallest_x, one.point[0]);
  }
  EXPECT_NEAR(greatest_y, 20.0, 0.02);
  EXPECT_NEAR(smallest_x, -20.0, 0.02);
}

TEST_F(ForesightTest, KnowsThePathWithTheLinesThatLeadAlongIt) {
  write("round.nc", "G21 G90 G17 G54\nG0 X20 Y0 Z5\nG1 Z0 F1000\nG2 I-20\nG0 Z5\nM30\n");
  EXPECT_EQ(foresight.planned_path(1), nullptr);
  foresight.look_at(1, "round.nc", now, file.machine.tables);
  static_cast<void>(wait_for_prediction());
  const auto path = foresight.planned_path(1);
  ASSERT_NE(path, nullptr);
  EXPECT_EQ(path->program(), "round.nc");
  EXPECT_TRUE(path->state().is_complete);
  ASSERT_EQ(path->state().pages, 1U);
  const auto page = path->page(0);
  EXPECT_EQ(path->page(1), nullptr);
  ASSERT_EQ(path->state().points, page->points.size());
  EXPECT_TRUE(page->points.front().begins);
  std::uint32_t line = 2;
  for (std::size_t k = 1; k < page->points.size(); ++k) {
    const PathPage::Point& a = page->points[k - 1];
    const PathPage::Point& b = page->points[k];
    EXPECT_FALSE(b.begins) << k;
    EXPECT_GE(b.line, line) << k;
    line = b.line;
    EXPECT_EQ(b.rapid, b.line == 2 || b.line == 5) << k;
    if (b.line != 4) continue;
    EXPECT_NEAR(std::hypot(b.place_mm[0], b.place_mm[1]), 20.0, 1e-4);
    // The circle is furthest away from the chord at its middle.
    const double middle =
        0.5 * std::hypot(a.place_mm[0] + b.place_mm[0], a.place_mm[1] + b.place_mm[1]);
    EXPECT_NEAR(middle, 20.0, 0.011) << k;
  }
  EXPECT_EQ(line, 5U);
  EXPECT_NEAR(page->points.back().place_mm[2], 5.0, 1e-5);
}

// No line leads from where the tip is in one work offset to the same place in another one.
TEST_F(ForesightTest, APathBeginsAnewInAnotherWorkOffset) {
  write("two.nc", "G21 G90 G17 G54\nG1 X10 F1000\nG10 L2 P2 X5 Y0 Z0\nG55\nG1 X20 F500\nM30\n");
  foresight.look_at(1, "two.nc", now, file.machine.tables);
  static_cast<void>(wait_for_prediction());
  const auto page = foresight.planned_path(1)->page(0);
  ASSERT_EQ(page->points.size(), 4U);
  std::vector<double> x;
  std::vector<double> feeds;
  std::vector<bool> begins;
  for (const PathPage::Point& point : page->points) {
    x.push_back(point.place_mm[0]);
    feeds.push_back(point.feed_mm_per_min);
    begins.push_back(point.begins);
  }
  EXPECT_THAT(x, ::testing::Pointwise(::testing::DoubleNear(0.001), {0.0, 10.0, 5.0, 20.0}));
  EXPECT_THAT(feeds,
              ::testing::Pointwise(::testing::DoubleNear(0.01), {1000.0, 1000.0, 500.0, 500.0}));
  EXPECT_THAT(begins, ::testing::ElementsAre(true, false, true, false));
}

// Where an arc leads is told; a corner that is rounded within a tolerance is none.
TEST_F(ForesightTest, KnowsWhichPiecesAreArcs) {
  write("round.nc",
        "G21 G90 G17 G54 G64 P0.1\nG1 X20 F1000\nG1 Y20\nG2 X40 Y0 I0 J-20\nG1 X60\nM30\n");
  foresight.look_at(1, "round.nc", now, file.machine.tables);
  static_cast<void>(wait_for_prediction());
  const auto page = foresight.planned_path(1)->page(0);
  std::set<std::uint32_t> arcs;
  std::set<std::uint32_t> lines;
  for (const PathPage::Point& point : page->points) (point.arc ? arcs : lines).insert(point.line);
  EXPECT_THAT(arcs, ::testing::ElementsAre(4U));
  EXPECT_THAT(lines, ::testing::IsSupersetOf({2U, 3U, 5U}));
}

TEST_F(ForesightTest, ForgetsWhatANewProgramReplaces) {
  write("a.nc", "while (1 > 0) {\n  G4 P0.001\n}\nM30\n");
  write("b.nc", "G4 P2\nM30\n");
  foresight.look_at(1, "a.nc", now, file.machine.tables);
  const auto first = foresight.planned_path(1);
  foresight.look_at(1, "b.nc", now, file.machine.tables);
  EXPECT_NEAR(*wait_for_prediction().predicted_s, 2.0, 0.1);
  EXPECT_NE(foresight.planned_path(1)->id(), first->id());
}

TEST_F(ForesightTest, APathWithoutMotionIsCompleteAndEmpty) {
  write("rests.nc", "G4 P1\nM30\n");
  foresight.look_at(1, "rests.nc", now, file.machine.tables);
  EXPECT_EQ(foresight.planned_path(1)->program(), "rests.nc");
  static_cast<void>(wait_for_prediction());
  EXPECT_TRUE(foresight.planned_path(1)->state().is_complete);
  EXPECT_EQ(foresight.planned_path(1)->state().points, 0U);
}

GivenUp wait_until_given_up(const Foresight& foresight) {
  constexpr int looks_max = 18'000;
  for (int n = 0; n < looks_max; ++n) {
    const auto state = foresight.planned_path(1)->state();
    if (state.given_up != GivenUp::no || state.is_complete) return state.given_up;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return GivenUp::no;
}

TEST_F(ForesightTest, SaysWhyAPathDoesNotLeadToTheEnd) {
  write("endless.nc", "while (1 > 0) {\n  G1 X1 F60000\n  X0\n}\nM30\n");
  write("wrong.nc", "G1 X1 Q5 F1000\nM30\n");
  Foresight hasty{file,
                  {folder.path()},
                  [](const recording::PathPreview&) {},
                  [](const std::string& obstacle) { ADD_FAILURE() << obstacle; },
                  std::chrono::milliseconds(stanok::testing::is_sanitized ? 5000 : 500)};
  hasty.look_at(1, "endless.nc", now, file.machine.tables);
  EXPECT_EQ(wait_until_given_up(hasty), GivenUp::computing_time);
  EXPECT_GT(hasty.planned_path(1)->state().points, 0U) << "what there was is kept";
  hasty.look_at(1, "wrong.nc", now, file.machine.tables);
  EXPECT_EQ(wait_until_given_up(hasty), GivenUp::refused);
}

// A computer that is busy with other things takes no path away.
TEST(ProcessorTime, DoesNotCountWhileTheThreadWaits) {
  const auto before = runtime::processor_time_of_thread();
  std::this_thread::sleep_for(std::chrono::milliseconds(200));
  EXPECT_LT(runtime::processor_time_of_thread() - before, std::chrono::milliseconds(50));
  while (runtime::processor_time_of_thread() - before < std::chrono::milliseconds(60)) continue;
}

TEST(PlannedPath, SaysThatItHasTooManyPointsAndKeepsTheFirst) {
  PlannedPath path(1, "long.nc");
  for (std::size_t n = 0; n < PlannedPath::points_max + PlannedPath::page_points; ++n) path.add({});
  path.complete();
  EXPECT_EQ(path.state().given_up, GivenUp::points);
  EXPECT_FALSE(path.state().is_complete);
  EXPECT_GE(path.state().points, PlannedPath::points_max);
}

// Neither moves nor ends: the simulation never comes to a cycle.
TEST_F(ForesightTest, EndsInAnEndlessLoopWithoutMotion) {
  write("endless.nc", "while (1 > 0) {\n}\nM30\n");
  foresight.look_at(1, "endless.nc", now, file.machine.tables);
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  write("b.nc", "G4 P2\nM30\n");
  foresight.look_at(1, "b.nc", now, file.machine.tables);
  EXPECT_NEAR(*wait_for_prediction().predicted_s, 2.0, 0.1);
}

// As when memory ends: the daemon lives, and looks at the next program.
TEST_F(ForesightTest, LivesOnAfterAnyExceptionAndTellsOfIt) {
  std::atomic<bool> throws = true;
  std::promise<std::string> told;
  Foresight faulty{file,
                   {folder.path()},
                   [&](const recording::PathPreview& path) {
                     static_cast<void>(path);
                     if (throws.exchange(false)) throw 42;
                   },
                   [&](const std::string& obstacle) { told.set_value(obstacle); }};
  write("a.nc", "G1 X1 F1000\nM30\n");
  faulty.look_at(1, "a.nc", now, file.machine.tables);
  EXPECT_EQ(told.get_future().get(), "a.nc cannot be simulated beforehand");
  EXPECT_FALSE(faulty.outlook(1, now).predicted_s);
  faulty.look_at(1, "a.nc", now, file.machine.tables);
  while (!faulty.outlook(1, now).predicted_s)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

TEST_F(ForesightTest, EndsAtOnceInTheMiddleOfASimulation) {
  write("endless.nc", "while (1 > 0) {\n  G4 P0.001\n}\nM30\n");
  foresight.look_at(1, "endless.nc", now, file.machine.tables);
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
}

}  // namespace
}  // namespace stanok::jobs
